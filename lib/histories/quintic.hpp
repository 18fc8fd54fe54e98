/// Quintic Hermite interpolation.
#pragma once
#include "histories/time_function.hpp"

namespace ixos {

/// Returns the polynomial of degree 5 that has the values and derivatives of both ends of an interval, `since` after
/// its start. In tau = since / length, `from` gives its first three coefficients and the conditions at `to` the others.
inline TimeValue quintic(const TimeValue& from, const TimeValue& to, double length, double since) {
  const double tau = since / length;
  const double c0 = from.value;
  const double c1 = length * from.rate;
  const double c2 = length * length * from.acceleration / 2;
  const double value = to.value - c0 - c1 - c2;
  const double rate = length * to.rate - c1 - 2 * c2;
  const double acceleration = length * length * to.acceleration - 2 * c2;
  const double c3 = 10 * value - 4 * rate + acceleration / 2;
  const double c4 = -15 * value + 7 * rate - acceleration;
  const double c5 = 6 * value - 3 * rate + acceleration / 2;
  return {c0 + tau * (c1 + tau * (c2 + tau * (c3 + tau * (c4 + tau * c5)))),
          (c1 + tau * (2 * c2 + tau * (3 * c3 + tau * (4 * c4 + tau * 5 * c5)))) / length,
          (2 * c2 + tau * (6 * c3 + tau * (12 * c4 + tau * 20 * c5))) / (length * length)};
}

}  // namespace ixos
