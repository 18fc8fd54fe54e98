/// Small dense matrices over a scalar type, row by row. All loops have constant bounds and unroll.
#pragma once
#include <array>
#include <cstddef>

namespace ixos {

template <class T, std::size_t Rows, std::size_t Columns = Rows>
using Small = std::array<std::array<T, Columns>, Rows>;

template <class T>
T determinant(const Small<T, 1>& m) {
  return m[0][0];
}

template <class T>
T determinant(const Small<T, 2>& m) {
  return m[0][0] * m[1][1] - m[0][1] * m[1][0];
}

template <class T>
T determinant(const Small<T, 3>& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// Returns det(I + M) - 1 without cancellation for small M: the sum of M's invariants.
template <class T>
T determinant_minus_one(const Small<T, 2>& m) {
  return m[0][0] + m[1][1] + determinant(m);
}

template <class T>
T determinant_minus_one(const Small<T, 3>& m) {
  const T minors = m[0][0] * m[1][1] - m[0][1] * m[1][0] + m[1][1] * m[2][2] - m[1][2] * m[2][1] + m[0][0] * m[2][2] -
                   m[0][2] * m[2][0];
  return m[0][0] + m[1][1] + m[2][2] + minors + determinant(m);
}

/// Returns the inverse, given the determinant.
template <class T>
Small<T, 2> inverse(const Small<T, 2>& m, const T& det) {
  const T r = 1.0 / det;
  return {{{m[1][1] * r, -m[0][1] * r}, {-m[1][0] * r, m[0][0] * r}}};
}

template <class T>
Small<T, 3> inverse(const Small<T, 3>& m, const T& det) {
  const T r = 1.0 / det;
  Small<T, 3> inv;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
      inv[i][j] = (m[a][c] * m[b][d] - m[a][d] * m[b][c]) * r;
    }
  return inv;
}

/// Returns A B.
template <std::size_t D, class T>
Small<T, D> product(const Small<T, D>& a, const Small<T, D>& b) {
  Small<T, D> result{};
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j)
      for (std::size_t k = 0; k < D; ++k) result[i][j] += a[i][k] * b[k][j];
  return result;
}

/// Returns the sum of products of all entries.
template <std::size_t D, class T>
T contraction(const Small<T, D>& a, const Small<T, D>& b) {
  T sum(0.0);
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) sum += a[i][j] * b[i][j];
  return sum;
}

}  // namespace ixos
