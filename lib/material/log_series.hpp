/// Differences of logarithms that keep their digits near 0. The caller passes l = log1p(x) to each function.
#pragma once
#include <cmath>

#include "base/pack.hpp"

namespace ixos {

/// Returns ln(1 + x). For packs it uses 2 artanh(x/(2 + x)), whose series needs eleven terms for |x| < 0.3; if some
/// lane is larger, it computes lane by lane.
template <class T>
T log_one_plus(const T& x) {
  using std::log1p;
  return log1p(x);
}
/// Returns 2 artanh(s) by its series.
[[gnu::always_inline]] inline Pack twice_artanh(const Pack& s) {
  const Pack square = s * s;
  Pack sum = 1.0 / 21;
  for (int k = 19; k >= 1; k -= 2) sum = sum * square + 1.0 / k;
  return 2.0 * s * sum;
}
[[gnu::noinline]] inline Pack log_one_plus_by_lanes(const Pack& x) { return std::experimental::log1p(x); }
[[gnu::always_inline]] inline Pack log_one_plus(const Pack& x) {
  if (!all_of(std::experimental::abs(x) < 0.3)) return log_one_plus_by_lanes(x);
  return twice_artanh(x / (2.0 + x));
}

/// Computes ln(1 + x) and 1/(1 + x) by their series, for |x| up to the limit: the relative rest is 1e-16.
constexpr double log_and_inverse_limit = 0.01;
template <class T>
[[gnu::always_inline]] inline void log_and_inverse(const T& x, T& log, T& inverse) {
  const T square = x * x;
  inverse = (1.0 - x) * ((1.0 + square) * (1.0 + square * square));
  T sum = T(-1.0 / 8);
  for (int k = 7; k >= 1; --k) sum = sum * x + (k % 2 == 0 ? -1.0 : 1.0) / k;
  log = sum * x;
}

/// Returns ln(1 + x), also for x close to -1: given sqrt(1 + x), which has more correct digits unless |x| is small.
template <class T>
T log_one_plus(const T& x, const T& root) {
  using std::abs;
  using std::log;
  const auto small = abs(x) < 0.2;
  return select(small, log_one_plus(T(select(small, x, T(0.0)))), T(log(T(root * root))));
}

/// Returns whether A = C - I is small (for packs: the mask of lanes), given its trace and det C - 1. Up to that size C
/// has more correct digits.
template <class T>
auto near_undeformed(const T& trace, const T& j) {
  using std::abs;
  return abs(j) + abs(trace) < 0.5;
}

/// Returns ln det C, given the trace of A = C - I, j = det C - 1 and J = det F. Near the undeformed state, rotated or
/// not, j has more correct digits. Far from it J has: det C has the rounding error of a square, and no correct digit at
/// J = 1e-8.
template <class T>
T log_determinant(const T& trace, const T& j, const T& jacobian) {
  using std::log;
  const auto near = near_undeformed(trace, j);
  const T close = log_one_plus(T(select(near, j, T(0.0))));
  return everywhere(near) ? close : select(near, close, T(log(T(jacobian * jacobian))));
}
[[gnu::noinline]] inline Pack log_determinant_by_lanes(const Pack& trace, const Pack& j, const Pack& jacobian) {
  return log_determinant<Pack>(trace, j, jacobian);
}
/// Inline while all lanes are near the undeformed state, as they mostly are.
[[gnu::always_inline]] inline Pack log_determinant(const Pack& trace, const Pack& j, const Pack& jacobian) {
  if (!everywhere(near_undeformed(trace, j))) return log_determinant_by_lanes(trace, j, jacobian);
  return log_one_plus(j);
}

/// Returns (x - log1p(x))/x^2 by its series, sum_{k>=2} (-1)^k x^(k-2)/k: for |x| < 0.02, where ten terms leave 2e-18.
template <class T>
T minus_log1p_series(const T& x) {
  T sum = T(-1.0 / 11) * x + T(1.0 / 10);
  for (int k = 9; k >= 2; --k) sum = sum * x + (k % 2 == 0 ? 1.0 : -1.0) / k;
  return sum;
}

/// Returns 1 - log1p(x)/x, 0 at x = 0.
template <class T>
T minus_log1p_quotient(const T& x, const T& l) {
  using std::abs;
  const auto small = abs(x) < 0.02;
  return select(small, T(minus_log1p_series(x) * x), T((x - l) / select(small, T(1.0), x)));
}

/// Returns log1p(x)/x, 1 at x = 0.
template <class T>
T log1p_quotient(const T& x, const T& l) {
  using std::abs;
  const auto small = abs(x) < 0.02;
  return select(small, T(1.0 - minus_log1p_series(x) * x), T(l / select(small, T(1.0), x)));
}

/// Returns 1 + x times the derivative of log1p(x)/x, (x - (1 + x) log1p(x))/x^2, -1/2 at x = 0.
template <class T>
T scaled_log1p_quotient_slope(const T& x, const T& l) {
  // sum_{k>=2} (-1)^(k+1) (k-1)/k x^(k-2)
  T sum = T(10.0 / 11) * x - T(9.0 / 10);
  for (int k = 9; k >= 2; --k) sum = sum * x + (k % 2 == 0 ? -1.0 : 1.0) * (k - 1) / k;
  using std::abs;
  const auto small = abs(x) < 0.02;
  if (everywhere(small)) return (1.0 + x) * sum;
  return select(small, T((1.0 + x) * sum), T((x - (1.0 + x) * l) / select(small, T(1.0), T(x * x))));
}

}  // namespace ixos
