#include "solve/direct_preconditioner.hpp"

#include <Thyra_DefaultPreconditioner.hpp>
#include <Thyra_MultiVectorStdOps.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <utility>

#include "solve/factorization.hpp"
#include "solve/thyra.hpp"

namespace ixos {
namespace {

/// y = alpha A^-1 x + beta y by a factorisation.
class Inverse final : public Thyra::LinearOpBase<double> {
 public:
  void renew(const Teuchos::RCP<const Thyra::LinearOpBase<double>>& op, const Teuchos::RCP<const CrsMatrix>& matrix,
             const std::string& type) {
    op_ = op;
    if (matrix.get() != matrix_.get()) {
      factorization_ = make_factorization(type);
      factorization_->analyze(matrix);
      matrix_ = matrix;
    }
    factorization_->factor();
  }
  VectorSpace range() const override { return op_->domain(); }
  VectorSpace domain() const override { return op_->range(); }

 private:
  bool opSupportedImpl(Thyra::EOpTransp transpose) const override { return transpose == Thyra::NOTRANS; }
  void applyImpl(const Thyra::EOpTransp, const Thyra::MultiVectorBase<double>& x,
                 const Teuchos::Ptr<Thyra::MultiVectorBase<double>>& y, const double alpha,
                 const double beta) const override {
    const auto source = Extract::getConstTpetraMultiVector(Teuchos::rcpFromRef(x));
    const auto target = Extract::getTpetraMultiVector(Teuchos::rcpFromPtr(y));
    if (beta == 0) {
      factorization_->solve(*source, *target);
      if (alpha != 1) target->scale(alpha);
      return;
    }
    MultiVector solution(target->getMap(), target->getNumVectors());
    factorization_->solve(*source, solution);
    target->update(alpha, solution, beta);
  }

  Teuchos::RCP<const Thyra::LinearOpBase<double>> op_;
  Teuchos::RCP<const CrsMatrix> matrix_;
  std::unique_ptr<Factorization> factorization_;
};

using Holder = Thyra::DefaultPreconditioner<double>;

}  // namespace

bool DirectPreconditionerFactory::isCompatible(const Source& source) const { return !matrix_of(source).is_null(); }

Teuchos::RCP<DirectPreconditionerFactory::Preconditioner> DirectPreconditionerFactory::createPrec() const {
  const Teuchos::RCP<Thyra::LinearOpBase<double>> inverse = Teuchos::rcp(new Inverse);
  return Teuchos::rcp(new Holder(inverse));
}

void DirectPreconditionerFactory::initializePrec(const Teuchos::RCP<const Source>& source,
                                                 Preconditioner* preconditioner, const Thyra::ESupportSolveUse) const {
  const auto inverse = Teuchos::rcp_dynamic_cast<Inverse>(preconditioner->getNonconstUnspecifiedPrecOp(), true);
  inverse->renew(source->getOp(), matrix_of(*source),
                 list_.is_null() ? "CHOLMOD" : list_->get<std::string>("Solver Type", "CHOLMOD"));
}

void DirectPreconditionerFactory::uninitializePrec(Preconditioner*, Teuchos::RCP<const Source>*,
                                                   Thyra::ESupportSolveUse*) const {}

void DirectPreconditionerFactory::setParameterList(const List& list) {
  list->validateParametersAndSetDefaults(*getValidParameters());
  list_ = list;
}

Teuchos::RCP<const Teuchos::ParameterList> DirectPreconditionerFactory::getValidParameters() const {
  return factorization_parameters();
}

}  // namespace ixos
