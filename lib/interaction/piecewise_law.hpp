/// Laws of the gap whose traction is a polynomial on each of several intervals.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/pack.hpp"
#include "interaction/gap_domain.hpp"
#include "interaction/mean_functions.hpp"

namespace ixos {

/// The traction c0 + c1 x + c2 x^2 + c3 x^3 [E0] with x = r - origin, at gaps from the end of the piece before to `end`
/// [L0].
struct TractionPiece {
  double end;
  double origin;
  std::array<double, 4> c;

  template <class T>
  T traction(const T& r) const {
    const T x = r - origin;
    return c[0] + x * (c[1] + x * (c[2] + x * c[3]));
  }
  /// Returns -dT/dr.
  template <class T>
  T stiffness(const T& r) const {
    const T x = r - origin;
    return -c[1] - x * (2 * c[2] + x * (3 * c[3]));
  }
  /// Returns the energy of this traction, zero at the origin.
  template <class T>
  T energy(const T& r) const {
    const T x = r - origin;
    return -x * (c[0] + x * (c[1] / 2 + x * (c[2] / 3 + x * (c[3] / 4))));
  }
};

namespace detail {
/// The Gauss points on [0, 1], (1 -+ 1/sqrt(3))/2.
inline constexpr double low = 0.211324865405187118, high = 0.788675134594812882;
}  // namespace detail

/// The part of the way from r0 to r1 whose gaps are between `low` and `high`: the shares of the way at its ends, and
/// its gaps. Without a way it is all of the way or nothing. The scalar T is double or Pack.
template <class T>
struct PathPart {
  PathPart(const T& low, const T& high, const T& r0, const T& r1)
      : from(clamped(low, high, r0)), to(clamped(low, high, r1)) {
    const auto still = r0 == r1;
    const T way = select(still, T(1.0), T(r1 - r0));
    const T all = select(r0 < high, select(r0 < low, T(0.0), T(1.0)), T(0.0));
    start = select(still, T(0.0), T((from - r0) / way));
    end = select(still, all, T((to - r0) / way));
  }
  T at(double x) const { return start + x * (end - start); }
  T gap(double x) const { return from + x * (to - from); }
  T from, to, start, end;

 private:
  static T clamped(const T& low, const T& high, const T& r) {
    const T high_enough = select(r < low, low, r);
    return select(high_enough < high, high_enough, high);
  }
};

/// Returns the scale of the rounding error of a traction with kinks, |T| + |dT/dr r|. The rounding of the gap may move
/// it across a kink, so the stiffness is the largest one nearby.
template <class Law, class T>
T magnitude_near_kinks(const Law& law, const T& r) {
  using std::abs;
  T steepest(0.0);
  for (const double nearby : {1 - 1e-9, 1.0, 1 + 1e-9}) {
    const T here = abs(T(law.stiffness(T(nearby * r))));
    steepest = select(here > steepest, here, steepest);
  }
  return abs(law.traction(r)) + abs(T(steepest * r));
}

/// Adds to `sum` the part of the potential of a mean traction that belongs to gaps from `from` to `to`, which are on
/// one piece and on the way from r0: the integral of (e(r) - e0)/(r - r0) with e = level + piece.energy(r) there.
void add_mean_potential(const TractionPiece& piece, double level, double e0, double r0, double from, double to,
                        double& sum);

/// A law with such pieces, the first for all gaps up to its end, and without traction beyond the last. The traction
/// must be continuous. It is defined at every gap. Means are sums over the pieces of two Gauss points, which are exact
/// for cubic polynomials; they lose no digits as r1 approaches r0. The scalar T is double or Pack.
class PiecewiseLaw {
 public:
  static constexpr bool has_range = true;
  static constexpr GapDomain domain = GapDomain::All;

  /// `pieces`: at least one, ends ascending. See GapLaw for the named gaps [L0].
  PiecewiseLaw(std::vector<TractionPiece> pieces, double equilibrium_gap, double adhesion_gap);

  double range() const { return pieces_.back().end; }
  bool repels() const { return repels_; }
  double equilibrium_gap() const { return equilibrium_gap_; }
  double adhesion_gap() const { return adhesion_gap_; }

  template <class T>
  T energy(const T& r) const {
    return choose(r, [&](std::size_t i) { return T(energy_[i] + pieces_[i].energy(r)); });
  }
  template <class T>
  T traction(const T& r) const {
    return choose(r, [&](std::size_t i) { return pieces_[i].traction(r); });
  }
  template <class T>
  T stiffness(const T& r) const {
    return choose(r, [&](std::size_t i) { return pieces_[i].stiffness(r); });
  }
  template <class T>
  T magnitude(const T& r) const {
    return magnitude_near_kinks(*this, r);
  }

  template <class T>
  T mean_traction(const T& r0, const T& r1) const {
    T sum(0.0);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const PathPart<T> part = part_of(i, r0, r1);
      const T mean = 0.5 * (pieces_[i].traction(part.gap(detail::low)) + pieces_[i].traction(part.gap(detail::high)));
      sum += (part.end - part.start) * mean;
    }
    return sum;
  }
  /// Returns the integral of xi psi''(r(xi)) over [0, 1].
  template <class T>
  T mean_stiffness(const T& r0, const T& r1) const {
    T sum(0.0);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const PathPart<T> part = part_of(i, r0, r1);
      const T mean = 0.5 * (part.at(detail::low) * pieces_[i].stiffness(part.gap(detail::low)) +
                            part.at(detail::high) * pieces_[i].stiffness(part.gap(detail::high)));
      sum += (part.end - part.start) * mean;
    }
    return sum;
  }
  template <class T>
  T mean_potential(const T& r0, const T& r1) const {
    return lanewise(r0, r1, [this](double a, double b) { return potential(a, b); });
  }

 private:
  /// Returns value(i) for the piece i of the gap, 0 beyond the range.
  template <class T, class Value>
  T choose(const T& r, const Value& value) const {
    T result(0.0);
    for (std::size_t i = pieces_.size(); i-- > 0;) result = select(r < pieces_[i].end, T(value(i)), result);
    return result;
  }

  double start(std::size_t i) const;
  /// Returns the part of a way on piece i.
  template <class T>
  PathPart<T> part_of(std::size_t i, const T& r0, const T& r1) const {
    return {T(start(i)), T(pieces_[i].end), r0, r1};
  }
  double potential(double r0, double r1) const;

  std::vector<TractionPiece> pieces_;
  std::vector<double> energy_;  ///< by piece: at its origin, so that the energy is continuous and 0 beyond the range
  bool repels_ = false;
  double equilibrium_gap_, adhesion_gap_;
};

/// Returns the law of a constant attraction [E0] that ends at a gap `range` [L0] by a cubic polynomial from range -
/// ramp to range + ramp: psi(0) = -strength range. 0 < ramp <= range.
PiecewiseLaw constant_attraction(double strength, double range, double ramp);

}  // namespace ixos
