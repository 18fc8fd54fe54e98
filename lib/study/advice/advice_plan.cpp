#include "study/advice/advice_plan.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ixos {
namespace {

/// Adds the points that follow a point in the direction d and all after it.
void add_points(const AdviceDirections& directions, const AdviceErrors& errors, std::size_t beyond, std::size_t d,
                AdvicePoint& point, std::vector<AdvicePoint>& points) {
  if (d == point.size()) {
    points.push_back(point);
    return;
  }
  const AdviceDirection& direction = directions.all[d];
  for (std::size_t b = 0; b < direction.branches.size(); ++b) {
    std::vector<std::size_t> levels = errors.levels(d, b);
    const std::size_t most = direction.branches[b].levels.size();
    if (d <= mesh_direction && !levels.empty())
      for (std::size_t k = 0; k < beyond && levels.back() + 1 < most; ++k) levels.push_back(levels.back() + 1);
    for (std::size_t level : levels) {
      point[d] = {b, level};
      add_points(directions, errors, beyond, d + 1, point, points);
    }
  }
}

}  // namespace

std::vector<AdviceCandidate> candidates(const AdviceDirections& directions, const AdviceErrors& errors,
                                        const AdviceCosts& costs, std::size_t beyond) {
  std::vector<AdvicePoint> points;
  AdvicePoint point(directions.all.size());
  add_points(directions, errors, beyond, 0, point, points);
  std::vector<AdviceCandidate> all;
  for (const AdvicePoint& each : points) {
    AdviceEstimate estimate = errors.estimate(each);
    const double error = estimate.largest();
    if (std::isfinite(error)) all.push_back({each, std::move(estimate), error, costs.seconds(each)});
  }
  std::stable_sort(all.begin(), all.end(), [](const AdviceCandidate& a, const AdviceCandidate& b) {
    return std::pair(a.seconds, a.error) < std::pair(b.seconds, b.error);
  });
  return all;
}

const AdviceCandidate* cheapest_within(const std::vector<AdviceCandidate>& all, double tolerance) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const AdviceCandidate& each) { return each.error <= tolerance; });
  return found == all.end() ? nullptr : &*found;
}

const AdviceCandidate* most_accurate(const std::vector<AdviceCandidate>& all) {
  const auto found = std::min_element(
      all.begin(), all.end(), [](const AdviceCandidate& a, const AdviceCandidate& b) { return a.error < b.error; });
  return found == all.end() ? nullptr : &*found;
}

std::vector<AdviceCandidate> best_trades(const std::vector<AdviceCandidate>& all) {
  std::vector<AdviceCandidate> best;
  for (const AdviceCandidate& each : all)
    if (best.empty() || each.error < best.back().error) best.push_back(each);
  return best;
}

}  // namespace ixos
