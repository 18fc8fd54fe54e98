/// Mooney and Rivlin's elastic law.
#pragma once
#include "material/isochoric_law.hpp"

namespace ixos {

/// W = c10 x + c01 y [E0] of the isochoric invariants x = I1 - 3 and y = I2 - 3 [-] (Holzapfel 2000, section 6.5): an
/// energy for IsochoricLaw. The shear modulus is 2 (c10 + c01).
struct MooneyRivlin {
  static constexpr bool has_limit = false;
  double c10, c01;

  template <class T>
  T energy(const T& x, const T& y) const {
    return c10 * x + c01 * y;
  }
  template <class T>
  Slopes<T> slopes(const T&, const T&) const {
    return {T(c10), T(c01)};
  }
  template <class T>
  Curvatures<T> curvatures(const T&, const T&) const {
    return {T(0.0), T(0.0), T(0.0)};
  }
};

}  // namespace ixos
