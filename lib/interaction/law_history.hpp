/// Laws of the gap with a history: one number at each point that stays from step to step.
#pragma once
#include <cstddef>
#include <type_traits>

#include "base/pack.hpp"

namespace ixos {

/// Whether a law has a history q. Such a law has, beside the members of a law without one, which are those of a point
/// without a past:
/// - `static constexpr bool has_history = true`;
/// - first(r), q of a point whose gap is r at the start, and updated(q, r), q after a step that ends at gap r;
/// - at(q), the law over a step that begins with q. It has the members of a law. Its energy E is the incremental
///   potential: E(r) = at(q').energy(r) + dissipated(q, q') with q' = updated(q, r), of which the first part is the
///   energy stored after the step. The tractions at(q) and at(q') are equal at r;
/// - dissipated(q, q'), the work per area that a step dissipates, at least 0 [E0 L0];
/// - damage(q), the share of its stiffness that the point has lost, in [0, 1];
/// - bonds_later(), whether a point that begins beyond the range may come to attract.
template <class Law, class = void>
struct HasHistory : std::false_type {};
template <class Law>
struct HasHistory<Law, std::void_t<decltype(Law::has_history)>> : std::bool_constant<Law::has_history> {};

/// A law with a history at the quadrature points of a batch of sides.
template <class Law>
struct LawOfBatch {
  static constexpr bool has_range = Law::has_range;
  const Law* law;
  const Pack* history;  ///< by quadrature point

  double range() const { return law->range(); }
};

/// Returns the law at quadrature point q of a batch. A law without a history is the same everywhere.
template <class Law>
const Law& law_at(const Law& law, std::size_t) {
  return law;
}
template <class Law>
auto law_at(const LawOfBatch<Law>& laws, std::size_t q) {
  return laws.law->at(laws.history[q]);
}

}  // namespace ixos
