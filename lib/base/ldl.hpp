/// Small symmetric systems, unrolled: no pivoting, meant for positive definite matrices.
#pragma once
#include <array>
#include <cstddef>

#include "base/pack.hpp"
#include "base/small_matrix.hpp"

namespace ixos {

/// K = L D L^T of the lower triangle of a matrix, over any scalar type.
template <class T, std::size_t N>
class Ldl {
 public:
  explicit Ldl(const Small<T, N>& k) : lower_(k), least_pivot_(k[0][0]) {
    for (std::size_t c = 0; c < N; ++c) {
      std::array<T, N> scaled;  // row c of L D
      T pivot = lower_[c][c];
      for (std::size_t m = 0; m < c; ++m) {
        scaled[m] = lower_[c][m] * pivot_[m];
        pivot -= scaled[m] * lower_[c][m];
      }
      least_pivot_ = smaller(least_pivot_, pivot);
      pivot_[c] = pivot;
      inverse_pivot_[c] = 1.0 / pivot;
      for (std::size_t r = c + 1; r < N; ++r) {
        T sum = lower_[r][c];
        for (std::size_t m = 0; m < c; ++m) sum -= lower_[r][m] * scaled[m];
        lower_[r][c] = sum * inverse_pivot_[c];
      }
    }
  }

  /// Returns the least entry of D: K is positive definite if that is positive. A NaN may count as either.
  const T& least_pivot() const { return least_pivot_; }
  /// Returns 1/D_r.
  const T& inverse_pivot(std::size_t r) const { return inverse_pivot_[r]; }

  /// Sets x = K^-1 x.
  void solve(std::array<T, N>& x) const {
    forward(x);
    for (std::size_t r = 0; r < N; ++r) x[r] *= inverse_pivot_[r];
    for (std::size_t r = N; r-- > 0;)
      for (std::size_t m = r + 1; m < N; ++m) x[r] -= lower_[m][r] * x[m];
  }
  /// Sets x = L^-1 x.
  void forward(std::array<T, N>& x) const {
    for (std::size_t r = 0; r < N; ++r)
      for (std::size_t m = 0; m < r; ++m) x[r] -= lower_[r][m] * x[m];
  }

 private:
  Small<T, N> lower_;  ///< L below the diagonal
  std::array<T, N> pivot_, inverse_pivot_;
  T least_pivot_;
};

}  // namespace ixos
