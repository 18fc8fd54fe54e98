/// A law of the gap at many quadrature points of sides.
#pragma once
#include <cstddef>

#include "base/pack.hpp"
#include "interaction/law_history.hpp"
#include "rule/rule.hpp"

namespace ixos {

/// Gaps of points at the ends of a segment [L0]. `from` and `velocity`, the change of the gap by h v_from, are null if
/// the rule uses neither.
template <class T>
struct GapEnds {
  std::size_t size = 0;
  const T* to = nullptr;
  const T* from = nullptr;
  const T* velocity = nullptr;

  [[gnu::always_inline]] T at(std::size_t q, const RulePoint& point) const {
    T r = point.to * to[q];
    if (from != nullptr) r += point.from * from[q];
    if (velocity != nullptr) r += point.velocity * velocity[q];
    return r;
  }
};

/// Returns whether no force acts at a point in any lane: on a straight path no time point is nearer than the ends.
template <class Laws, class T>
[[gnu::always_inline]] inline bool is_out_of_range([[maybe_unused]] const Laws& laws,
                                                   [[maybe_unused]] const GapEnds<T>& ends,
                                                   [[maybe_unused]] std::size_t q) {
  if constexpr (Laws::has_range) {
    if (ends.velocity != nullptr) return false;
    const T nearest = ends.from != nullptr ? T(smaller(ends.from[q], ends.to[q])) : ends.to[q];
    return least(nearest) >= laws.range();
  } else {
    return false;
  }
}

/// Sets the numbers of points to value(q, law there), or 0 where nothing acts. Returns whether something may act
/// somewhere. `laws`: a law, or LawOfBatch.
template <class Laws, class T, class Value>
[[gnu::always_inline]] inline bool set_where_acts(const Laws& laws, const GapEnds<T>& ends, T* numbers,
                                                  const Value& value) {
  bool acts = false;
  for (std::size_t q = 0; q < ends.size; ++q) {
    if (is_out_of_range(laws, ends, q)) {
      numbers[q] = T(0.0);
      continue;
    }
    acts = true;
    numbers[q] = value(q, law_at(laws, q));
  }
  return acts;
}

/// Computes the rule's tractions [E0], 0 where nothing acts, and lowers `least_gap` to the least gap of the time points
/// and of the end, where something may act. Returns whether it may act somewhere. `laws`: a law, or LawOfBatch.
template <class Laws, class T>
bool rule_tractions(const Laws& laws, const GapEnds<T>& ends, const Rule& rule, T* tractions, T& least_gap) {
  return set_where_acts(laws, ends, tractions, [&](std::size_t q, const auto& law) {
    T mean(0.0);
    for (const RulePoint& point : rule.points) {
      const T r = ends.at(q, point);
      least_gap = smaller(least_gap, r);
      mean += point.weight * law.traction(r);
    }
    if (rule.mean != Mean::Points) mean += law.mean_traction(ends.from[q], ends.to[q]);
    least_gap = smaller(least_gap, ends.to[q]);
    return mean;
  });
}

/// Computes the derivatives of minus the tractions by the gap at the end [E0/L0]; `convex` leaves out negative ones.
/// Returns whether one of them may differ from 0.
template <class Laws, class T>
bool rule_stiffnesses(const Laws& laws, const GapEnds<T>& ends, const Rule& rule, bool convex, T* stiffnesses) {
  return set_where_acts(laws, ends, stiffnesses, [&](std::size_t q, const auto& law) {
    const auto kept = [&](const T& stiffness) {
      return convex ? select(stiffness > 0.0, stiffness, T(0.0)) : stiffness;
    };
    T mean(0.0);
    for (const RulePoint& point : rule.points)
      mean += (point.weight * point.to) * kept(law.stiffness(ends.at(q, point)));
    if (rule.mean != Mean::Points) mean += kept(law.mean_stiffness(ends.from[q], ends.to[q]));
    return mean;
  });
}

/// Returns the largest s <= 1 with r + s p dr >= margin min(r, near) at the end of the segment and, if the path is not
/// linear, at every time point (a linear path between two points before a flat wall never leaves their segment). dr:
/// changes of the gaps at the end; p = du(xi)/du_s.
template <class T>
T admissible_step(const GapEnds<T>& ends, const T* changes, const Rule& rule, double margin, double near) {
  T step(1.0);
  const auto restrict_to = [&](const T& r, const T& dr) {
    const T room = r - margin * smaller(r, T(near));
    // If dr < 0: s <= room/-dr. Otherwise the divisor is 1 and the quotient is discarded.
    step = smaller(step, select(dr < 0.0, T(room / (select(dr < 0.0, T(-dr), T(1.0)))), T(1.0)));
  };
  for (std::size_t q = 0; q < ends.size; ++q) {
    restrict_to(ends.to[q], changes[q]);
    if (ends.velocity == nullptr) continue;
    for (const RulePoint& point : rule.points) restrict_to(ends.at(q, point), T(point.to * changes[q]));
  }
  return select(step > 0.0, step, T(0.0));
}

}  // namespace ixos
