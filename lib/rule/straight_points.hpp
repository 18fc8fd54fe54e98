/// Rules whose points lie on a straight path.
#pragma once
#include <algorithm>
#include <cmath>

#include "rule/rule.hpp"

namespace ixos {

/// Returns whether the rule has two points or more, all on the straight path, so that laws can sum over them at once.
inline bool has_straight_points(const Rule& rule) {
  return rule.points.size() > 1 && std::all_of(rule.points.begin(), rule.points.end(), [](const RulePoint& point) {
           return point.velocity == 0 && std::abs(point.from + point.to - 1) <= 1e-14;
         });
}

}  // namespace ixos
