// Errors of models in place of the scene's own, and what the runs examined.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "study/advice/advice_errors.hpp"

namespace ixos {
namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

}  // namespace

double AdviceErrors::measure_error(std::size_t direction, std::size_t branch) const {
  const std::string& law = directions_.all[direction].branches[branch].law;
  if (law.empty()) return 0;
  MeasuredStrains strains;
  for (const AdviceSample& sample : good_)
    if (sample.point[direction].branch == 0) strains.add(sample.strains);
  return ixos::measure_error(law, strains);
}

double AdviceErrors::model_error(std::size_t direction, const AdvicePlace& place, std::size_t quantity) const {
  if (!replaces_model(directions_, direction, place.branch)) return 0;
  std::optional<std::size_t> compared;  // the finest level that is not finer than the place
  double largest = 0;
  for (const AdviceSample& sample : good_) {
    const AdvicePlace& other = sample.point[direction];
    if (other.branch != place.branch || other.level > place.level || (compared && other.level < *compared)) continue;
    for (const AdviceComparison& comparison : sample.comparisons) {
      if (comparison.direction != direction || quantity >= comparison.differences.size()) continue;
      const double here = comparison.differences[quantity];
      largest = compared && other.level == *compared ? std::max(largest, here) : here;
      compared = other.level;
    }
  }
  return compared ? std::max(largest, measure_error(direction, place.branch)) : unknown;
}

/// Returns an absolute error of a place, but at least that of its model.
double AdviceErrors::with_model(std::size_t d, std::size_t q, const AdvicePlace& place, double error) const {
  const double model = model_error(d, place, q);
  return std::isfinite(model) ? std::max(error, model * scale(q)) : unknown;
}

bool AdviceErrors::is_examined(const AdvicePoint& point, std::size_t direction, std::size_t quantity) const {
  const AdvicePlace own_place{own(direction), directions_.all[direction].scene_level};
  const bool is_another = direction > mesh_direction && !(point[direction] == own_place);
  return is_another || examined_[direction][quantity];
}

}  // namespace ixos
