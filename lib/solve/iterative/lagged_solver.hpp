/// An iterative solver whose preconditioner outlives the matrix that it was made from.
#pragma once
#include <Thyra_LinearOpWithSolveFactoryBase.hpp>
#include <Thyra_PreconditionerFactoryBase.hpp>
#include <memory>

#include "solve/kept_state.hpp"
#include "solve/linear_statistics.hpp"
#include "solve/with_parameter_list.hpp"

namespace ixos {

struct LaggedOptions {
  double setup_cost = 20;    ///< the price of a new preconditioner in iterations
  bool from_scratch = true;  ///< a renewed preconditioner keeps something of its first matrix: a retry makes a new one
  bool factorizes = false;   ///< the preconditioner is a factorisation, which serves indefinite matrices too
  bool of_matrix = true;     ///< made from a matrix; else from the operator itself, and it keeps its own state
  bool restartable = true;   ///< keep the values of the matrices that the preconditioner came from, for checkpoints
  bool is_cg = false;        ///< the solver is a kind of CG, for positive definite matrices
  /// The most iterations, if the solver is CG without special settings; else 0. Such a CG becomes collected_cg() if
  /// the preconditioner is a factorisation on the first rank and the matrix is assembled.
  int cg_iterations = 0;
  bool spares_last = false;  ///< such a CG does not precondition its last residual, see sparing_preconditioner()
};

/// A wrapper of a Krylov solver and a preconditioner factory. The preconditioner is kept from solve to solve. It is
/// renewed when the iterations spent beyond its best solve (of the same family: see NonlinearProblem) add up to
/// `setup_cost`, the price of a new one in iterations: this rule costs least when iterations grow steadily. It counts
/// iterations and reads no clock, so runs repeat.
///
/// A solve that fails with an old preconditioner is tried once more with a new one, with `from_scratch` a new object (a
/// renewed multigrid keeps the prolongators of its first matrix). Throws std::runtime_error if a solve breaks down with
/// a new one, or if CG meets negative curvature: the matrix is then not positive definite, and the old preconditioner
/// is kept for the next matrix. If that matrix is not positive definite either, a new factorisation solves with it by
/// iterative refinement: the state of a body that buckles has such a tangent. The C library's random numbers seed
/// Tpetra's, and hence the smoothers' estimates of eigenvalues; they restart with each preconditioner.
class LaggedSolverFactory final : public WithParameterList<Thyra::LinearOpWithSolveFactoryBase<double>>,
                                  public StateKeeper {
  using Op = Thyra::LinearOpWithSolveBase<double>;
  using Source = Thyra::LinearOpSourceBase<double>;

 public:
  LaggedSolverFactory(Teuchos::RCP<const Thyra::LinearOpWithSolveFactoryBase<double>> krylov,
                      Teuchos::RCP<Thyra::PreconditionerFactoryBase<double>> preconditioner,
                      const LaggedOptions& options, std::shared_ptr<LinearStatistics> statistics);

  bool isCompatible(const Source& source) const override { return krylov_->isCompatible(source); }
  Teuchos::RCP<Op> createOp() const override;
  void initializeOp(const Teuchos::RCP<const Source>& source, Op* op, Thyra::ESupportSolveUse support) const override;
  /// Takes a preconditioner of the caller in place of the kept one, which is neither used nor renewed until the next
  /// initializeOp(). A failed solve is not repeated.
  bool supportsPreconditionerInputType(Thyra::EPreconditionerInputType type) const override;
  void initializePreconditionedOp(const Teuchos::RCP<const Source>& source,
                                  const Teuchos::RCP<const Thyra::PreconditionerBase<double>>& given, Op* op,
                                  Thyra::ESupportSolveUse support) const override;
  void uninitializeOp(Op* op, Teuchos::RCP<const Source>* source,
                      Teuchos::RCP<const Thyra::PreconditionerBase<double>>* preconditioner,
                      Teuchos::RCP<const Source>* approximate, Thyra::ESupportSolveUse* support) const override;

 private:
  Teuchos::RCP<const Thyra::LinearOpWithSolveFactoryBase<double>> krylov_;
  Teuchos::RCP<Thyra::PreconditionerFactoryBase<double>> preconditioner_;
  LaggedOptions options_;
  std::shared_ptr<LinearStatistics> statistics_;
};

}  // namespace ixos
