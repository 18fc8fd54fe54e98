/// Numbers of eigenvalues.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

#include "base/small_matrix.hpp"

namespace ixos::test {

/// Returns how many eigenvalues of a symmetric matrix are below the bound: as many as there are negative pivots of
/// K - bound I, the largest diagonal entry first (Sylvester's law of inertia).
template <std::size_t M>
int eigenvalues_below(Small<double, M> k, double bound) {
  for (std::size_t r = 0; r < M; ++r) k[r][r] -= bound;
  std::array<bool, M> done{};
  int negative = 0;
  for (std::size_t step = 0; step < M; ++step) {
    std::size_t pivot = M;
    for (std::size_t r = 0; r < M; ++r)
      if (!done[r] && (pivot == M || std::abs(k[r][r]) > std::abs(k[pivot][pivot]))) pivot = r;
    done[pivot] = true;
    if (k[pivot][pivot] < 0) ++negative;
    for (std::size_t r = 0; r < M; ++r) {
      if (done[r]) continue;
      const double factor = k[r][pivot] / k[pivot][pivot];
      for (std::size_t c = 0; c < M; ++c)
        if (!done[c]) k[r][c] -= factor * k[pivot][c];
    }
  }
  return negative;
}

}  // namespace ixos::test
