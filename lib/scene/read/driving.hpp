/// The motions and loads of a scene, which drive its bodies.
#pragma once
#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "scene/read/histories.hpp"
#include "scene/read/motions.hpp"
#include "time/step_control.hpp"

namespace ixos {

/// A prescribed displacement of a body, or a translation of an obstacle, that a history drives.
struct Motion {
  std::string path;          ///< of the condition or of the obstacle's list
  double start = 0;          ///< value at the initial time, which moves a body at once; 0 of an obstacle [L0]
  double start_jump = 0;     ///< jump of the velocity at the initial time; 0 of an obstacle [L0/T0]
  double velocity_jump = 0;  ///< largest jump of the velocity after the initial time [L0/T0]
  double jump_time = 0;      ///< of that jump [T0]
  double range = 0;          ///< largest less least value over the run [L0]
  double in_one_step = 0;    ///< its largest change in a fixed step [L0]
};

/// The directions in which a body is moved or loaded, seen from one obstacle: the sum of the motions of one node set,
/// or a load. Largest values over the run, all in one unit.
struct Pull {
  std::string path;    ///< of a condition
  double along = 0;    ///< in a direction in which the body can slide on the obstacle
  double away = 0;     ///< away from the obstacle
  double towards = 0;  ///< towards the obstacle
};

/// The motions and loads of one body, seen from one obstacle.
struct Drive {
  bool held = false;    ///< the displacement along the normal is prescribed somewhere on the body
  double approach = 0;  ///< way towards the obstacle that motions and initial velocities prescribe [L0]
  std::vector<Pull> pulls{};
};

/// The boundary and initial conditions and the grips of a scene, sampled at the ends of the steps.
class Driving {
 public:
  /// Samples the conditions of a validated scene, whose sets the mesh has: the first 1e5 fixed steps, or 1001 times of
  /// an adaptive run. `parts`: see connected_parts().
  Driving(const SceneNode& scene, const Histories& histories, const StepControlOptions& control, const Mesh& mesh,
          const std::vector<int>& parts);

  /// Adds an obstacle's translations to motions(). Its place and its velocity at the initial time are not counted: they
  /// jump no more than those of a body that flies towards it.
  void add_obstacle(const SceneNode& node, const MotionOptions& obstacle, const Histories& histories);

  const std::vector<Motion>& motions() const { return motions_; }
  bool has_loads() const { return !loads_.empty(); }
  /// Returns whether the initial velocity has a gradient, the program moves a body, or a grip turns or pulls one.
  bool moves() const { return moves_; }

  /// Returns the motions and loads of a connected part of the mesh (see connected_parts()) before an obstacle with that
  /// normal.
  Drive of_part(int part, const std::array<double, 3>& normal) const;

 private:
  using Point = std::array<double, 3>;
  using Axes = std::array<bool, 3>;
  /// A motion or a load.
  struct Action {
    std::string path;
    std::set<int> parts;
    std::vector<Point> values;  ///< parallel to the times, or one for all
  };

  void add_motion(const SceneNode& node, const std::string& components, const std::string& history,
                  const Histories& histories, const std::set<int>& parts);
  std::vector<TimeValue> sampled(const TimeFunction& function) const;
  Motion measured(const std::string& path, const std::vector<TimeValue>& samples) const;
  void add_grip(const SceneNode& node, const Histories& histories, const Mesh& mesh);
  void add_load(const SceneNode& node, const Histories& histories, const Mesh& mesh);
  std::set<int> parts_of(const SceneNode& node, const Mesh& mesh) const;
  Point velocity_of(int part) const;

  std::vector<double> times_;
  bool fixed_;  ///< the times are the ends of steps
  int dimension_;
  std::vector<int> part_of_node_;
  std::map<int, Point> velocities_;  ///< at the initial time, by part; of several in one part, the last one
  bool moves_ = false;
  std::vector<Motion> motions_;
  std::map<std::string, Action> ways_;  ///< by node set
  std::vector<Action> loads_;
  std::map<int, Axes> prescribed_, held_;  ///< by part: axes along which some node is driven or held; is held
};

}  // namespace ixos
