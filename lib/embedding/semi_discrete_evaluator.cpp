#include "embedding/semi_discrete_evaluator.hpp"

#include <Thyra_MultiVectorStdOps.hpp>
#include <Thyra_VectorStdOps.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <algorithm>
#include <limits>

#include "base/error.hpp"
#include "model/state_report.hpp"
#include "model/traits.hpp"
#include "solve/iterative/mass_operator.hpp"
#include "solve/operator_preconditioner.hpp"

namespace ixos {

using Base = Thyra::ModelEvaluatorBase;

namespace {

constexpr int energies = static_cast<int>(Response::Energies);

const Vector* tpetra(const Teuchos::RCP<const Thyra::VectorBase<double>>& x) {
  return x.is_null() ? nullptr : Extract::getConstTpetraVector(x).get();
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void fill(CrsMatrix& matrix, double value) {
  const auto values = matrix.getLocalMatrixHost().values;
  std::fill_n(values.data(), values.extent(0), value);
}

void copy(const std::vector<double>& from, Thyra::VectorBase<double>& to) {
  const auto view = Extract::getTpetraVector(Teuchos::rcpFromRef(to))->getLocalViewHost(Tpetra::Access::OverwriteAll);
  std::copy_n(from.data(), view.extent(0), view.data());
}

}  // namespace

SemiDiscreteEvaluator::SemiDiscreteEvaluator(const Model& model, Factory linear_solver)
    : model_(model),
      strategy_(std::move(linear_solver)),
      space_(vector_space(model.space().owned_map())),
      responses_(model, {}),
      balance_(model) {
  make_arguments(false);
}

SemiDiscreteEvaluator::SemiDiscreteEvaluator(const Model& model,
                                             std::shared_ptr<const LinearSolverFactory> linear_solver,
                                             const std::vector<std::string>& reactions)
    : model_(model),
      linear_solver_(std::move(linear_solver)),
      strategy_(linear_solver_->strategy()),
      space_(vector_space(model.space().owned_map())),
      responses_(model, reactions),
      balance_(model) {
  make_arguments(nonnull(linear_solver_->preconditioner()));
  if (linear_solver_->matrix_free()) SemiDiscreteOperator{model_};  // throws if that is not possible
}

void SemiDiscreteEvaluator::make_arguments(bool preconditioned) {
  if (has_histories(model_))
    throw InputError(
        "an interaction's law or a material has a history, which follows the steps of an Integrator; the evaluator has "
        "none");
  model_.close();
  const std::string description = "Ixos semi-discrete model";
  Base::InArgsSetup<double> in;
  in.setModelEvalDescription(description);
  for (const auto argument : {Base::IN_ARG_x, Base::IN_ARG_x_dot, Base::IN_ARG_x_dot_dot, Base::IN_ARG_t,
                              Base::IN_ARG_alpha, Base::IN_ARG_beta, Base::IN_ARG_W_x_dot_dot_coeff})
    in.setSupports(argument);
  in_ = in;
  nominal_ = in_;
  const auto zero = Thyra::createMember(space_);
  Thyra::assign(zero.ptr(), 0.0);
  nominal_.set_x(zero);
  nominal_.set_x_dot(zero);
  nominal_.set_x_dot_dot(zero);
  nominal_.set_t(0.0);
  nominal_.set_alpha(0.0);
  nominal_.set_beta(1.0);
  nominal_.set_W_x_dot_dot_coeff(0.0);
  Base::OutArgsSetup<double> out;
  out.setModelEvalDescription(description);
  out.set_Np_Ng(0, responses_.count());
  out.setSupports(Base::OUT_ARG_f);
  out.setSupports(Base::OUT_ARG_W_op);
  out.setSupports(Base::OUT_ARG_W_prec, preconditioned);
  out.setSupports(Base::OUT_ARG_DgDx, energies, Base::DERIV_MV_GRADIENT_FORM);
  out.setSupports(Base::OUT_ARG_DgDx_dot, energies, Base::DERIV_MV_GRADIENT_FORM);
  out_ = out;
}

SemiDiscreteEvaluator::LinearOp SemiDiscreteEvaluator::create_W_op() const {
  if (linear_solver_ == nullptr || !linear_solver_->matrix_free())
    return linear_op(model_.pattern().create_matrix(model_.space()), space_);
  return linear_op(Teuchos::rcp(new SemiDiscreteOperator(model_)), space_);
}

Teuchos::RCP<Thyra::PreconditionerBase<double>> SemiDiscreteEvaluator::create_W_prec() const {
  if (linear_solver_ == nullptr) return Teuchos::null;
  return linear_solver_->preconditioner();
}

Teuchos::ArrayView<const std::string> SemiDiscreteEvaluator::get_g_names(int j) const {
  const std::vector<std::string>& names = responses_.names(j);
  return {names.data(), static_cast<int>(names.size())};
}

void SemiDiscreteEvaluator::enter(const InArgs& in) const {
  balance_.set({tpetra(in.get_x()), tpetra(in.get_x_dot()), tpetra(in.get_x_dot_dot()), in.get_t()});
}

TangentWeights SemiDiscreteEvaluator::weights(const InArgs& in) {
  return {in.get_W_x_dot_dot_coeff(), in.get_alpha(), in.get_beta()};
}

void SemiDiscreteEvaluator::evalModelImpl(const InArgs& in, const OutArgs& out) const {
  enter(in);
  if (!balance_.admissible()) return fail(out);
  if (const auto f = out.get_f(); nonnull(f)) balance_.residual(*Extract::getTpetraVector(f));
  if (const auto w = out.get_W_op(); nonnull(w)) evaluate_W(in, w);
  if (out.supports(Base::OUT_ARG_W_prec) && nonnull(out.get_W_prec())) evaluate_preconditioner(in, out);
  for (int j = 0; j < responses_.count(); ++j)
    if (const auto g = out.get_g(j); nonnull(g)) responses_.evaluate(j, balance_, *Extract::getTpetraVector(g));
  evaluate_gradients(out);
}

void SemiDiscreteEvaluator::evaluate_W(const InArgs& in, const LinearOp& op) const {
  const auto tpetra_op = Extract::getTpetraOperator(op);
  const TangentWeights factors = weights(in);
  if (const auto matrix_free = Teuchos::rcp_dynamic_cast<SemiDiscreteOperator>(tpetra_op); nonnull(matrix_free))
    return matrix_free->linearize(factors, balance_.place());
  const auto matrix = Teuchos::rcp_dynamic_cast<CrsMatrix>(tpetra_op, true);
  balance_.velocity();  // the place then has it
  set_semi_discrete_tangent(model_, factors, balance_.place(), *matrix);
  if (!model_.constraints().empty())
    model_.constrained_entries().constrain(factors.constrained(), matrix->getLocalMatrixHost().values.data());
}

void SemiDiscreteEvaluator::evaluate_preconditioner(const InArgs& in, const OutArgs& out) const {
  const auto preconditioner = Teuchos::rcp_dynamic_cast<OperatorPreconditioner>(out.get_W_prec(), true);
  if (nonnull(out.get_W_op())) return preconditioner->compute(out.get_W_op());
  if (preconditioner->own_operator.is_null()) preconditioner->own_operator = create_W_op();
  evaluate_W(in, preconditioner->own_operator);
  preconditioner->compute(preconditioner->own_operator);
}

/// The gradients of kinetic, elastic and contact energy are M x' by x', and f_el and f_c by x. Springs store energy by
/// their stretch, while their driven ends are part of f_ext.
void SemiDiscreteEvaluator::evaluate_gradients(const OutArgs& out) const {
  if (const auto by_x = out.get_DgDx(energies).getMultiVector(); nonnull(by_x)) {
    Thyra::assign(by_x->col(0).ptr(), 0.0);
    std::vector<double> elastic = balance_.force(NodalForce::Elastic);
    StateReport(model_, balance_.place()).add_stretch_gradient(elastic.data());
    copy(elastic, *by_x->col(1));
    copy(balance_.force(NodalForce::Interaction), *by_x->col(2));
  }
  if (const auto by_x_dot = out.get_DgDx_dot(energies).getMultiVector(); nonnull(by_x_dot)) {
    Thyra::assign(by_x_dot.ptr(), 0.0);
    std::vector<double> momentum(balance_.velocity().size(), 0.0);
    if (model_.mass() != nullptr) model_.mass()->multiply(balance_.velocity().data(), momentum.data());
    copy(momentum, *by_x_dot->col(0));
  }
}

void SemiDiscreteEvaluator::fail(const OutArgs& out) const {
  out.setFailed();  // f and g are NaN now
  for (const auto& gradient : {out.get_DgDx(energies).getMultiVector(), out.get_DgDx_dot(energies).getMultiVector()})
    if (nonnull(gradient)) Thyra::assign(gradient.ptr(), nan);
  if (out.get_W_op().is_null()) return;
  const auto op = Extract::getTpetraOperator(out.get_W_op());
  if (const auto matrix_free = Teuchos::rcp_dynamic_cast<SemiDiscreteOperator>(op); nonnull(matrix_free))
    matrix_free->invalidate();
  else
    fill(*Teuchos::rcp_dynamic_cast<CrsMatrix>(op, true), nan);
}

SemiDiscreteEvaluator::LinearOp SemiDiscreteEvaluator::mass() const {
  return linear_op(Teuchos::rcp(new MassOperator(model_)), space_);
}

SemiDiscreteEvaluator::LinearOp SemiDiscreteEvaluator::unconstrained(const InArgs& in,
                                                                     const TangentWeights& weights) const {
  enter(in);
  const auto matrix = model_.pattern().create_matrix(model_.space());
  balance_.velocity();  // the place then has it
  set_semi_discrete_tangent(model_, weights, balance_.place(), *matrix);
  if (!balance_.admissible()) fill(*matrix, nan);
  return linear_op(matrix, space_);
}

bool SemiDiscreteEvaluator::nodal_force(NodalForce part, const InArgs& in,
                                        const Teuchos::Ptr<Thyra::VectorBase<double>>& force) const {
  enter(in);
  const bool admissible = balance_.admissible();
  copy(balance_.force(part), *force);
  const bool of_x = part != NodalForce::Inertia && part != NodalForce::External;
  if (of_x && !admissible) Thyra::assign(force, nan);
  return admissible;
}

}  // namespace ixos
