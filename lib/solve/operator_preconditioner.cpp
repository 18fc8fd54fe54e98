#include "solve/operator_preconditioner.hpp"

#include <Thyra_DefaultLinearOpSource.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <cstdlib>

#include "base/phase_timer.hpp"

namespace ixos {
namespace {

/// An operator that hands single vectors on as multivectors of one column: MueLu's accepts nothing else.
class OnMultiVectors final : public Thyra::LinearOpBase<double> {
 public:
  explicit OnMultiVectors(Teuchos::RCP<const Thyra::LinearOpBase<double>> op) : op_(std::move(op)) {}
  VectorSpace range() const override { return op_->range(); }
  VectorSpace domain() const override { return op_->domain(); }

 private:
  bool opSupportedImpl(Thyra::EOpTransp transpose) const override { return op_->opSupported(transpose); }
  void applyImpl(const Thyra::EOpTransp transpose, const Thyra::MultiVectorBase<double>& x,
                 const Teuchos::Ptr<Thyra::MultiVectorBase<double>>& y, const double alpha,
                 const double beta) const override {
    const auto from = Thyra::createConstMultiVector<double, LocalId, GlobalId, Node>(
        Extract::getConstTpetraMultiVector(Teuchos::rcpFromRef(x)), x.range());
    const auto to = Thyra::createMultiVector<double, LocalId, GlobalId, Node>(
        Extract::getTpetraMultiVector(Teuchos::rcpFromPtr(y)), y->range());
    Thyra::apply(*op_, transpose, *from, to.ptr(), alpha, beta);
  }

  Teuchos::RCP<const Thyra::LinearOpBase<double>> op_;
};

}  // namespace

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
  const Teuchos::RCP<const Thyra::LinearOpBase<double>> made =
      Teuchos::rcp(new OnMultiVectors(made_->getUnspecifiedPrecOp()));
  initializeUnspecified(made);
}

}  // namespace ixos
