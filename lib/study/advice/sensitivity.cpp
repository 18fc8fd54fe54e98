#include "study/advice/sensitivity.hpp"

#include <algorithm>
#include <cmath>

#include "study/common/tuning.hpp"

namespace ixos {
Sensitivity sensitivity(double value, double perturbed, double tolerance) {
  const double scale = std::max(std::abs(value), std::abs(perturbed));
  const double change = scale == 0 ? 0 : std::abs(perturbed - value) / scale;
  if (!(change <= std::max(tuning::chaotic_part * tolerance, tuning::least_chaotic)))
    return {change, Predictability::Chaotic};
  return {change, change <= tuning::predictable ? Predictability::Predictable : Predictability::Sensitive};
}

}  // namespace ixos
