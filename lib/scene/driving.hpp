/// The motions and loads of a scene, which drive its bodies.
#pragma once
#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "scene/histories.hpp"
#include "time/step_control.hpp"

namespace ixos {

/// A prescribed displacement that a history drives.
struct Motion {
  std::string path;          ///< of the condition
  double start = 0;          ///< value at the initial time [L0]
  double velocity_jump = 0;  ///< largest jump of the velocity, at the start or later [L0/T0]
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

/// The boundary and initial conditions of a scene, sampled at the ends of the steps.
class Driving {
 public:
  /// Samples the conditions of a validated scene, whose sets the mesh has: the first 1e5 fixed steps, or 1001 times of
  /// an adaptive run. `parts`: see connected_parts().
  Driving(const SceneNode& scene, const Histories& histories, const StepControlOptions& control, const Mesh& mesh,
          const std::vector<int>& parts);

  const std::vector<Motion>& motions() const { return motions_; }
  bool has_loads() const { return !loads_.empty(); }
  bool moves() const { return moves_; }  ///< the initial velocity has a gradient, or the program moves a body

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

  void add_motion(const SceneNode& node, const Histories& histories, const Mesh& mesh);
  void add_load(const SceneNode& node, const Histories& histories, const Mesh& mesh);
  std::set<int> parts_of(const SceneNode& node, const Mesh& mesh) const;

  std::vector<double> times_;
  bool fixed_;  ///< the times are the ends of steps
  std::vector<int> part_of_node_;
  Point velocity_{};
  bool moves_ = false;
  std::vector<Motion> motions_;
  std::map<std::string, Action> ways_;  ///< by node set
  std::vector<Action> loads_;
  std::map<int, Axes> prescribed_, held_;  ///< by part: axes along which some node is driven or held; is held
};

}  // namespace ixos
