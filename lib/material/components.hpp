/// Tensors of three dimensions some of whose components are zero throughout.
///
/// A component that is known to be zero costs nothing. It is never read: a function may leave it unset.
#pragma once
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "base/small_matrix.hpp"
#include "material/meridian_moduli.hpp"

namespace ixos {

/// Calls function(integral_constant 0), ..., function(integral_constant n - 1): a loop that unrolls however long its
/// body is, so that conditions on indices cost nothing.
template <class Function, std::size_t... I>
[[gnu::always_inline]] inline void unroll(const Function& function, std::index_sequence<I...>) {
  (function(std::integral_constant<std::size_t, I>{}), ...);
}
template <std::size_t n, class Function>
[[gnu::always_inline]] inline void unroll(const Function& function) {
  unroll(function, std::make_index_sequence<n>{});
}

/// All components of a tensor: bodies in three dimensions.
struct SolidComponents {
  static constexpr bool has(std::size_t, std::size_t) { return true; }
  static constexpr std::array<std::array<std::size_t, 2>, 9> all{
      {{0, 0}, {0, 1}, {0, 2}, {1, 0}, {1, 1}, {1, 2}, {2, 0}, {2, 1}, {2, 2}}};
  static constexpr std::array<std::array<std::size_t, 2>, 6> symmetric{
      {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};
};

/// Those of a plane and of the direction across it: plane strain and bodies of revolution.
struct PlaneComponents {
  static constexpr bool has(std::size_t i, std::size_t j) { return (i == 2) == (j == 2); }
  static constexpr auto all = meridian_components;
  static constexpr std::array<std::array<std::size_t, 2>, 4> symmetric{{{0, 0}, {0, 1}, {1, 1}, {2, 2}}};
};

/// Algebra of such tensors.
template <class Components, class T>
struct TensorAlgebra {
  using Tensor = Small<T, 3>;

  /// Calls visit(i, j) for the components; the indices are compile-time constants.
  template <class Visit>
  [[gnu::always_inline]] static void for_each(const Visit& visit) {
    unroll<Components::all.size()>([&](auto k) __attribute__((always_inline)) {
      visit(std::integral_constant<std::size_t, Components::all[k][0]>{},
            std::integral_constant<std::size_t, Components::all[k][1]>{});
    });
  }
  /// Sets the components of the result to value(i, j).
  template <class Value>
  [[gnu::always_inline]] static Tensor make(const Value& value) {
    Tensor result;
    for_each([&](auto i, auto j) __attribute__((always_inline)) { result[i][j] = value(i, j); });
    return result;
  }
  /// Returns the sum of value(k) over the k for which (i, k) and (j, k) are components.
  template <class Value>
  [[gnu::always_inline]] static T sum(std::size_t i, std::size_t j, const Value& value) {
    T result(0.0);
    for (std::size_t k = 0; k < 3; ++k)
      if (Components::has(i, k) && Components::has(j, k)) result += value(k);
    return result;
  }
  [[gnu::always_inline]] static Tensor product(const Tensor& a, const Tensor& b) {
    return make(
        [&](std::size_t i, std::size_t j) { return sum(i, j, [&](std::size_t k) { return a[i][k] * b[k][j]; }); });
  }
  /// Returns A B^T.
  [[gnu::always_inline]] static Tensor product_transposed(const Tensor& a, const Tensor& b) {
    return make(
        [&](std::size_t i, std::size_t j) { return sum(i, j, [&](std::size_t k) { return a[i][k] * b[j][k]; }); });
  }
  static T trace(const Tensor& a) { return a[0][0] + a[1][1] + a[2][2]; }
  /// Returns the sum of products of all components.
  static T contraction(const Tensor& a, const Tensor& b) {
    T result(0.0);
    for_each([&](auto i, auto j) { result += a[i][j] * b[i][j]; });
    return result;
  }
  /// Returns the cofactors: det(A) A^-T.
  [[gnu::always_inline]] static Tensor cofactors(const Tensor& m) {
    return make([&](auto i, auto j) __attribute__((always_inline)) {
      constexpr std::size_t a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
      T result(0.0);
      if constexpr (Components::has(a, c) && Components::has(b, d)) result += m[a][c] * m[b][d];
      if constexpr (Components::has(a, d) && Components::has(b, c)) result -= m[a][d] * m[b][c];
      return result;
    });
  }
  /// Returns the determinant, given the cofactors.
  static T determinant(const Tensor& m, const Tensor& cofactors) {
    return sum(0, 0, [&](std::size_t k) { return m[0][k] * cofactors[0][k]; });
  }
  /// Adds a number to the diagonal.
  static Tensor shifted(Tensor a, const T& value) {
    for (std::size_t i = 0; i < 3; ++i) a[i][i] += value;
    return a;
  }
};

}  // namespace ixos
