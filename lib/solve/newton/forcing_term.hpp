/// The accuracy to which each of Newton's linear systems is solved.
#pragma once

namespace ixos {

/// Eisenstat and Walker (1996), choice 2: the relative residual eta_k = 0.9 (|f_k|/|f_k-1|)^2 of the linear solve
/// follows what the last step gained, so that far from the solution little is spent and the convergence stays
/// quadratic. The first step of a solve and steps that gain little get `first`; no step is solved beyond what the last
/// one needs, a tenth of the bound on |f|.
class ForcingTerm {
 public:
  /// Returns the tolerance of the linear solve of iteration `iteration` (from 0) at residual norm |f|, which is to come
  /// below `bound`.
  double operator()(int iteration, double norm, double bound);

 private:
  double previous_norm_ = 0;
};

}  // namespace ixos
