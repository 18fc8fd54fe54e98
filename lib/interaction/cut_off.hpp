/// A law of the gap that ends at a range.
#pragma once
#include <cmath>

#include "base/pack.hpp"
#include "interaction/gap_domain.hpp"

namespace ixos {

/// Traction T(r) - T(rc) up to the range rc, nothing beyond: the potential and its slope are continuous there (a
/// shifted force; Allen and Tildesley 1987, 5.2.3). Per reference area it differs from the law by at most |T(rc)| in
/// traction, and by |psi(rc)| + |T(rc)| (rc - r) in energy. Points out of range are not evaluated.
template <class Law>
class CutOff {
 public:
  static constexpr bool has_range = true;
  static constexpr GapDomain domain = Law::domain;

  /// range > 0 [L0].
  CutOff(const Law& law, double range)
      : law_(law), range_(range), energy_(law.energy(range)), traction_(law.traction(range)) {}

  double range() const { return range_; }
  const Law& uncut() const { return law_; }

  template <class T>
  T energy(const T& r) const {
    return select(r < range_, T(law_.energy(r) - energy_ + traction_ * (r - range_)), T(0.0));
  }
  template <class T>
  T traction(const T& r) const {
    return select(r < range_, T(law_.traction(r) - traction_), T(0.0));
  }
  template <class T>
  T stiffness(const T& r) const {
    return select(r < range_, law_.stiffness(r), T(0.0));
  }

  /// Returns the law's own mean over the part of the way that is in range.
  template <class T>
  T mean_traction(const T& r0, const T& r1) const {
    const Part<T> part(*this, r0, r1);
    return part.share * (law_.mean_traction(part.from, part.to) - traction_);
  }
  template <class T>
  T mean_stiffness(const T& r0, const T& r1) const {
    const Part<T> part(*this, r0, r1);
    const T way = select(r0 == r1, T(1.0), T(r1 - r0));
    const T growth =
        select(r1 < range_, select(r0 < range_, T(0.0), T((range_ - r0) / (way * way))), T(-1.0 * part.share / way));
    const T inside = select(r1 < range_, T(part.share * law_.mean_stiffness(part.from, part.to)), T(0.0));
    return inside - growth * (law_.mean_traction(part.from, part.to) - traction_);
  }
  /// Returns the potential of the mean in closed form, from that of the law: with E the energy that ends at the range,
  /// it is the integral of (E(r) - E(r0))/(r - r0) from r0 to r1. The law must be defined beyond the range.
  template <class T>
  T mean_potential(const T& r0, const T& r1) const {
    using std::log;
    const auto starts_in = r0 < range_, ends_in = r1 < range_;
    // Across the range the energy has two forms: the second one gives ln((r1 - r0)/(rc - r0)).
    const T ratio = (r1 - r0) / select(r0 == range_, T(1.0), T(range_ - r0));
    const T across =
        select(r0 == range_, T(1.0), select(starts_in, select(ends_in, T(1.0), ratio), select(ends_in, ratio, T(1.0))));
    const T logarithm = log(across);
    const T end = select(ends_in, r1, T(range_));
    const T outward = law_.mean_potential(r0, end) + traction_ * (end - r0) - energy(r0) * logarithm;
    if (everywhere(starts_in)) return outward;
    const T beyond = law_.energy(r0) - energy_ + traction_ * (r0 - range_);  // E as if it did not end
    const T inward = law_.mean_potential(r0, r1) - law_.mean_potential(r0, T(range_)) + traction_ * (r1 - range_) +
                     beyond * logarithm;
    return select(starts_in, outward, select(ends_in, inward, T(0.0)));
  }

  template <class T>
  T magnitude(const T& r) const {
    return select(r < range_, law_.magnitude(r), T(0.0));
  }

  bool repels() const { return law_.repels(); }
  /// Returns the law's own gap. The shift moves the root of the traction farther out, by about |T(rc)/T'|.
  double equilibrium_gap() const { return law_.equilibrium_gap(); }
  double adhesion_gap() const { return law_.adhesion_gap(); }

 private:
  /// The part of the way from r0 to r1 that is in range, and its share of the whole.
  template <class T>
  struct Part {
    Part(const CutOff& law, const T& r0, const T& r1)
        : from(select(r0 < law.range_, r0, T(law.range_))), to(select(r1 < law.range_, r1, T(law.range_))) {
      const T way = select(r0 == r1, T(1.0), T(r1 - r0));
      share = select(r0 == r1, select(r0 < law.range_, T(1.0), T(0.0)), T((to - from) / way));
    }
    T from, to, share;
  };

  Law law_;
  double range_;
  double energy_;    ///< psi(rc)
  double traction_;  ///< T(rc)
};

}  // namespace ixos
