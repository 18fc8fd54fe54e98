#include "solve/iterative/chebyshev_preconditioner.hpp"

#include <Teuchos_StandardParameterEntryValidators.hpp>
#include <Tpetra_CrsMatrix.hpp>

#include "solve/iterative/chebyshev_polynomial.hpp"
#include "solve/tpetra_preconditioner.hpp"

namespace ixos {
namespace {

class Polynomial final : public TpetraPreconditioner {
 public:
  void initialize(const Teuchos::RCP<const Thyra::LinearOpBase<double>>& op, int degree, double ratio) {
    op_ = op;
    polynomial_.initialize(Extract::getConstTpetraOperator(op), {degree, ratio});
  }
  void transfer(Record& record) override { polynomial_.transfer(record); }

 private:
  void precondition(const MultiVector& b, MultiVector& target, double alpha, double beta) const override {
    target.update(alpha, polynomial_(b), beta);
  }

  ChebyshevPolynomial polynomial_;
};

}  // namespace

Teuchos::RCP<const Teuchos::ParameterList> ChebyshevPreconditionerFactory::getValidParameters() const {
  const auto list = Teuchos::rcp(new Teuchos::ParameterList("Chebyshev"));
  list->set(
      "Degree", 3,
      "Degree of the polynomial. One application takes this many of the inverse diagonal and one product with the "
      "tangent less. Odd degrees stay positive definite if the largest eigenvalue exceeds its estimate.",
      Teuchos::rcp(new Teuchos::EnhancedNumberValidator<int>(1, 100)));
  list->set("Eigenvalue Ratio", 20.0,
            "Largest ratio of the eigenvalues at the two ends of the polynomial's interval [-].",
            Teuchos::rcp(new Teuchos::EnhancedNumberValidator<double>(1.1, 1e6)));
  return list;
}

bool ChebyshevPreconditionerFactory::isCompatible(const Source& source) const {
  const auto op = Extract::getConstTpetraOperator(source.getOp());
  return nonnull(Teuchos::rcp_dynamic_cast<const AssemblableOperator>(op)) ||
         nonnull(Teuchos::rcp_dynamic_cast<const CrsMatrix>(op));
}

Teuchos::RCP<ChebyshevPreconditionerFactory::Preconditioner> ChebyshevPreconditionerFactory::createPrec() const {
  return wrapped_preconditioner<Polynomial>();
}

void ChebyshevPreconditionerFactory::initializePrec(const Teuchos::RCP<const Source>& source,
                                                    Preconditioner* preconditioner,
                                                    const Thyra::ESupportSolveUse) const {
  const auto list = list_or_defaults();
  unwrapped<Polynomial>(*preconditioner)
      .initialize(source->getOp(), list->get<int>("Degree"), list->get<double>("Eigenvalue Ratio"));
}

}  // namespace ixos
