/// Hooke's law in the reference body, of strains or of their rates.
#pragma once
#include <cstddef>

#include "base/small_matrix.hpp"
#include "material/lame.hpp"
#include "material/strain.hpp"

namespace ixos {

/// S = D : E = 2 mu E + lambda tr(E) I for symmetric tensors of the reference body, in plane strain (D = 2) or three
/// dimensions. With Green's strain E [-] and Lame's constants [E0], S is the second Piola-Kirchhoff stress of Saint
/// Venant and Kirchhoff; with its rate [1/T0] and viscosities [E0 T0], that of Kelvin and Voigt: a rigid motion has no
/// such rate, hence no stress. (Holzapfel 2000, section 6.5)
struct Hooke {
  Lame moduli;

  /// Returns S of a symmetric tensor E.
  template <std::size_t D, class T>
  Small<T, D> stress(const Small<T, D>& e) const {
    Small<T, D> s;
    const T volumetric = moduli.lambda * trace(e);
    for (std::size_t i = 0; i < D; ++i) {
      for (std::size_t j = 0; j < D; ++j) s[i][j] = 2 * moduli.mu * e[i][j];
      s[i][i] += volumetric;
    }
    return s;
  }

  /// Adds A_iJkL with dP_iJ = A_iJkL dF_kL to rows i D + J, columns k D + L, for P = F S with dS = change D : sym(G^T
  /// dF), of whose factor F dP takes the share `held` of dF: A = held delta_ik S_JL + change F D G^T.
  template <std::size_t D, class T>
  void add_moduli(const Small<T, D>& f, const Small<T, D>& g, const Small<T, D>& s, const T& held, const T& change,
                  Small<T, D * D>& result) const {
    const T mu = change * moduli.mu, lambda = change * moduli.lambda;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t k = 0; k < D; ++k) {
        T both = f[i][0] * g[k][0];
        for (std::size_t m = 1; m < D; ++m) both += f[i][m] * g[k][m];
        for (std::size_t j = 0; j < D; ++j) {
          for (std::size_t l = 0; l < D; ++l)
            result[i * D + j][k * D + l] += mu * f[i][l] * g[k][j] + lambda * f[i][j] * g[k][l];
          result[i * D + j][k * D + j] += mu * both;
          if (i == k)
            for (std::size_t l = 0; l < D; ++l) result[i * D + j][k * D + l] += held * s[j][l];
        }
      }
  }
};

}  // namespace ixos
