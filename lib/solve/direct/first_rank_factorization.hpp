/// The factorisations that the first rank makes and applies alone.
#pragma once
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

  void solve(const MultiVector& b, MultiVector& x) final {
    collected().solve(b, x, [this](const double* rhs) { return solve_collected(rhs); });
  }
};

}  // namespace ixos
