/// Differences of exponentials that keep their digits near 0.
#pragma once
#include <cmath>

#include "base/pack.hpp"

namespace ixos {

/// Returns (exp(x) - 1 - x)/x^2 by its series, sum_{k>=2} x^(k-2)/k!: for |x| < 0.5, where 14 terms leave 1e-18.
template <class T>
T exp_remainder_series(const T& x) {
  T sum(1.0 / 15);
  for (int k = 14; k >= 3; --k) sum = (1.0 + x * sum) * (1.0 / k);
  return 0.5 * (1.0 + x * sum);
}

/// Returns exp(x) - 1 - x.
template <class T>
T exp_remainder(const T& x) {
  using std::abs;
  using std::exp;
  const auto small = abs(x) < 0.5;
  const T close = exp_remainder_series(x) * (x * x);
  return everywhere(small) ? close : select(small, close, T(exp(x) - 1.0 - x));
}

/// Returns (exp(x) - 1)/x, 1 at x = 0.
template <class T>
T exp_quotient(const T& x) {
  using std::abs;
  using std::exp;
  const auto small = abs(x) < 0.5;
  const T close = 1.0 + x * exp_remainder_series(x);
  return everywhere(small) ? close : select(small, close, T((exp(x) - 1.0) / select(small, T(1.0), x)));
}

}  // namespace ixos
