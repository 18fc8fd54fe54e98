#include "study/advice/advice_models.hpp"

#include <utility>

namespace ixos {
namespace {

/// Returns the run to compare with; null if there is none.
const AdviceSample* own_model(const std::vector<AdviceSample>& samples, const AdvicePoint& point, std::size_t d) {
  const AdviceSample* best = nullptr;
  for (const AdviceSample& twin : samples) {
    if (!twin.good || twin.histories == nullptr || twin.point[d].branch != 0) continue;
    AdvicePoint same = point;
    same[d] = twin.point[d];
    if (same == twin.point && (best == nullptr || twin.point[d].level > best->point[d].level)) best = &twin;
  }
  return best;
}

}  // namespace

void compare_models(const AdviceDirections& directions, const std::vector<AdviceSample>& samples,
                    AdviceSample& sample) {
  if (!sample.good || sample.histories == nullptr) return;
  for (std::size_t d = 0; d < sample.point.size(); ++d) {
    if (!replaces_model(directions, d, sample.point[d].branch)) continue;
    const AdviceSample* own = own_model(samples, sample.point, d);
    if (own == nullptr) continue;
    AdviceComparison comparison{d, {}};
    for (std::size_t q = 0; q < sample.histories->size(); ++q)
      comparison.differences.push_back(column_difference((*own->histories)[q], (*sample.histories)[q]));
    sample.comparisons.push_back(std::move(comparison));
  }
}

}  // namespace ixos
