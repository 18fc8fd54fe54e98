/// The base of Ixos' preconditioners behind Thyra. Included by lib/solve only.
#pragma once
#include <Thyra_DefaultPreconditioner.hpp>

#include "solve/kept_state.hpp"
#include "solve/thyra.hpp"

namespace ixos {

/// y = alpha P x + beta y on Tpetra's vectors, P for the operator `op_`, which derived classes set before the first
/// use.
class TpetraPreconditioner : public Thyra::LinearOpBase<double>, public KeptState {
 public:
  VectorSpace range() const override { return op_->domain(); }
  VectorSpace domain() const override { return op_->range(); }

 protected:
  Teuchos::RCP<const Thyra::LinearOpBase<double>> op_;

 private:
  virtual void precondition(const MultiVector& x, MultiVector& y, double alpha, double beta) const = 0;

  bool opSupportedImpl(Thyra::EOpTransp transpose) const override { return transpose == Thyra::NOTRANS; }
  void applyImpl(const Thyra::EOpTransp, const Thyra::MultiVectorBase<double>& x,
                 const Teuchos::Ptr<Thyra::MultiVectorBase<double>>& y, const double alpha,
                 const double beta) const override {
    precondition(*Extract::getConstTpetraMultiVector(Teuchos::rcpFromRef(x)),
                 *Extract::getTpetraMultiVector(Teuchos::rcpFromPtr(y)), alpha, beta);
  }
};

/// Wraps a preconditioner for a factory's createPrec(); unwrapped() returns it to initializePrec().
template <class P>
Teuchos::RCP<Thyra::PreconditionerBase<double>> wrapped_preconditioner() {
  const Teuchos::RCP<Thyra::LinearOpBase<double>> op = Teuchos::rcp(new P);
  return Teuchos::rcp(new Thyra::DefaultPreconditioner<double>(op));
}
template <class P>
P& unwrapped(Thyra::PreconditionerBase<double>& preconditioner) {
  return *Teuchos::rcp_dynamic_cast<P>(preconditioner.getNonconstUnspecifiedPrecOp(), true);
}

}  // namespace ixos
