/// State that linear solvers keep from one matrix to the next, for checkpoints. Included by lib/solve only.
#pragma once
#include <Teuchos_RCP.hpp>
#include <Thyra_VectorBase.hpp>
#include <memory>

#include "base/record.hpp"

namespace ixos {

/// An operator whose solves depend on more than its present matrix: on the matrix from which a preconditioner or the
/// order of pivots was made, and on counts. After loading, it rebuilds that state with the first matrix.
class KeptState {
 public:
  virtual ~KeptState() = default;
  /// Collective.
  virtual void transfer(Record& record) = 0;
  /// Sets `step` to about A^-1 residual, A the matrix of the last solve, by one application of what is kept. The error
  /// of x - step is less than that of x. Returns false, on all ranks alike, if nothing kept serves. Collective.
  virtual bool correction(const Thyra::VectorBase<double>& /*residual*/, Thyra::VectorBase<double>& /*step*/) const {
    return false;
  }
};

/// A Thyra factory that knows the operator that it made last.
class StateKeeper {
 public:
  virtual ~StateKeeper() = default;
  Teuchos::RCP<KeptState> latest() const { return latest_.create_strong(); }
  /// Sets the family of the following matrices, see NonlinearProblem::family().
  void choose_family(int family) const { *family_ = family; }

 protected:
  template <class Op>
  Teuchos::RCP<Op> keep(const Teuchos::RCP<Op>& op) const {
    latest_ = op.create_weak();
    return op;
  }
  std::shared_ptr<const int> family() const { return family_; }

 private:
  mutable Teuchos::RCP<KeptState> latest_;  ///< weak
  std::shared_ptr<int> family_ = std::make_shared<int>(0);
};

}  // namespace ixos
