/// Friction that grows smoothly with the slip of a step.
#pragma once
#include <cmath>
#include <cstddef>

#include "base/pack.hpp"
#include "interaction/slip_response.hpp"

namespace ixos {

/// The potential of friction over a step without an elastic slip (Li et al. 2020). The slip q of the step, of length y,
/// has the energy T_s (y^2/d - y^3/(3 d^2)) up to the length d, and T_s (y - d/3) beyond. The traction is T_s (2 y/d -
/// y^2/d^2) or T_s along q. All work is dissipated.
template <class T, std::size_t D>
class SmoothedSlip {
 public:
  using Vector = std::array<T, D>;
  using Matrix = Small<T, D>;
  using Response = SlipResponse<T, D>;

  /// d > 0 [L0], T_s >= 0 [E0].
  SmoothedSlip(double length, const T& threshold) : length_(length), threshold_(threshold) {}

  T energy(const Vector& q) const {
    using std::sqrt;
    const T y = sqrt(inner(q, q)), x = y / length_;
    return threshold_ * select(y < length_, T(y * x * (1.0 - x / 3.0)), T(y - length_ / 3));
  }

  /// Returns traction and derivatives at q; `plane` is the projector onto the tangent plane.
  Response at(const Vector& q, const Matrix& plane) const {
    using std::sqrt;
    const T y = sqrt(inner(q, q)), safe = select(y > tiny, y, T(tiny));
    const auto creeps = y < length_;
    const T factor = select(creeps, T((2.0 - y / length_) / length_), T(1.0 / safe));
    const T slope = select(creeps, T(-1.0 / (length_ * length_)), T(-1.0 / (safe * safe)));
    return radial(q, plane, factor, slope, safe);
  }

  /// Returns the mean traction over the straight path from no slip to q, on which it keeps its direction, its
  /// derivative by q, and that by the threshold.
  Response mean(const Vector& q, const Matrix& plane) const {
    using std::sqrt;
    const T y = sqrt(inner(q, q)), safe = select(y > tiny, y, T(tiny));
    const auto creeps = y < length_;
    const T factor = select(creeps, T((1.0 - y / (3 * length_)) / length_), T((1.0 - length_ / (3.0 * safe)) / safe));
    const T slope =
        select(creeps, T(-1.0 / (3 * length_ * length_)), T((2 * length_ / (3.0 * safe) - 1.0) / (safe * safe)));
    return radial(q, plane, factor, slope, safe);
  }

  /// Returns the potential of that mean in q.
  T mean_potential(const Vector& q) const {
    using std::log;
    using std::sqrt;
    const T y = sqrt(inner(q, q)), x = y / length_;
    const T beyond = select(x > 1.0, x, T(1.0));
    return threshold_ * length_ *
           select(x < 1.0, T(x * x * (0.5 - x / 9.0)), T(7.0 / 18 + (beyond - 1.0) - log(beyond) / 3.0));
  }

 private:
  static constexpr double tiny = 1e-150;

  /// Returns the response of the traction T_s factor(y) q.
  Response radial(const Vector& q, const Matrix& plane, const T& factor, const T& slope, const T& y) const {
    Response result;
    for (std::size_t i = 0; i < D; ++i) {
      result.by_threshold[i] = factor * q[i];
      result.traction[i] = threshold_ * result.by_threshold[i];
      for (std::size_t j = 0; j < D; ++j)
        result.stiffness[i][j] = threshold_ * (factor * plane[i][j] + slope * q[i] * (q[j] / y));
    }
    return result;
  }

  double length_;
  T threshold_;
};

}  // namespace ixos
