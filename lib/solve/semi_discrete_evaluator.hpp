/// The semi-discrete model for the time integrators of other libraries.
#pragma once
#include <Thyra_StateFuncModelEvaluatorBase.hpp>

#include "model/model.hpp"
#include "solve/linear_solver.hpp"
#include "solve/thyra.hpp"

namespace ixos {

/// f(x'', x', x, t) = M x'' + C x' + f_el(x) + f_c(x) - f_ext(t) as a Thyra model evaluator, x displacements. In: x,
/// x_dot, x_dot_dot, t, alpha, beta, W_x_dot_dot_coeff. Out: f and W_op = W_x_dot_dot_coeff M + alpha C + beta K, K the
/// elastic and interaction tangent at x. On constrained degrees of freedom f = x - u_bar(t), and W has beta
/// (W_x_dot_dot_coeff if beta is 0) on the diagonal and zeros in their rows and columns: start Newton's method from
/// an x that meets them. An inadmissible x (a gap <= 0, an inverted element) marks the outputs as failed, upon which
/// Thyra fills f with NaN. Thyra leaves W_x_dot_dot_coeff of fresh InArgs uninitialised: set it. The model must outlive
/// the evaluator. Collective.
class SemiDiscreteEvaluator final : public Thyra::StateFuncModelEvaluatorBase<double> {
 public:
  using Factory = Teuchos::RCP<const Thyra::LinearOpWithSolveFactoryBase<double>>;

  /// Without a linear solver get_W_factory() is null, and the caller solves with W_op by other means.
  explicit SemiDiscreteEvaluator(const Model& model, Factory linear_solver = Teuchos::null);

  VectorSpace get_x_space() const override { return space_; }
  VectorSpace get_f_space() const override { return space_; }
  Thyra::ModelEvaluatorBase::InArgs<double> createInArgs() const override { return in_; }
  Thyra::ModelEvaluatorBase::InArgs<double> getNominalValues() const override { return nominal_; }
  Factory get_W_factory() const override { return linear_solver_; }
  Teuchos::RCP<Thyra::LinearOpBase<double>> create_W_op() const override;

 private:
  Thyra::ModelEvaluatorBase::OutArgs<double> createOutArgsImpl() const override { return out_; }
  void evalModelImpl(const Thyra::ModelEvaluatorBase::InArgs<double>& in,
                     const Thyra::ModelEvaluatorBase::OutArgs<double>& out) const override;
  bool evaluate_force(const Thyra::ModelEvaluatorBase::InArgs<double>& in, Vector& f) const;
  bool import_rate(const Thyra::ModelEvaluatorBase::InArgs<double>& in) const;
  void evaluate_tangent(const Thyra::ModelEvaluatorBase::InArgs<double>& in, CrsMatrix& w) const;

  const Model& model_;
  Factory linear_solver_;
  VectorSpace space_;
  Thyra::ModelEvaluatorBase::InArgs<double> in_;
  Thyra::ModelEvaluatorBase::InArgs<double> nominal_;
  Thyra::ModelEvaluatorBase::OutArgs<double> out_;
  mutable std::vector<double> u_, rate_, part_, sum_;  ///< local arrays, reused from call to call
};

}  // namespace ixos
