#include "solve/operator_preconditioner.hpp"

#include <Thyra_DefaultLinearOpSource.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <cstdlib>

#include "base/phase_timer.hpp"

namespace ixos {

void initialize_preconditioner(const PreconditionerFactory& factory, bool of_matrix,
                               const Teuchos::RCP<const Thyra::LinearOpSourceBase<double>>& source,
                               Thyra::PreconditionerBase<double>& preconditioner) {
  std::srand(1);
  if (!of_matrix) return factory.initializePrec(source, &preconditioner);
  const Teuchos::RCP<const Operator> matrix = matrix_of(*source);
  factory.initializePrec(Thyra::defaultLinearOpSource(const_linear_op(matrix, source->getOp()->range())),
                         &preconditioner);
}

OperatorPreconditioner::OperatorPreconditioner(Teuchos::RCP<PreconditionerFactory> factory, bool of_matrix)
    : factory_(std::move(factory)), of_matrix_(of_matrix), made_(factory_->createPrec()) {}

void OperatorPreconditioner::compute(const Teuchos::RCP<const Thyra::LinearOpBase<double>>& op) {
  const TimedScope timed(Phase::Factorization);
  initialize_preconditioner(*factory_, of_matrix_, Thyra::defaultLinearOpSource(op), *made_);
  initializeUnspecified(made_->getUnspecifiedPrecOp());
}

}  // namespace ixos
