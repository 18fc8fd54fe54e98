/// A preconditioner that a model evaluator computes. Included by lib/solve only.
#pragma once
#include <Thyra_DefaultPreconditioner.hpp>
#include <Thyra_PreconditionerFactoryBase.hpp>

#include "solve/thyra.hpp"

namespace ixos {

using PreconditionerFactory = Thyra::PreconditionerFactoryBase<double>;

/// Makes the preconditioner from the operator's present values: `of_matrix` from its matrix, which a matrix-free
/// operator assembles, otherwise from the operator itself. Restarts the C library's random numbers, which seed the
/// smoothers' estimates of eigenvalues. Throws std::runtime_error if the factory finds the matrix unfit. Collective.
void initialize_preconditioner(const PreconditionerFactory& factory, bool of_matrix,
                               const Teuchos::RCP<const Thyra::LinearOpSourceBase<double>>& source,
                               Thyra::PreconditionerBase<double>& preconditioner);

/// One of Ixos' preconditioners, to be computed from an operator as often as the caller likes. It refers to the
/// operator that it was computed from. A multigrid keeps the prolongators of its first operator.
class OperatorPreconditioner final : public Thyra::DefaultPreconditioner<double> {
  using LinearOp = Teuchos::RCP<Thyra::LinearOpBase<double>>;

 public:
  OperatorPreconditioner(Teuchos::RCP<PreconditionerFactory> factory, bool of_matrix);

  /// Throws what initialize_preconditioner() throws; the preconditioner is then not usable. Collective.
  void compute(const Teuchos::RCP<const Thyra::LinearOpBase<double>>& op);

  /// An operator of this preconditioner alone, for evaluations that ask for no other; null before the first one.
  LinearOp own_operator;

 private:
  Teuchos::RCP<PreconditionerFactory> factory_;
  bool of_matrix_;
  Teuchos::RCP<Thyra::PreconditionerBase<double>> made_;
};

}  // namespace ixos
