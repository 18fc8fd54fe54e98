#include "study/sensitivity.hpp"

#include <algorithm>
#include <cmath>

namespace ixos {
namespace {

constexpr double predictable = 1e-6;  ///< ten thousand times the perturbation
constexpr double least_chaotic = 1e-5;
constexpr double part_of_tolerance = 1.0 / 3;

}  // namespace

Sensitivity sensitivity(double value, double perturbed, double tolerance) {
  const double scale = std::max(std::abs(value), std::abs(perturbed));
  const double change = scale == 0 ? 0 : std::abs(perturbed - value) / scale;
  if (!(change <= std::max(part_of_tolerance * tolerance, least_chaotic))) return {change, Predictability::Chaotic};
  return {change, change <= predictable ? Predictability::Predictable : Predictability::Sensitive};
}

}  // namespace ixos
