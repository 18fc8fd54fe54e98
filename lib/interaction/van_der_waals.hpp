/// Van der Waals interaction of a surface with a half-space.
#pragma once
#include <array>
#include <cmath>

#include "interaction/gap_domain.hpp"
#include "interaction/gap_power.hpp"

namespace ixos {

/// psi(r) = c1/(8 r^8) - c2/(2 r^2) per reference area, gap r > 0 [L0]; the traction on the surface, along the half-
/// space's outward normal, is T = -psi' = c1/r^9 - c2/r^3 [E0] (Sauer and Wriggers 2009; Gautam and Sauer 2014, eqs.
/// 38, 39, whose r-bar is r/L0). Only reciprocals and products: no power function, any scalar type.
class VanDerWaals {
 public:
  static constexpr bool has_range = false;
  static constexpr GapDomain domain = GapDomain::Positive;

  /// gamma_L = L0/r0 > 0, gamma_W = E0/W0 > 0 with W0 = A_H/(2 pi^2 r0^3).
  VanDerWaals(double gamma_length, double gamma_energy)
      : c1_(M_PI / (45 * gamma_energy * std::pow(gamma_length, 9))),
        c2_(M_PI / (3 * gamma_energy * std::pow(gamma_length, 3))),
        r0_(1 / gamma_length) {}

  template <class T>
  T energy(const T& r) const {
    const T s = 1.0 / (r * r);
    const T s2 = s * s;
    return s * ((c1_ / 8) * (s2 * s) - c2_ / 2);
  }

  /// Returns T = -dpsi/dr, positive away from the half-space.
  template <class T>
  T traction(const T& r) const {
    const T inverse = 1.0 / r;
    const T s = inverse * inverse;
    return s * inverse * (c1_ * (s * s * s) - c2_);
  }

  /// Returns d2psi/dr2 = -dT/dr [E0/L0], negative beyond the gap of largest attraction.
  template <class T>
  T stiffness(const T& r) const {
    const T s = 1.0 / (r * r);
    return s * s * ((9 * c1_) * (s * s * s) - 3 * c2_);
  }

  /// Returns the mean traction over gaps from r0 to r1, the integral over [0, 1] along the straight path, without
  /// cancellation: the mean of r^-m is sum_{k=1..m-1} r1^-k r0^-(m-k)/(m - 1).
  template <class T>
  T mean_traction(const T& r0, const T& r1) const {
    return c1_ * mean_power<9>(r0, r1) - c2_ * mean_power<3>(r0, r1);
  }

  /// Returns -d(mean traction)/dr1.
  template <class T>
  T mean_stiffness(const T& r0, const T& r1) const {
    return c1_ * mean_power_slope<9>(r0, r1) - c2_ * mean_power_slope<3>(r0, r1);
  }

  /// Returns the potential whose derivative in r1 is minus the mean traction, zero at r1 = r0.
  template <class T>
  T mean_potential(const T& r0, const T& r1) const {
    return -c1_ * mean_power_integral<9>(r0, r1) + c2_ * mean_power_integral<3>(r0, r1);
  }

  /// Returns the scale of the traction's rounding error: both parts without their signs, and |dT/dr| r.
  template <class T>
  T magnitude(const T& r) const {
    const T inverse = 1.0 / r;
    const T s = inverse * inverse;
    return s * inverse * ((10 * c1_) * (s * s * s) + 4 * c2_);
  }

  bool repels() const { return true; }
  double c1() const { return c1_; }
  double c2() const { return c2_; }
  /// Returns the powers of which the traction is the sum.
  std::array<GapPower, 2> powers() const { return {{{c1_, 9}, {-c2_, 3}}}; }
  /// Returns the gap at which T = 0: 15^(-1/6) r0 [L0].
  double equilibrium_gap() const { return std::pow(15.0, -1.0 / 6) * r0_; }
  /// Returns the gap of largest attraction, dT/dr = 0: 5^(-1/6) r0 [L0].
  double adhesion_gap() const { return std::pow(5.0, -1.0 / 6) * r0_; }

 private:
  template <int M, class T>
  static T mean_power(const T& r0, const T& r1) {
    const T s0 = 1.0 / r0, s1 = 1.0 / r1;
    // Horner's scheme in s1, with powers of s0 as coefficients.
    T sum(0.0), power = s0;
    for (int k = M - 1; k >= 1; --k, power = power * s0) sum = (sum + power) * s1;
    return sum * (1.0 / (M - 1));
  }

  /// Returns minus the derivative of the mean of r^-M in r1: sum_k k r1^-(k+1) r0^-(M-k)/(M - 1).
  template <int M, class T>
  static T mean_power_slope(const T& r0, const T& r1) {
    const T s0 = 1.0 / r0, s1 = 1.0 / r1;
    T sum(0.0), power = s0;
    for (int k = M - 1; k >= 1; --k, power = power * s0) sum = (sum + k * power) * s1;
    return sum * s1 * (1.0 / (M - 1));
  }

  /// Returns its integral from r1 = r0:
  ///   (r0^-(M-1) ln(r1/r0) + sum_{k=2..M-1} r0^-(M-k) (r0^-(k-1) - r1^-(k-1))/(k-1))/(M - 1).
  template <int M, class T>
  static T mean_power_integral(const T& r0, const T& r1) {
    using std::log;
    const T s0 = 1.0 / r0, s1 = 1.0 / r1;
    T far(1.0);  // s0^(M-1)
    for (int k = 1; k < M; ++k) far = far * s0;
    T sum = far * log(r1 * s0);
    const T ratio = r0 * s1;
    T power(1.0);  // (r0/r1)^(k-1)
    for (int k = 2; k < M; ++k) {
      power = power * ratio;
      sum = sum + far * (1.0 - power) * (1.0 / (k - 1));
    }
    return sum * (1.0 / (M - 1));
  }

  double c1_;  ///< [E0 L0^9]
  double c2_;  ///< [E0 L0^3]
  double r0_;  ///< [L0]
};

}  // namespace ixos
