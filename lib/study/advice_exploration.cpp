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
  AdvicePoint point = base;
  const AdviceEstimate own = errors.estimate(base);
  for (std::size_t d = directions.all.size(); d-- > 0;) {  // single runs first
    const AdviceDirection& direction = directions.all[d];
    // Nothing is known of other elements if the mesh cannot be refined.
    if (d == mesh_direction && errors.tested(d, 0) < 2) continue;
    for (std::size_t b = 1; b < direction.branches.size(); ++b) {
      point = base;
      point[d].branch = b;
      if (!was_run(samples, point)) return point;
      if (!direction.converges) continue;
      // A coarser step may do with this scheme; another element shows on the next mesh whether it converges.
      double most = tolerance;
      for (const std::vector<double>& parts : own.parts) most = std::max(most, parts[d]);
      while (errors.tested(d, b) > 0 && errors.finest_error(d, b) <= most) {
        if (d == time_direction && point[d].level == 0) break;
        if (d == mesh_direction && point[d].level + 1 == direction.branches[b].levels.size()) break;
        if (d == mesh_direction && errors.tested(d, b) > 1) break;
        point[d].level = d == time_direction ? point[d].level - 1 : point[d].level + 1;
        if (!was_run(samples, point)) return point;
        if (d == time_direction && point[d].level + 2 <= base[d].level) break;
      }
    }
  }
  return {};
}

}  // namespace ixos
