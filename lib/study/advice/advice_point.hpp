/// Settings that an advice considers, and what their runs gave.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "study/advice/advice_directions.hpp"
#include "study/advice/strain_measure.hpp"
#include "study/common/column_history.hpp"

namespace ixos {

/// A place in a direction.
struct AdvicePlace {
  std::size_t branch = 0, level = 0;
  bool operator==(const AdvicePlace& other) const { return branch == other.branch && level == other.level; }
};

/// A complete choice of settings: a place in each direction.
using AdvicePoint = std::vector<AdvicePlace>;

/// The columns of a run beside those of the scene's own model, with everything but a direction the same.
struct AdviceComparison {
  std::size_t direction = 0;
  std::vector<double> differences{};  ///< by quantity, see column_difference()
};

/// A run that an advice carried out.
struct AdviceSample {
  AdvicePoint point;
  bool reached_end = false;     ///< whether the run ended as it should
  bool good = false;            ///< whether it did, or failed after the times that decide the quantities, and has them
  bool failed_later = false;    ///< whether it failed after those times
  std::string reason;           ///< why it failed, or is not good
  std::vector<double> values;   ///< of the quantities, in their order
  bool refused = false;         ///< whether ixos took the scene for bad input
  double seconds = 0;           ///< of processor time
  double seconds_per_step = 0;  ///< at most, without what a run does before its first step if the machine is idle
  double steps = 0, dofs = 0;
  std::shared_ptr<const std::vector<ColumnHistory>> histories{};  ///< of a good run, by quantity
  std::vector<AdviceComparison> comparisons{};                    ///< see compare_models()
  MeasuredStrains strains{};                                      ///< up to the times that decide the quantities
};

inline const AdviceBranch& branch_at(const AdviceDirections& directions, const AdvicePoint& point, std::size_t d) {
  return directions.all[d].branches[point[d].branch];
}
inline const AdviceLevel& level_at(const AdviceDirections& directions, const AdvicePoint& point, std::size_t d) {
  return branch_at(directions, point, d).levels[point[d].level];
}

/// Returns the point of the scene as it is.
AdvicePoint scene_point(const AdviceDirections& directions);

/// Returns the settings of a point, without those that the scene has already.
Assignments settings_of(const AdviceDirections& directions, const AdvicePoint& point);

/// Returns the point as "Newmark, time step 0.4, Q1C4, mesh 160 x 8"; choices that are the scene's own are left out,
/// but for scheme, step, element and mesh.
std::string description_of(const AdviceDirections& directions, const AdvicePoint& point);

/// Returns the choice of a point in a direction: "Newmark, time step 0.4", "surface points 3".
std::string place_label(const AdviceDirections& directions, const AdvicePoint& point, std::size_t d);

/// Returns a name for the folder of the point's run, of plain letters, digits, dots and dashes. Points have different
/// names.
std::string name_of(const AdviceDirections& directions, const AdvicePoint& point);

/// Returns in how many directions two points differ.
std::size_t distance(const AdvicePoint& a, const AdvicePoint& b);

}  // namespace ixos
