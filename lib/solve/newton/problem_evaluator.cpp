#include "solve/newton/problem_evaluator.hpp"

namespace ixos {

using Base = Thyra::ModelEvaluatorBase;

ProblemEvaluator::ProblemEvaluator(NonlinearProblem& problem, Factory linear_solver)
    : problem_(problem), linear_solver_(std::move(linear_solver)), space_(vector_space(problem.map())) {
  Base::InArgsSetup<double> in;
  in.setModelEvalDescription("Ixos stage");
  in.setSupports(Base::IN_ARG_x);
  in_ = in;
  Base::OutArgsSetup<double> out;
  out.setModelEvalDescription("Ixos stage");
  out.setSupports(Base::OUT_ARG_f);
  out.setSupports(Base::OUT_ARG_W_op);
  out_ = out;
}

Teuchos::RCP<Thyra::LinearOpBase<double>> ProblemEvaluator::create_W_op() const {
  return linear_op(problem_.create_operator(), space_);
}

void ProblemEvaluator::evalModelImpl(const Base::InArgs<double>& in, const Base::OutArgs<double>& out) const {
  const auto x = Extract::getConstTpetraVector(in.get_x());
  const Teuchos::RCP<Thyra::VectorBase<double>> f = out.get_f();
  if (nonnull(f) && !problem_.residual(*x, *Extract::getTpetraVector(f))) out.setFailed();
  const Teuchos::RCP<Thyra::LinearOpBase<double>> w = out.get_W_op();
  if (nonnull(w)) problem_.tangent(*x, *Extract::getTpetraOperator(w));
}

}  // namespace ixos
