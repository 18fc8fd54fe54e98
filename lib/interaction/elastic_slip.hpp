/// Friction with an elastic slip: Huber's function of the slip.
#pragma once
#include <cmath>
#include <cstddef>

#include "base/pack.hpp"
#include "fem/quadrature.hpp"
#include "interaction/slip_response.hpp"

namespace ixos {

/// The potential of friction over a step with the threshold T_s frozen. A slip q, the elastic slip at the step's start
/// plus the slip since then, has the energy eps |q|^2/2 up to the length R = T_s/eps, and T_s |q| - T_s^2/(2 eps)
/// beyond. It is the least over all elastic slips e of the stored energy eps |e|^2/2 plus the work T_s |q - e| that
/// slip dissipates (Ortiz and Stainier 1999). Its derivative is the traction, eps q or T_s q/|q|.
///
/// Means over the straight path from q0 to q1 are split where |q| = R. On the parts beyond, with the unit vector e of
/// the path, the place p along it and the path's distance h from q = 0, r = sqrt(h^2 + p^2):
///     int q/r dp = e [r] + h [asinh(p/|h|)].
template <class T, std::size_t D>
class ElasticSlip {
 public:
  using Vector = std::array<T, D>;
  using Matrix = Small<T, D>;
  using Response = SlipResponse<T, D>;

  /// eps > 0 [E0/L0], T_s >= 0 [E0].
  ElasticSlip(double stiffness, const T& threshold)
      : stiffness_(stiffness), threshold_(threshold), radius_(threshold / stiffness) {}

  T energy(const Vector& q) const {
    using std::sqrt;
    const T square = inner(q, q), length = sqrt(square);
    return select(length <= radius_, T(0.5 * stiffness_ * square), T(threshold_ * (length - 0.5 * radius_)));
  }

  /// Returns traction and derivatives at q; `plane` is the projector onto the tangent plane.
  Response at(const Vector& q, const Matrix& plane) const {
    using std::sqrt;
    Response result;
    const T length = sqrt(inner(q, q));
    const auto sticks = length < radius_;  // without a threshold nothing sticks, also where nothing has slipped
    const T safe = select(length > tiny, length, T(tiny));
    const T factor = select(sticks, T(stiffness_), T(threshold_ / safe));
    for (std::size_t i = 0; i < D; ++i) {
      const T s = q[i] / safe;
      result.traction[i] = factor * q[i];
      result.by_threshold[i] = select(sticks, T(0.0), s);
      for (std::size_t j = 0; j < D; ++j)
        result.stiffness[i][j] = factor * plane[i][j] - select(sticks, T(0.0), T(factor * s * (q[j] / safe)));
    }
    return result;
  }

  /// Returns the mean traction over the path from q0 to q1 = q0 + change, its derivative by q1, and that by the
  /// threshold.
  template <SlipPart part = SlipPart::All>
  Response mean(const Vector& q0, const Vector& change, const Matrix& plane) const;

  /// Returns the potential of the mean in q1, int [E(q0 + xi change) - E(q0)]/xi dxi, by Gauss points on each part of
  /// the path. It serves line searches, not balances.
  T mean_potential(const Vector& q0, const Vector& change) const;

 private:
  static constexpr double tiny = 1e-150;

  /// A straight path, on which p runs from `start` to `end`.
  struct Path {
    Vector along, aside;  ///< e; unit vector of h, or zero
    T offset;             ///< |h|
    T start, end, length;
    T enter, leave;  ///< the part between them is that where |q| < R
  };
  Path path_of(const Vector& q0, const Vector& change, const T& length) const;
  /// Factors of e and of the unit vector h/|h| in a traction, and of e e^T, the rest of the plane, and e h^T + h e^T
  /// in a stiffness.
  struct Sums {
    T traction_along = 0.0, traction_aside = 0.0;
    T along = 0.0, aside = 0.0, mixed = 0.0;
  };

