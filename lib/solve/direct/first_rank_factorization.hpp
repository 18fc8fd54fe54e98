/// The factorisations that the first rank makes and applies alone.
#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include "solve/direct/collected_matrix.hpp"
#include "solve/direct/factorization.hpp"

namespace ixos {

/// A factorisation of a matrix that is collected on the first rank, which can run whole Krylov solves without a
/// message, see collected_cg().
class FirstRankFactorization : public Factorization {
 public:
  /// Returns the matrix. It has no values before the first refresh().
  virtual CollectedMatrix& collected() = 0;
  /// Returns A^-1 b, which is valid until the next call. On the first rank only.
  virtual const double* solve_collected(const double* b) = 0;
  /// Sets x = A^-1 b for several columns. On the first rank only.
  virtual void solve_collected(const std::vector<const double*>& b, const std::vector<double*>& x) {
    for (std::size_t k = 0; k < b.size(); ++k) std::copy_n(solve_collected(b[k]), collected().size(), x[k]);
  }

  void solve(const MultiVector& b, MultiVector& x) final {
    collected().solve(b, x, [this](const std::vector<const double*>& from, const std::vector<double*>& to) {
      solve_collected(from, to);
    });
  }
};

}  // namespace ixos
