/// Preconditioned conjugate gradients on the first rank.
#pragma once
#include <functional>

#include "base/tpetra.hpp"
#include "solve/direct/collected_matrix.hpp"

namespace ixos {

/// The outcome of a solve, the same on all ranks.
struct CollectedSolve {
  enum Status { Converged, Unconverged, NegativeCurvature, NotFinite };
  int status = Unconverged;
  int iterations = 0;
  double residual = 0;  ///< its norm relative to that of b, as the iteration updates it
};

/// Solves A x = b from x = 0 by conjugate gradients (Hestenes and Stiefel 1952), to a norm of the residual of
/// `tolerance` times that of b. Only the first rank iterates, with a symmetric preconditioner of arrays of the whole
/// length. The others wait for their part of x. A solve thus takes three collective calls, and not several an
/// iteration. The matrix must be symmetric, b and x have one column. Collective.
CollectedSolve collected_cg(CollectedMatrix& matrix, const std::function<const double*(const double*)>& precondition,
                            const MultiVector& b, MultiVector& x, double tolerance, int maximum_iterations);

}  // namespace ixos