  static T lesser(const T& a, const T& b) { return select(a < b, a, b); }
  static T radius_at(const Path& path, const T& p) {
    using std::sqrt;
    const T r = sqrt(path.offset * path.offset + p * p);
    return select(r > tiny, r, T(tiny));
  }
  /// Adds the integrals of q/r over p from a to b, which have one sign. Returns asinh(b/h) - asinh(a/h).
  static T add_traction(const Path& path, const T& a, const T& b, Sums& sums);
  /// Adds those of the derivative of q/r, times (p - start)/L.
  static void add_stiffness(const Path& path, const T& a, const T& b, const T& angle, Sums& sums);
  template <SlipPart part>
  static void add_sliding(const Path& path, const T& a, const T& b, Sums& sums) {
    const T angle = add_traction(path, a, b, sums);
    if constexpr (part == SlipPart::All) add_stiffness(path, a, b, angle, sums);
  }

  double stiffness_;
  T threshold_, radius_;
};

template <class T, std::size_t D>
T ElasticSlip<T, D>::add_traction(const Path& path, const T& a, const T& b, Sums& sums) {
  using std::asinh;
  const T& h = path.offset;
  const T ra = radius_at(path, a), rb = radius_at(path, b), span = b - a;
  const T divisor = b * ra + a * rb;
  const T size = select(divisor < 0.0, T(-divisor), divisor);
  // asinh(b/h) - asinh(a/h) without cancellation, also as h vanishes.
  const T angle = asinh(select(size > tiny, T(span * (a + b) / select(size > tiny, divisor, T(1.0))), T(0.0)));
  sums.traction_along += span * (a + b) / (ra + rb);
  sums.traction_aside += h * angle;
  return angle;
}

template <class T, std::size_t D>
void ElasticSlip<T, D>::add_stiffness(const Path& path, const T& a, const T& b, const T& angle, Sums& sums) {
  const T& h = path.offset;
  const T ra = radius_at(path, a), rb = radius_at(path, b), span = b - a;
  // Moments of 1/r^3 in p. Over a part that is short against r their differences would cancel.
  const T inverse = 1.0 / rb - 1.0 / ra, sine = b / rb - a / ra;
  const T m2 = angle - sine, m3 = (rb - ra) + h * h * inverse;
  T along = -h * h * inverse - path.start * sine, aside = m3 - path.start * m2,
    mixed = -h * (m2 + path.start * inverse);
  static const Quadrature gauss = gauss_legendre_unit(6);
  T short_along = 0.0, short_aside = 0.0, short_mixed = 0.0;
  for (std::size_t k = 0; k < gauss.points.size(); ++k) {
    const T p = a + gauss.points[k] * span, r = radius_at(path, p);
    const T weight = gauss.weights[k] * span * (p - path.start) / r, c = p / r, s = h / r;
    short_along += weight * s * s;
    short_aside += weight * c * c;
    short_mixed -= weight * c * s;
  }
  const auto is_short = span < 0.5 * lesser(ra, rb);
  sums.along += select(is_short, short_along, along) / path.length;
  sums.aside += select(is_short, short_aside, aside) / path.length;
  sums.mixed += select(is_short, short_mixed, mixed) / path.length;
}

template <class T, std::size_t D>
typename ElasticSlip<T, D>::Path ElasticSlip<T, D>::path_of(const Vector& q0, const Vector& change,
                                                            const T& length) const {
  using std::sqrt;
  Path path;
  path.length = length;
  for (std::size_t i = 0; i < D; ++i) path.along[i] = change[i] / length;
  path.start = inner(q0, path.along);
  path.end = path.start + length;
  Vector projection;
  for (std::size_t i = 0; i < D; ++i) projection[i] = q0[i] - path.start * path.along[i];
  const T again = inner(projection, path.along);  // the first projection leaves its rounding error
  for (std::size_t i = 0; i < D; ++i) projection[i] -= again * path.along[i];
  path.offset = sqrt(inner(projection, projection));
  for (std::size_t i = 0; i < D; ++i) path.aside[i] = projection[i] / select(path.offset > tiny, path.offset, T(1.0));
  const T square = radius_ * radius_ - path.offset * path.offset;
  const T half = sqrt(select(square > 0.0, square, T(0.0)));
  const auto within = [&](const T& p) { return select(p < path.start, path.start, select(p > path.end, path.end, p)); };
  path.enter = within(-half);
  path.leave = within(half);
  return path;
}

template <class T, std::size_t D>
template <SlipPart part>
typename ElasticSlip<T, D>::Response ElasticSlip<T, D>::mean(const Vector& q0, const Vector& change,
                                                             const Matrix& plane) const {
  using std::sqrt;
  Vector middle;
  for (std::size_t i = 0; i < D; ++i) middle[i] = q0[i] + 0.5 * change[i];
  const T length = sqrt(inner(change, change));
  // A path that is short against R has the traction of its middle, to rounding.
  const auto is_point = length <= 1e-8 * (radius_ + sqrt(inner(q0, q0)));
  const Path path = path_of(q0, change, select(is_point, T(1.0), length));
  const T enter = path.enter, leave = path.leave;
  Sums sliding;
  add_sliding<part>(path, path.start, enter, sliding);
  add_sliding<part>(path, leave, path.end, sliding);
  const T stuck = leave - enter;
  const T stiffness = stiffness_ * stuck / path.length;
  const T share = 0.5 * (enter + leave - 2.0 * path.start) / path.length;  // of the path, at the middle of that part

  const Response at_middle = at(middle, plane);
  Response result;
  for (std::size_t i = 0; i < D; ++i) {
    const T e = path.along[i], h = path.aside[i];
    const T by_threshold = (e * sliding.traction_along + h * sliding.traction_aside) / path.length;
    result.by_threshold[i] = select(is_point, at_middle.by_threshold[i], by_threshold);
    const T traction = threshold_ * by_threshold + stiffness * (h * path.offset + e * (0.5 * (enter + leave)));
    result.traction[i] = select(is_point, at_middle.traction[i], traction);
    for (std::size_t j = 0; part == SlipPart::All && j < D; ++j) {
      const T ee = e * path.along[j], eh = e * path.aside[j] + h * path.along[j];
      const T slope =
          threshold_ / path.length * (sliding.along * ee + sliding.aside * (plane[i][j] - ee) + sliding.mixed * eh) +
          stiffness * share * plane[i][j];
      result.stiffness[i][j] = select(is_point, T(0.5 * at_middle.stiffness[i][j]), slope);
    }
  }
  return result;
}

template <class T, std::size_t D>
T ElasticSlip<T, D>::mean_potential(const Vector& q0, const Vector& change) const {
  using std::exp;
  using std::log;
  using std::sqrt;
  const T length = sqrt(inner(change, change));
  const Path path = path_of(q0, change, select(length > tiny, length, T(1.0)));
  const T first = energy(q0);
  const T ends[4] = {0.0, (path.enter - path.start) / path.length, (path.leave - path.start) / path.length, 1.0};
  // Up to there the energy is smooth in xi, beyond in the logarithm of xi.
  const T scale = 0.5 * (radius_ + sqrt(inner(q0, q0))) / path.length;
  static const Quadrature gauss = gauss_legendre_unit(12);
  T sum = 0.0;
  const auto add = [&](const T& xi, const T& weight) {
    Vector q;
    for (std::size_t i = 0; i < D; ++i) q[i] = q0[i] + xi * change[i];
    sum += weight * (energy(q) - first);
  };
  for (std::size_t part = 0; part < 3; ++part) {
    const T &a = ends[part], &b = ends[part + 1];
    const T middle = select(scale < a, a, lesser(scale, b)), span = middle - a;
    const T ratio = log(select(b > middle, T(b / select(middle > tiny, middle, b)), T(1.0)));
    for (std::size_t k = 0; k < gauss.points.size(); ++k) {
      const T xi = a + gauss.points[k] * span;
      add(xi, gauss.weights[k] * span / select(xi > tiny, xi, T(1.0)));
      add(middle * exp(gauss.points[k] * ratio), gauss.weights[k] * ratio);
    }
  }
  return sum;
}

}  // namespace ixos
