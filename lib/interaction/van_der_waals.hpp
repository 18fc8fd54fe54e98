/// Van der Waals interaction of a surface with a half-space.
#pragma once
#include <cmath>

namespace ixos {

/// psi(r) = c1/(8 r^8) - c2/(2 r^2) per reference area, gap r > 0 [L0]; the traction on the surface, along the half-
/// space's outward normal, is T = -psi' = c1/r^9 - c2/r^3 [E0] (Sauer and Wriggers 2009; Gautam and Sauer 2014, eqs.
/// 38, 39, whose r-bar is r/L0). Only reciprocals and products: no power function, any scalar type.
class VanDerWaals {
 public:
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

  /// T = -dpsi/dr, positive away from the half-space.
  template <class T>
  T traction(const T& r) const {
    const T inverse = 1.0 / r;
    const T s = inverse * inverse;
    return s * inverse * (c1_ * (s * s * s) - c2_);
  }

  /// d2psi/dr2 = -dT/dr [E0/L0], negative beyond the gap of largest attraction.
  template <class T>
  T stiffness(const T& r) const {
    const T s = 1.0 / (r * r);
    return s * s * ((9 * c1_) * (s * s * s) - 3 * c2_);
  }

  /// What the traction's rounding error is measured by: both parts without their signs, and |dT/dr| r.
  template <class T>
  T magnitude(const T& r) const {
    const T inverse = 1.0 / r;
    const T s = inverse * inverse;
    return s * inverse * ((10 * c1_) * (s * s * s) + 4 * c2_);
  }

  double c1() const { return c1_; }
  double c2() const { return c2_; }
  /// T = 0: 15^(-1/6) r0 [L0].
  double equilibrium_gap() const { return std::pow(15.0, -1.0 / 6) * r0_; }
  /// The gap of largest attraction, dT/dr = 0: 5^(-1/6) r0 [L0].
  double adhesion_gap() const { return std::pow(5.0, -1.0 / 6) * r0_; }

 private:
  double c1_;  ///< [E0 L0^9]
  double c2_;  ///< [E0 L0^3]
  double r0_;  ///< [L0]
};

}  // namespace ixos
