/// Differences of logarithms that keep their digits near 0. Each is given l = log1p(x), which its caller has.
#pragma once
#include <cmath>

#include "base/pack.hpp"

namespace ixos {

/// (x - log1p(x))/x^2 by its series, sum_{k>=2} (-1)^k x^(k-2)/k: for |x| < 0.02, where ten terms leave 2e-18.
template <class T>
T minus_log1p_series(const T& x) {
  T sum = T(-1.0 / 11) * x + T(1.0 / 10);
  for (int k = 9; k >= 2; --k) sum = sum * x + (k % 2 == 0 ? 1.0 : -1.0) / k;
  return sum;
}

/// x - log1p(x).
template <class T>
T minus_log1p(const T& x, const T& l) {
  using std::abs;
  return select(abs(x) < 0.02, T(minus_log1p_series(x) * x * x), T(x - l));
}

/// 1 - log1p(x)/x, 0 at x = 0.
template <class T>
T minus_log1p_quotient(const T& x, const T& l) {
  using std::abs;
  const auto small = abs(x) < 0.02;
  return select(small, T(minus_log1p_series(x) * x), T((x - l) / select(small, T(1.0), x)));
}

/// The derivative of log1p(x)/x, (x/(1 + x) - log1p(x))/x^2, -1/2 at x = 0.
template <class T>
T log1p_quotient_slope(const T& x, const T& l) {
  // sum_{k>=2} (-1)^(k+1) (k-1)/k x^(k-2)
  T sum = T(10.0 / 11) * x - T(9.0 / 10);
  for (int k = 9; k >= 2; --k) sum = sum * x + (k % 2 == 0 ? -1.0 : 1.0) * (k - 1) / k;
  using std::abs;
  const auto small = abs(x) < 0.02;
  return select(small, sum, T((x / (1.0 + x) - l) / select(small, T(1.0), T(x * x))));
}

}  // namespace ixos
