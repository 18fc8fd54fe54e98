/// The part of an elastic energy that resists changes of volume.
#pragma once
#include <cmath>

#include "material/log_series.hpp"

namespace ixos {

/// U(J) with the bulk modulus K = U''(1) [E0], from j = J^2 - 1 and L = ln J^2 so that no digits are lost near J = 1.
struct VolumetricEnergy {
  enum class Form {
    Logarithm,  ///< U = K/8 L^2 = K/2 (ln J)^2 (Hencky); its tension has a maximum at J = e
    Convex      ///< U = K/4 (j - L) = K/4 (J^2 - 1 - 2 ln J), convex in J (Simo and Taylor 1982)
  };
  double bulk;
  Form form = Form::Logarithm;

  /// Returns U per reference volume [E0].
  template <class T>
  T energy(const T& j, const T& l) const {
    if (form == Form::Logarithm) return bulk / 8 * (l * l);
    using std::abs;
    return bulk / 4 * select(abs(j) < 0.02, T(minus_log1p_series(j) * (j * j)), T(j - l));
  }

  /// Returns p = dU/d ln J [E0], positive in tension.
  template <class T>
  T pressure(const T& j, const T& l) const {
    return form == Form::Logarithm ? T(bulk / 2 * l) : T(bulk / 2 * j);
  }

  /// Returns dp/d ln J [E0].
  template <class T>
  T stiffness(const T& j, const T& /*l*/) const {
    return form == Form::Logarithm ? T(bulk) : T(bulk * (1.0 + j));
  }
};

}  // namespace ixos
