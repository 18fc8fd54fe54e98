#include "solve/iterative/sparing_preconditioner.hpp"

#include <Thyra_DefaultPreconditioner.hpp>
#include <Thyra_LinearOpBase.hpp>
#include <Thyra_MultiVectorStdOps.hpp>
#include <Thyra_VectorSpaceBase.hpp>
#include <Thyra_VectorStdOps.hpp>
#include <utility>

namespace ixos {
namespace {

using Op = Thyra::LinearOpBase<double>;

class SparingInverse final : public Op {
 public:
  SparingInverse(Teuchos::RCP<const Op> inverse, std::shared_ptr<const double> bound)
      : inverse_(std::move(inverse)), bound_(std::move(bound)) {}
  Teuchos::RCP<const Thyra::VectorSpaceBase<double>> range() const override { return inverse_->range(); }
  Teuchos::RCP<const Thyra::VectorSpaceBase<double>> domain() const override { return inverse_->domain(); }

 private:
  bool opSupportedImpl(Thyra::EOpTransp transpose) const override { return Thyra::opSupported(*inverse_, transpose); }
  void applyImpl(const Thyra::EOpTransp transpose, const Thyra::MultiVectorBase<double>& x,
                 const Teuchos::Ptr<Thyra::MultiVectorBase<double>>& y, const double alpha,
                 const double beta) const override {
    if (!converged(x)) return Thyra::apply(*inverse_, transpose, x, y, alpha, beta);
    Thyra::scale(beta, y);
    Thyra::update(alpha, x, y);
  }
  bool converged(const Thyra::MultiVectorBase<double>& x) const {
    return *bound_ > 0 && x.domain()->dim() == 1 && Thyra::norm_2(*x.col(0)) < *bound_;
  }

  Teuchos::RCP<const Op> inverse_;
  std::shared_ptr<const double> bound_;
};

}  // namespace

Teuchos::RCP<const Thyra::PreconditionerBase<double>> sparing_preconditioner(
    const Teuchos::RCP<const Thyra::PreconditionerBase<double>>& given, std::shared_ptr<const double> bound) {
  const auto inverse = given->getUnspecifiedPrecOp();
  if (inverse.is_null()) return given;
  return Thyra::unspecifiedPrec<double>(Teuchos::rcp<const Op>(new SparingInverse(inverse, std::move(bound))));
}

}  // namespace ixos
