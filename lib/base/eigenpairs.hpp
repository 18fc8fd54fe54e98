/// Eigenvalues and eigenvectors of small symmetric matrices.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

#include "base/pack.hpp"
#include "base/small_matrix.hpp"

namespace ixos {

/// A = sum_i value[i] n_i n_i^T with orthonormal n_i = vector[i], unsorted. T is double or Pack.
template <class T, std::size_t D>
struct Eigenpairs {
  std::array<T, D> value;
  Small<T, D> vector;
};

/// Returns the eigenpairs by Jacobi's cyclic rotations (Golub and Van Loan 2013, section 8.5), exact to rounding errors
/// of |A|, whether eigenvalues are equal or not. Rotations of all lanes of a pack are done together.
template <class T, std::size_t D>
Eigenpairs<T, D> eigenpairs(Small<T, D> a) {
  using std::abs;
  using std::sqrt;
  Small<T, D> rows{};
  for (std::size_t i = 0; i < D; ++i) rows[i][i] = T(1.0);
  const auto rotate = [&](std::size_t p, std::size_t q) {
    // t = tan of the angle; no quotient of 0 by 0 if A is diagonal.
    const T difference = a[q][q] - a[p][p], twice = 2.0 * a[p][q];
    const T sign = select(difference < 0.0, T(-1.0), T(1.0));
    const T length = abs(difference) + sqrt(T(difference * difference + twice * twice));
    const T t = sign * twice / select(length > 0.0, length, T(1.0));
    const T c = 1.0 / sqrt(T(1.0 + t * t)), s = t * c;
    const T shift = t * a[p][q];
    a[p][p] -= shift;
    a[q][q] += shift;
    a[p][q] = a[q][p] = T(0.0);
    for (std::size_t k = 0; k < D; ++k) {
      if (k != p && k != q) {
        const T kp = a[k][p], kq = a[k][q];
        a[k][p] = a[p][k] = c * kp - s * kq;
        a[k][q] = a[q][k] = s * kp + c * kq;
      }
      const T np = rows[p][k], nq = rows[q][k];
      rows[p][k] = c * np - s * nq;
      rows[q][k] = s * np + c * nq;
    }
  };
  if constexpr (D == 2) {
    rotate(0, 1);
  } else {
    constexpr int sweeps = D == 3 ? 8 : 20;  // convergence is quadratic; 4 or 5 are needed for 3, 6 to 8 for 6 rows
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      T rest(0.0), size(0.0);
      for (std::size_t p = 0; p < D; ++p)
        for (std::size_t q = p + 1; q < D; ++q) rotate(p, q);
      for (std::size_t p = 0; p < D; ++p) {
        size += abs(a[p][p]);
        for (std::size_t q = p + 1; q < D; ++q) rest += abs(a[p][q]);
      }
      if (everywhere(rest <= 1e-17 * size)) break;
    }
  }
  Eigenpairs<T, D> result;
  for (std::size_t i = 0; i < D; ++i) result.value[i] = a[i][i];
  result.vector = rows;
  return result;
}

}  // namespace ixos
