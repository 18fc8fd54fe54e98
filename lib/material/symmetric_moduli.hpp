/// Derivatives of symmetric tensors by symmetric tensors.
#pragma once
#include <array>
#include <cstddef>

#include "base/small_matrix.hpp"

namespace ixos {

/// The independent components IJ of a symmetric tensor, the diagonal first.
template <std::size_t D>
struct SymmetricPairs {
  static_assert(D == 2 || D == 3);
  static constexpr std::size_t size = D * (D + 1) / 2;
  static constexpr std::array<std::array<std::size_t, 2>, size> list = [] {
    std::array<std::array<std::size_t, 2>, size> result{};
    for (std::size_t i = 0; i < D; ++i) result[i] = {i, i};
    result[D] = {0, 1};
    if (D == 3) result[size - 2] = {0, 2};
    if (D == 3) result[size - 1] = {1, 2};
    return result;
  }();
  /// Returns the place of IJ or JI in the list.
  static constexpr std::size_t at(std::size_t i, std::size_t j) { return i == j ? i : D + i + j - 1; }
  /// Returns how often the component occurs in a double contraction.
  static constexpr double count(std::size_t pair) { return pair < D ? 1.0 : 2.0; }
};

/// M_IJKL with dS_IJ = M_IJKL dC_KL, row and column in the order of SymmetricPairs.
template <std::size_t D, class T>
using SymmetricModuli = Small<T, SymmetricPairs<D>::size>;

/// Sets A_iJkL = held delta_ik S_JL + 2 F_iP M_PJQL G_kQ, row i D + J, column k D + L: the derivative by a deformation
/// gradient of P = F S with dS = M : (G^T dF + dF^T G), of whose factor F dP takes the share `held` of dF.
template <std::size_t D, class T>
void push_forward(const SymmetricModuli<D, T>& m, const Small<T, D>& s, const Small<T, D>& f, const Small<T, D>& g,
                  double held, Small<T, D * D>& result) {
  using Pairs = SymmetricPairs<D>;
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) {
      std::array<T, Pairs::size> row;
      for (std::size_t c = 0; c < Pairs::size; ++c) {
        row[c] = f[i][0] * m[Pairs::at(0, j)][c];
        for (std::size_t p = 1; p < D; ++p) row[c] += f[i][p] * m[Pairs::at(p, j)][c];
        row[c] *= 2.0;
      }
      for (std::size_t k = 0; k < D; ++k)
        for (std::size_t l = 0; l < D; ++l) {
          T sum = row[Pairs::at(0, l)] * g[k][0];
          for (std::size_t q = 1; q < D; ++q) sum += row[Pairs::at(q, l)] * g[k][q];
          if (i == k) sum += held * s[j][l];
          result[i * D + j][k * D + l] = sum;
        }
    }
}

}  // namespace ixos
