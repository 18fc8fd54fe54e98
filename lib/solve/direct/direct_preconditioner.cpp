#include "solve/direct/direct_preconditioner.hpp"

#include <Tpetra_CrsMatrix.hpp>

#include "solve/tpetra_preconditioner.hpp"

namespace ixos {
namespace {

/// y = alpha A^-1 x + beta y by a factorisation.
class Inverse final : public TpetraPreconditioner, public CollectedInverse {
 public:
  KeptFactorization factorization;

  void set_operator(const Teuchos::RCP<const Thyra::LinearOpBase<double>>& op) { op_ = op; }
  void transfer(Record& record) override { factorization.transfer(record); }
  FirstRankFactorization* on_first_rank() const override { return factorization.on_first_rank(); }

 private:
  void precondition(const MultiVector& x, MultiVector& y, double alpha, double beta) const override {
    if (beta == 0) {
      factorization.solve(x, y);
      if (alpha != 1) y.scale(alpha);
      return;
    }
    MultiVector solution(y.getMap(), y.getNumVectors());
    factorization.solve(x, solution);
    y.update(alpha, solution, beta);
  }
};

}  // namespace

bool DirectPreconditionerFactory::isCompatible(const Source& source) const { return !matrix_of(source).is_null(); }

Teuchos::RCP<DirectPreconditionerFactory::Preconditioner> DirectPreconditionerFactory::createPrec() const {
  return wrapped_preconditioner<Inverse>();
}

void DirectPreconditionerFactory::initializePrec(const Teuchos::RCP<const Source>& source,
                                                 Preconditioner* preconditioner, const Thyra::ESupportSolveUse) const {
  auto& inverse = unwrapped<Inverse>(*preconditioner);
  inverse.set_operator(source->getOp());
  renew(matrix_of(*source), inverse.factorization);
}

void DirectPreconditionerFactory::uninitializePrec(Preconditioner*, Teuchos::RCP<const Source>*,
                                                   Thyra::ESupportSolveUse*) const {}

}  // namespace ixos
