/// Strain measures that lose no digits at small strain and large rotation.
#pragma once
#include "base/small_matrix.hpp"

namespace ixos {

/// Returns A = F^T F - I = H + H^T + H^T H, for the displacement gradient H_iJ = du_i/dX_J.
template <std::size_t D, class T>
Small<T, D> green_strain_doubled(const Small<T, D>& h) {
  Small<T, D> a;
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = i; j < D; ++j) {
      a[i][j] = h[i][j] + h[j][i];
      for (std::size_t k = 0; k < D; ++k) a[i][j] += h[k][i] * h[k][j];
      a[j][i] = a[i][j];
    }
  return a;
}

template <std::size_t D, class T>
T trace(const Small<T, D>& m) {
  T sum = m[0][0];
  for (std::size_t i = 1; i < D; ++i) sum += m[i][i];
  return sum;
}

/// Returns the second invariant I2 of a symmetric A, the sum of its principal minors (plane strain: A_33 = 0).
template <class T>
T second_invariant(const Small<T, 2>& a) {
  return determinant(a);
}

template <class T>
T second_invariant(const Small<T, 3>& a) {
  return a[0][0] * a[1][1] - a[0][1] * a[1][0] + a[1][1] * a[2][2] - a[1][2] * a[2][1] + a[0][0] * a[2][2] -
         a[0][2] * a[2][0];
}

/// Returns the sum I2 + I3 of the second and third invariant of A (plane strain: A_33 = 0, I3 = 0).
template <class T>
T higher_invariants(const Small<T, 2>& a) {
  return determinant(a);
}

template <class T>
T higher_invariants(const Small<T, 3>& a) {
  const T i2 = a[0][0] * a[1][1] - a[0][1] * a[1][0] + a[1][1] * a[2][2] - a[1][2] * a[2][1] + a[0][0] * a[2][2] -
               a[0][2] * a[2][0];
  return i2 + determinant(a);
}

/// Returns F = I + H.
template <std::size_t D, class T>
Small<T, D> deformation_gradient(const Small<T, D>& h) {
  Small<T, D> f = h;
  for (std::size_t i = 0; i < D; ++i) f[i][i] += 1.0;
  return f;
}

/// Returns the symmetric part of F^T G.
template <std::size_t D, class T>
Small<T, D> symmetric_product(const Small<T, D>& f, const Small<T, D>& g) {
  Small<T, D> result;
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = i; j < D; ++j) {
      T sum = f[0][i] * g[0][j] + f[0][j] * g[0][i];
      for (std::size_t k = 1; k < D; ++k) sum += f[k][i] * g[k][j] + f[k][j] * g[k][i];
      result[i][j] = result[j][i] = 0.5 * sum;
    }
  return result;
}

/// Returns E(H0 + dH) - E(H0) from the change dH of the displacement gradient, without loss of digits if it is small.
template <std::size_t D, class T>
Small<T, D> change_of_strain(const Small<T, D>& h0, const Small<T, D>& dh) {
  Small<T, D> middle = deformation_gradient(h0);
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) middle[i][j] += 0.5 * dh[i][j];
  return symmetric_product(middle, dh);
}

}  // namespace ixos
