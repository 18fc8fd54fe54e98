#include "study/advice_exploration.hpp"

#include <algorithm>

namespace ixos {
namespace {

bool was_run(const std::vector<AdviceSample>& samples, const AdvicePoint& point) {
  return std::any_of(samples.begin(), samples.end(), [&](const AdviceSample& sample) { return sample.point == point; });
}

}  // namespace

AdvicePoint next_exploration(const AdviceDirections& directions, const AdvicePoint& base,
                             const std::vector<AdviceSample>& samples, const AdviceErrors& errors, double tolerance) {
  for (std::size_t d = directions.all.size(); d-- > 0;) {  // single runs first
    const AdviceDirection& direction = directions.all[d];
    // Nothing is known of other elements if the mesh cannot be refined.
    if (direction.converges && errors.tested(d, 0) < 2) continue;
    for (std::size_t b = 1; b < direction.branches.size(); ++b) {
      AdvicePoint point = base;
      point[d].branch = b;
      if (!direction.converges) point[d].level = 0;
      std::size_t& level = point[direction.converges ? d : time_direction].level;
      level -= std::min<std::size_t>(level, direction.converges ? 1 : 2);
      if (!was_run(samples, point)) return point;
      if (!direction.converges || level == 0 || errors.tested(d, b) == 0) continue;
      AdvicePoint own = base;
      own[d].level = level;
      double most = tolerance;
      for (const std::vector<double>& parts : errors.estimate(own).parts) most = std::max(most, parts[d]);
      if (!(errors.finest_error(d, b) <= most)) continue;
      --level;
      if (!was_run(samples, point)) return point;
    }
  }
  return {};
}

}  // namespace ixos
