#include "scene/examine/steep_laws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "interaction/gap_law.hpp"

namespace ixos {

double fall_of_attraction(const GapLaw& law) {
  constexpr int samples = 2000;
  const double range = law.range(), none = std::numeric_limits<double>::infinity();
  if (!std::isfinite(range)) return none;
  const auto attraction = [&](int k) -> double { return -static_cast<double>(law.traction(range * k / samples)[0]); };
  double largest = 0;
  for (int k = 1; k <= samples; ++k) largest = std::max(largest, attraction(k));
  if (!(largest > 0)) return none;
  int low = samples;
  while (low > 1 && attraction(low - 1) <= 0.1 * largest) --low;
  int high = low;
  while (high > 1 && attraction(high) < 0.9 * largest) --high;
  return static_cast<double>(low - high) / samples;
}

std::string steep_law_hint(const std::vector<SceneInteraction>& interactions) {
  constexpr double limit = 0.15;
  for (const SceneInteraction& own : interactions) {
    const auto law = acting_law(own);
    const double share = fall_of_attraction(*law);
    if (share < limit)
      return fmt::format(
          "{}: the attraction falls within {:.3g} L0, {:.2g} of its range (limit {}), where Newton's method may cycle; "
          "the law \"Smooth Dugdale\" with a Smoothing of 0.2 or more can have the same work of adhesion and ends "
          "gently",
          own.node.path(), share * law->range(), share, limit);
  }
  return "";
}

}  // namespace ixos
