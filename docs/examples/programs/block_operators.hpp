// Operators and preconditioners of two fields, the ball and the wall of two_fields.cpp.
#pragma once
#include <Thyra_DefaultBlockedLinearOp.hpp>
#include <Thyra_DefaultPreconditioner.hpp>
#include <Thyra_MultiVectorStdOps.hpp>
#include <utility>

using LinearOp = Teuchos::RCP<Thyra::LinearOpBase<double>>;
using Columns = Teuchos::RCP<Thyra::MultiVectorBase<double>>;
using Preconditioner = Teuchos::RCP<Thyra::PreconditionerBase<double>>;
using Space = Teuchos::RCP<const Thyra::VectorSpaceBase<double>>;

/// Returns an operator with one diagonal block for the ball, one for the wall.
inline LinearOp blocks(const Space& space) {
  const auto op = Thyra::defaultBlockedLinearOp<double>();
  const auto product = Teuchos::rcp_dynamic_cast<const Thyra::ProductVectorSpaceBase<double>>(space, true);
  op->beginBlockFill(product, product);
  return op;
}
inline Thyra::DefaultBlockedLinearOp<double>& as_blocks(const LinearOp& op) {
  return *Teuchos::rcp_dynamic_cast<Thyra::DefaultBlockedLinearOp<double>>(op, true);
}

/// W_prec of both fields: the ball's own, and the wall's Schur complement, a number.
class BlockPreconditioner final : public Thyra::DefaultPreconditioner<double> {
 public:
  BlockPreconditioner(Preconditioner ball, const Space& space, const Space& wall)
      : ball_(std::move(ball)), space_(space), inverse_(Thyra::createMembers(wall, 1)) {}

  Preconditioner ball() const { return ball_; }
  void set(double schur_complement) {
    Thyra::assign(inverse_.ptr(), 1 / schur_complement);
    const LinearOp op = blocks(space_);
    as_blocks(op).setBlock(0, 0, ball_->getUnspecifiedPrecOp());
    as_blocks(op).setNonconstBlock(1, 1, inverse_);
    as_blocks(op).endBlockFill();
    initializeUnspecified(op);
  }

 private:
  Preconditioner ball_;
  Space space_;
  Columns inverse_;
};
