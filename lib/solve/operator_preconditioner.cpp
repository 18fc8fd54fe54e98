#include "solve/operator_preconditioner.hpp"

#include <Thyra_DefaultLinearOpSource.hpp>
#include <Thyra_SpmdVectorSpaceBase.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <cstdlib>
#if __has_include(<Tpetra_Details_Random.hpp>)
#include <Tpetra_Details_Random.hpp>
#define IXOS_TPETRA_HAS_POOL
#endif

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

/// Restarts the random numbers of Tpetra's vectors. Those of the C library seed them: in Trilinos 13.2 each vector's,
/// in later versions a pool's, which lives as long as the process.
void restart_random_numbers([[maybe_unused]] const Thyra::VectorSpaceBase<double>& space) {
  std::srand(1);
#ifdef IXOS_TPETRA_HAS_POOL
  const auto* const shared = dynamic_cast<const Thyra::SpmdVectorSpaceBase<double>*>(&space);
  Tpetra::Details::Static_Random_XorShift64_Pool<Node::execution_space>::resetPool(
      shared == nullptr ? 0 : shared->getComm()->getRank());
#endif
}

}  // namespace

void initialize_preconditioner(const PreconditionerFactory& factory, bool of_matrix,
                               const Teuchos::RCP<const Thyra::LinearOpSourceBase<double>>& source,
                               Thyra::PreconditionerBase<double>& preconditioner) {
  restart_random_numbers(*source->getOp()->range());
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
