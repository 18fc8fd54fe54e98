/// Cube roots that keep their digits near 1.
#pragma once
#include <cmath>

#include "base/pack.hpp"

namespace ixos {

/// Returns (1 + x)^(1/3) - 1 for x > -1, with all digits for small x. The root from the library lacks them; a step of
/// Newton's method on y (3 + y (3 + y)) = x adds them.
template <class T>
T cube_root_minus_one(const T& x) {
  using std::cbrt;
  T y = cbrt(T(1.0 + x)) - 1.0;
  y -= (y * (3.0 + y * (3.0 + y)) - x) / (3.0 * (1.0 + y) * (1.0 + y));
  return y;
}
[[gnu::noinline]] inline Pack cube_root_minus_one_by_lanes(const Pack& x) {
  return Pack([&](auto lane) { return cube_root_minus_one(static_cast<double>(x[lane])); });
}
/// For packs: a step of Halley's method from the [2/2] Pade approximant, whose error is below 1e-5 for |x| < 0.25. If
/// some lane is larger, it computes lane by lane.
[[gnu::always_inline]] inline Pack cube_root_minus_one(const Pack& x) {
  if (!all_of(std::experimental::abs(x) < 0.25)) return cube_root_minus_one_by_lanes(x);
  const Pack y = x * (1.0 / 3 + x * (1.0 / 6)) / (1.0 + x * (5.0 / 6 + x * (5.0 / 54)));
  const Pack root = 1.0 + y, rest = y * (3.0 + y * (3.0 + y)) - x;
  return y - rest * root / (3.0 * root * root * root - rest);
}

}  // namespace ixos
