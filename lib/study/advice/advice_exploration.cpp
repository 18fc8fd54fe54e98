#include "study/advice/advice_exploration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "study/common/tuning.hpp"

namespace ixos {
namespace {

bool was_run(const std::vector<AdviceSample>& samples, const AdvicePoint& point) {
  return std::any_of(samples.begin(), samples.end(), [&](const AdviceSample& sample) { return sample.point == point; });
}

/// Returns the relative error that a place adds to that of a point, by quantity.
std::vector<double> errors_of(const AdviceErrors& errors, AdvicePoint point, std::size_t d, const AdvicePlace& place) {
  std::vector<double> all;
  if (place.branch != errors.own(d) && errors.tested(d, place.branch) == 1) {
    for (std::size_t q = 0; q < errors.quantities(); ++q) all.push_back(errors.finest_error(d, place.branch, q));
    return all;
  }
  point[d] = place;
  for (const std::vector<double>& parts : errors.estimate(point).parts) all.push_back(parts[d]);
  return all;
}

double largest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

/// Fills in the level at which a branch of step or mesh is tried next, and what it promises. Returns whether there is
/// one.
bool next_level(const std::vector<AdviceSample>& samples, const AdviceErrors& errors, std::size_t d,
                std::size_t planned, double tolerance, AdviceTrial& trial) {
  AdvicePlace& place = trial.point[d];
  const std::vector<std::size_t>& levels = errors.levels(d, place.branch);
  place.level = planned - std::min<std::size_t>(planned, 2);
  if (!levels.empty()) {
    const std::size_t coarsest = levels.front(), finest = levels.back();
    const std::vector<double> error = errors_of(errors, trial.point, d, {place.branch, finest});
    const std::vector<double> own = errors_of(errors, trial.point, d, {errors.own(d), finest});
    bool gains = true;
    double least_promise = std::numeric_limits<double>::infinity();
    for (std::size_t q = 0; q < error.size(); ++q) {
      // The uncertainty of the limit is a part of both errors, and hides which is the smaller.
      const double unknown = errors.limit_uncertainty(d, q), net = error[q] - unknown, own_net = own[q] - unknown;
      gains = gains && net <= std::max(own_net / tuning::least_gain, tolerance);
      // A quantity that either keeps the tolerance with does not count.
      if (std::max(net, own_net) > tolerance || error.size() == 1)
        least_promise = std::min(least_promise, std::max(own_net, 0.0) / std::max(net, tolerance / 100));
    }
    const bool coarser =
        coarsest > 0 && largest(errors_of(errors, trial.point, d, {place.branch, coarsest})) <= tolerance;
    // One run may be accurate by coincidence; runs that are not good enough may still tell the limit.
    const bool finer = finest < planned && gains && (levels.size() == 1 || largest(error) > tolerance);
    if (!coarser && !finer) return false;
    place.level = coarser ? coarsest - 1 : finest + 1;
    trial.promise = std::isfinite(least_promise) ? least_promise : 1;
  }
  return !was_run(samples, trial.point);
}

/// Returns what the other directions of the plan leave of the tolerance to one direction; at least a part of it.
double share(const AdviceErrors& errors, const AdvicePoint& plan, std::size_t d, double tolerance) {
  const AdviceEstimate estimate = errors.estimate(plan);
  double left = tolerance;
  for (std::size_t q = 0; q < estimate.errors.size(); ++q)
    left = std::min(left, tolerance - (estimate.errors[q] - estimate.parts[q][d]));
  return std::max(left, tuning::least_share * tolerance);
}

}  // namespace

std::vector<AdviceTrial> explorations(const AdviceDirections& directions, const AdvicePoint& base,
                                      const AdvicePoint& plan, const std::vector<AdviceSample>& samples,
                                      const AdviceErrors& errors, double tolerance) {
  std::vector<AdviceTrial> trials;
  for (std::size_t d = 0; d < directions.all.size(); ++d) {
    const AdviceDirection& direction = directions.all[d];
    // Nothing is known of other elements if the mesh cannot be refined.
    if (d <= mesh_direction && errors.tested(d, errors.own(d)) < 2) continue;
    const double coarser = 1 - std::pow(2.0, d == mesh_direction ? -directions.dimension : -1);
    for (std::size_t b = 0; b < direction.branches.size(); ++b) {
      AdviceTrial trial{base, d, d > mesh_direction ? tuning::saving_of_a_choice : coarser, 1};
      AdvicePlace& place = trial.point[d];
      place.branch = b;
      if (d > mesh_direction) {
        if (errors.measure_error(d, b) > tolerance) continue;  // the law does not hold for these strains
        // Levels finer than the scene's own save nothing.
        const std::size_t end = b == 0 ? direction.scene_level : direction.branches[b].levels.size();
        for (place.level = 0; place.level < end; ++place.level)
          if (!was_run(samples, trial.point)) trials.push_back(trial);
      } else if (direction.branches[errors.own(d)].higher_order && errors.tested(d, b) == 0) {
        continue;  // elements of the lower order
      } else if (b != errors.own(d) &&
                 next_level(samples, errors, d, plan[d].level, share(errors, plan, d, tolerance), trial)) {
        trials.push_back(trial);
      }
    }
  }
  return trials;
}

}  // namespace ixos
