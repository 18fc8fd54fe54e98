/// The SIMD scalar that element kernels are run with, and the few functions that kernels need on every scalar type.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <experimental/simd>

namespace ixos {

/// As many doubles as one register of the target holds: 8 with AVX-512, 4 with AVX2, 2 with SSE2. A pack wider than the
/// hardware is several times slower than a narrow one, so the width is never chosen by hand.
using Pack = std::experimental::native_simd<double>;
inline constexpr int pack_width = static_cast<int>(Pack::size());

/// `yes` where the condition holds, `no` elsewhere; both are evaluated.
template <class T>
T select(bool condition, const T& yes, const T& no) {
  return condition ? yes : no;
}
inline Pack select(const Pack::mask_type& condition, const Pack& yes, const Pack& no) {
  Pack result = no;
  where(condition, result) = yes;
  return result;
}

/// Smallest of the lanes.
inline double least(double x) { return x; }
inline double least(const Pack& x) { return std::experimental::hmin(x); }

/// Sum of the lanes.
inline double total(double x) { return x; }
inline double total(const Pack& x) { return std::experimental::reduce(x); }

inline double smaller(double a, double b) { return std::min(a, b); }
inline Pack smaller(const Pack& a, const Pack& b) { return std::experimental::min(a, b); }

/// Lane `i` of a scalar or a pack.
inline double lane(double x, std::size_t) { return x; }
inline double lane(const Pack& x, std::size_t i) { return x[i]; }

}  // namespace ixos
