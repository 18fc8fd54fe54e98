/// A NonlinearProblem as Thyra sees it.
#pragma once
#include <Thyra_StateFuncModelEvaluatorBase.hpp>

#include "solve/newton/nonlinear_problem.hpp"
#include "solve/thyra.hpp"

namespace ixos {

/// x -> f, W_op. An inadmissible x marks the outputs as failed, upon which Thyra fills f with NaN.
class ProblemEvaluator final : public Thyra::StateFuncModelEvaluatorBase<double> {
 public:
  using Factory = Teuchos::RCP<const Thyra::LinearOpWithSolveFactoryBase<double>>;
  ProblemEvaluator(NonlinearProblem& problem, Factory linear_solver);

  VectorSpace get_x_space() const override { return space_; }
  VectorSpace get_f_space() const override { return space_; }
  Thyra::ModelEvaluatorBase::InArgs<double> createInArgs() const override { return in_; }
  Thyra::ModelEvaluatorBase::InArgs<double> getNominalValues() const override { return in_; }
  Factory get_W_factory() const override { return linear_solver_; }
  Teuchos::RCP<Thyra::LinearOpBase<double>> create_W_op() const override;

 private:
  Thyra::ModelEvaluatorBase::OutArgs<double> createOutArgsImpl() const override { return out_; }
  void evalModelImpl(const Thyra::ModelEvaluatorBase::InArgs<double>& in,
                     const Thyra::ModelEvaluatorBase::OutArgs<double>& out) const override;

  NonlinearProblem& problem_;
  Factory linear_solver_;
  VectorSpace space_;
  Thyra::ModelEvaluatorBase::InArgs<double> in_;
  Thyra::ModelEvaluatorBase::OutArgs<double> out_;
};

}  // namespace ixos
