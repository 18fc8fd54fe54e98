// The change of the base to elements of a higher order.
#include <algorithm>
#include <cmath>
#include <limits>

#include "study/advice/advice_search.hpp"
#include "study/common/tuning.hpp"

namespace ixos {
/// Returns the cost to expect of a run with a branch of cells whose mesh error is a part of the tolerance, if a limit
/// is the exact value. The line of the branch has two runs or more. Infinite: no level is fine enough.
double AdviceSearch::cost_of_cells(std::size_t branch, std::size_t quantity, double limit) const {
  const AdviceErrors known = errors();
  const std::vector<std::size_t>& tested = known.levels(mesh_direction, branch);
  const std::vector<SequencePoint>& points = known.points(mesh_direction, branch, quantity);
  const std::size_t n = points.size();
  // Equal values tell nothing of the error.
  const double change = 1e-12 * std::abs(limit) + std::abs(points[n - 1].value - points[n - 2].value);
  const double wanted = tuning::part_of_mesh * question_.tolerance * std::abs(limit);
  // The finest run of all may be the limit itself. Its own error is a part of the last change.
  const auto error = [&](std::size_t i) { return std::abs(points[i].value - limit) + tuning::part_of_change * change; };
  double power =
      std::clamp(std::log2(error(n - 2) / error(n - 1)), tuning::least_cell_power, tuning::largest_cell_power);
  if (directions_.all[mesh_direction].branches[branch].higher_order)
    power = std::min(tuning::largest_cell_power, std::max(power, tuning::least_cell_power + tuning::gain_of_order));
  std::size_t coarsest = n;
  while (coarsest > 0 && error(coarsest - 1) <= wanted) --coarsest;
  const double level =
      coarsest < n ? static_cast<double>(tested[coarsest])
                   : static_cast<double>(tested.back()) + std::ceil(std::log2(error(n - 1) / wanted) / power - 1e-9);
  if (!(level < static_cast<double>(levels(mesh_direction)))) return std::numeric_limits<double>::infinity();
  AdvicePoint point = base_;
  point[mesh_direction] = {branch, static_cast<std::size_t>(level)};
  return costs().seconds(point);
}

/// If the mesh keeps all settings from the tolerance, runs the two coarsest meshes with elements of a higher order, and
/// moves the base to these elements if they promise to be cheaper. Returns whether it moved.
bool AdviceSearch::adopt_better_cells() {
  if (sought_better_cells_ || !(finest_part(mesh_direction) > tuning::part_of_mesh * question_.tolerance)) return false;
  if (cheapest_within(candidates(directions_, errors(), costs(), 0), question_.tolerance) != nullptr) return false;
  sought_better_cells_ = true;
  const std::vector<AdviceBranch>& branches = directions_.all[mesh_direction].branches;
  const auto found = std::find_if(branches.begin(), branches.end(),
                                  [](const AdviceBranch& branch) { return branch.higher_order && branch.same_limit; });
  if (found == branches.end() || coarsest_mesh_ + 1 >= found->levels.size()) return false;
  const auto b = static_cast<std::size_t>(found - branches.begin());
  std::vector<AdvicePoint> trials(2, base_);
  for (std::size_t k = 0; k < 2; ++k) trials[k][mesh_direction] = {b, coarsest_mesh_ + k};
  for (const AdvicePoint& trial : trials) {
    const double seconds = costs().seconds(trial);
    if (seconds > tuning::part_of_budget * (runs_.budget() - runs_.spent())) return false;
    runs_.carry_out({trial});
    if (!runs_.sample(trial)->good) return false;
  }
  for (std::size_t q = 0; q < is_error_.size(); ++q) {
    if (is_error_[q]) continue;
    const double limit = runs_.sample(trials.back())->values[q];
    const double now = cost_of_cells(own(mesh_direction), q, limit), then = cost_of_cells(b, q, limit);
    if (!(then <= tuning::worthwhile_cells * now)) return false;
  }
  base_ = trials.front();
  std::fill(last_part_.begin(), last_part_.end(), std::numeric_limits<double>::infinity());
  return true;
}

}  // namespace ixos
