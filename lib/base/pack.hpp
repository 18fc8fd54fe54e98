/// The SIMD scalar with which element kernels run, and the few functions that kernels need on every scalar type.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <experimental/simd>
#include <type_traits>

namespace ixos {

/// As many doubles as one register of the target holds: 8 with AVX-512, 4 with AVX2, 2 with SSE2. A pack wider than the
/// hardware is several times slower than a narrow one, so the width is never chosen by hand.
using Pack = std::experimental::native_simd<double>;
inline constexpr int pack_width = static_cast<int>(Pack::size());

/// A pack's lanes in single precision: half the memory, for stored data and for products in preconditioners.
using NarrowPack = std::experimental::rebind_simd_t<float, Pack>;

/// Converts to and from the type in which a scalar or pack is stored.
template <class Kept, class T>
Kept narrow(const T& x) {
  if constexpr (std::is_same_v<Kept, NarrowPack>)
    return std::experimental::static_simd_cast<NarrowPack>(x);
  else
    return static_cast<Kept>(x);
}
template <class T, class Kept>
[[gnu::always_inline]] inline T widen(const Kept& x) {
  if constexpr (std::is_same_v<T, Kept>)
    return x;
  else if constexpr (std::is_same_v<Kept, NarrowPack>)
    return std::experimental::static_simd_cast<Pack>(x);
  else
    return static_cast<T>(x);
}

/// Products with the numbers of kernels, rounded to single precision. Templates, so that nothing is converted to the
/// type of lanes in single precision.
template <class P, std::enable_if_t<std::is_same_v<P, NarrowPack>, int> = 0>
[[gnu::always_inline]] inline P operator*(double a, const P& b) {
  return P(static_cast<float>(a)) * b;
}
template <class P, std::enable_if_t<std::is_same_v<P, NarrowPack>, int> = 0>
[[gnu::always_inline]] inline P operator*(const P& a, double b) {
  return a * P(static_cast<float>(b));
}

/// Returns `yes` in the lanes that meet the condition, `no` in the others. Both are evaluated.
template <class T>
T select(bool condition, const T& yes, const T& no) {
  return condition ? yes : no;
}
inline Pack select(const Pack::mask_type& condition, const Pack& yes, const Pack& no) {
  Pack result = no;
  where(condition, result) = yes;
  return result;
}

/// Returns whether the condition holds in all lanes.
inline bool everywhere(bool condition) { return condition; }
inline bool everywhere(const Pack::mask_type& condition) { return all_of(condition); }

/// Returns the smallest of the lanes.
inline double least(double x) { return x; }
inline double least(const Pack& x) { return std::experimental::hmin(x); }

/// Returns the sum of the lanes.
inline double total(double x) { return x; }
inline double total(const Pack& x) { return std::experimental::reduce(x); }

inline double smaller(double a, double b) { return std::min(a, b); }
/// Returns `b` if one of them is NaN. Not std::experimental::min: an attribute of that keeps g++ from inlining it, and
/// whatever calls it.
[[gnu::always_inline]] inline Pack smaller(const Pack& a, const Pack& b) { return select(a < b, a, b); }

/// Interleaves three packs lane by lane: rows[4 lane + j] is that lane of x, y, z, and 0 for j = 3. Vectors in space
/// are stored in memory like this.
inline void interleave(const Pack& x, const Pack& y, const Pack& z, double* rows) {
#if defined(__AVX512F__) && defined(__GNUC__) && !defined(__clang__)
  using V = double __attribute__((vector_size(64)));
  const V a = static_cast<__m512d>(x), b = static_cast<__m512d>(y), c = static_cast<__m512d>(z), zero = V{};
  const V xy0 = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
  const V xy1 = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
  const V z0 = __builtin_shufflevector(c, zero, 0, 8, 2, 10, 4, 12, 6, 14);
  const V z1 = __builtin_shufflevector(c, zero, 1, 9, 3, 11, 5, 13, 7, 15);
  const V even0 = __builtin_shufflevector(xy0, z0, 0, 1, 8, 9, 2, 3, 10, 11);
  const V even1 = __builtin_shufflevector(xy0, z0, 4, 5, 12, 13, 6, 7, 14, 15);
  const V odd0 = __builtin_shufflevector(xy1, z1, 0, 1, 8, 9, 2, 3, 10, 11);
  const V odd1 = __builtin_shufflevector(xy1, z1, 4, 5, 12, 13, 6, 7, 14, 15);
  const V out[4] = {__builtin_shufflevector(even0, odd0, 0, 1, 2, 3, 8, 9, 10, 11),
                    __builtin_shufflevector(even0, odd0, 4, 5, 6, 7, 12, 13, 14, 15),
                    __builtin_shufflevector(even1, odd1, 0, 1, 2, 3, 8, 9, 10, 11),
                    __builtin_shufflevector(even1, odd1, 4, 5, 6, 7, 12, 13, 14, 15)};
  std::memcpy(rows, out, sizeof out);
#else
  for (std::size_t lane = 0; lane < Pack::size(); ++lane) {
    rows[4 * lane] = x[lane];
    rows[4 * lane + 1] = y[lane];
    rows[4 * lane + 2] = z[lane];
    rows[4 * lane + 3] = 0;
  }
#endif
}

/// Sets rows[2 lane + j] of two packs.
inline void interleave(const Pack& x, const Pack& y, double* rows) {
#if defined(__AVX512F__) && defined(__GNUC__) && !defined(__clang__)
  using V = double __attribute__((vector_size(64)));
  const V a = static_cast<__m512d>(x), b = static_cast<__m512d>(y);
  const V out[2] = {__builtin_shufflevector(a, b, 0, 8, 1, 9, 2, 10, 3, 11),
                    __builtin_shufflevector(a, b, 4, 12, 5, 13, 6, 14, 7, 15)};
  std::memcpy(rows, out, sizeof out);
#else
  for (std::size_t lane = 0; lane < Pack::size(); ++lane) {
    rows[2 * lane] = x[lane];
    rows[2 * lane + 1] = y[lane];
  }
#endif
}

/// Returns lane `i` of a scalar or a pack.
inline double lane(double x, std::size_t) { return x; }
inline double lane(const Pack& x, std::size_t i) { return x[i]; }

}  // namespace ixos
