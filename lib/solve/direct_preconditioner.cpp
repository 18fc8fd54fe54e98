#include "solve/direct_preconditioner.hpp"

#include <Thyra_DefaultPreconditioner.hpp>
#include <Thyra_MultiVectorStdOps.hpp>
#include <Tpetra_CrsMatrix.hpp>

#include "solve/kept_state.hpp"
#include "solve/thyra.hpp"

namespace ixos {
namespace {

/// y = alpha A^-1 x + beta y by a factorisation.
class Inverse final : public Thyra::LinearOpBase<double>, public KeptState {
 public:
  Teuchos::RCP<const Thyra::LinearOpBase<double>> op;
  KeptFactorization factorization;

  VectorSpace range() const override { return op->domain(); }
  VectorSpace domain() const override { return op->range(); }
  void transfer(Record& record) override { factorization.transfer(record); }

 private:
  bool opSupportedImpl(Thyra::EOpTransp transpose) const override { return transpose == Thyra::NOTRANS; }
  void applyImpl(const Thyra::EOpTransp, const Thyra::MultiVectorBase<double>& x,
                 const Teuchos::Ptr<Thyra::MultiVectorBase<double>>& y, const double alpha,
                 const double beta) const override {
    const auto source = Extract::getConstTpetraMultiVector(Teuchos::rcpFromRef(x));
    const auto target = Extract::getTpetraMultiVector(Teuchos::rcpFromPtr(y));
    if (beta == 0) {
      factorization.solve(*source, *target);
      if (alpha != 1) target->scale(alpha);
      return;
    }
    MultiVector solution(target->getMap(), target->getNumVectors());
    factorization.solve(*source, solution);
    target->update(alpha, solution, beta);
  }
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
  inverse->op = source->getOp();
  renew(matrix_of(*source), inverse->factorization);
}

void DirectPreconditionerFactory::uninitializePrec(Preconditioner*, Teuchos::RCP<const Source>*,
                                                   Thyra::ESupportSolveUse*) const {}

}  // namespace ixos
