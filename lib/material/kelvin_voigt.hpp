/// Kelvin and Voigt's viscosity in the reference body.
#pragma once
#include <cstddef>

#include "base/small_matrix.hpp"
#include "material/lame.hpp"
#include "material/strain.hpp"

namespace ixos {

/// S = 2 mu E' + lambda tr(E') I, the viscous part of the second Piola-Kirchhoff stress, with the rate E' of Green's
/// strain; plane strain (D = 2) or three dimensions. A rigid motion has no E', hence no stress. [E0 T0]
struct KelvinVoigt {
  Lame viscosity;  ///< alpha times Lame's constants [E0 T0]

  /// Returns S [E0] of a symmetric rate of strain [1/T0].
  template <std::size_t D, class T>
  Small<T, D> stress(const Small<T, D>& rate) const {
    Small<T, D> s;
    const T volumetric = viscosity.lambda * trace(rate);
    for (std::size_t i = 0; i < D; ++i) {
      for (std::size_t j = 0; j < D; ++j) s[i][j] = 2 * viscosity.mu * rate[i][j];
      s[i][i] += volumetric;
    }
    return s;
  }

  /// Adds A_iJkL with dP_iJ = A_iJkL dF_kL to rows i D + J, columns k D + L, for P = weight F S with
  /// dS = rate D : sym(G^T dF) and dF counted `held` times in dP: A = held delta_ik S_JL + rate F D G^T.
  template <std::size_t D, class T>
  void add_moduli(const Small<T, D>& f, const Small<T, D>& g, const Small<T, D>& s, const T& held, const T& rate,
                  Small<T, D * D>& moduli) const {
    const T mu = rate * viscosity.mu, lambda = rate * viscosity.lambda;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t k = 0; k < D; ++k) {
        T product = f[i][0] * g[k][0];
        for (std::size_t m = 1; m < D; ++m) product += f[i][m] * g[k][m];
        for (std::size_t j = 0; j < D; ++j) {
          for (std::size_t l = 0; l < D; ++l)
            moduli[i * D + j][k * D + l] += mu * f[i][l] * g[k][j] + lambda * f[i][j] * g[k][l];
          moduli[i * D + j][k * D + j] += mu * product;
          if (i == k)
            for (std::size_t l = 0; l < D; ++l) moduli[i * D + j][k * D + l] += held * s[j][l];
        }
      }
  }
};

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

/// Returns the sum of products of all entries.
template <std::size_t D, class T>
T contraction(const Small<T, D>& a, const Small<T, D>& b) {
  T sum(0.0);
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) sum += a[i][j] * b[i][j];
  return sum;
}

}  // namespace ixos
