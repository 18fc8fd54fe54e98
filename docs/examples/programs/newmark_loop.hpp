// Newmark's method on any second-order Thyra model evaluator.
#pragma once
#include <Thyra_LinearOpWithSolveFactoryHelpers.hpp>
#include <Thyra_ModelEvaluator.hpp>
#include <Thyra_VectorBase.hpp>
#include <Thyra_VectorStdOps.hpp>
#include <utility>

/// Newmark's method with beta = 1/4, gamma = 1/2 on f(a, v, u, t) = 0, unknown u. Solves with W_prec if the evaluator
/// offers one, otherwise with the W factory alone.
class NewmarkLoop {
  using InArgs = Thyra::ModelEvaluatorBase::InArgs<double>;
  using Vector = Teuchos::RCP<Thyra::VectorBase<double>>;

 public:
  /// Starts at u = 0 with this velocity at t = 0.
  NewmarkLoop(const Thyra::ModelEvaluator<double>& model, const Vector& velocity)
      : v(velocity),
        model_(model),
        w_(model.create_W_op()),
        prec_(model.create_W_prec()),
        solver_(model.get_W_factory()->createOp()) {
    for (Vector* x : {&u, &a, &f_, &du_}) {
      *x = Thyra::createMember(model.get_x_space());
      Thyra::assign(x->ptr(), 0.0);
    }
    for (int repeat = 0; repeat < 2; ++repeat) solve(1.0, 0.0, 0.0, a);  // linear in a; again for the last digits
  }

  /// The present state as InArgs, without coefficients of W.
  InArgs state() const {
    auto in = model_.createInArgs();
    in.set_x(u);
    in.set_x_dot(v);
    in.set_x_dot_dot(a);
    in.set_t(time_);
    in.set_W_x_dot_dot_coeff(0.0);
    return in;
  }

  void step(double dt) {
    const Vector u0 = u->clone_v(), v0 = v->clone_v(), a0 = a->clone_v();
    const auto kinematics = [&] {
      Thyra::assign(v.ptr(), 0.0);
      for (const auto& [factor, x] : {std::pair{2 / dt, u}, {-2 / dt, u0}, {-1.0, v0}})
        Thyra::Vp_StV(v.ptr(), factor, *x);
      Thyra::assign(a.ptr(), 0.0);
      for (const auto& [factor, x] : {std::pair{2 / dt, v}, {-2 / dt, v0}, {-1.0, a0}})
        Thyra::Vp_StV(a.ptr(), factor, *x);
    };
    time_ += dt;
    kinematics();
    for (int iteration = 0; iteration < 12; ++iteration) {
      const double change = solve(4 / (dt * dt), 2 / dt, 1.0, u);
      kinematics();
      if (change < 1e-14 * (1 + Thyra::norm_2(*u))) break;
    }
  }

  Vector u, v, a;

 private:
  /// target -= W^-1 f with W = mass M + alpha C + beta K. Returns the norm of the change.
  double solve(double mass, double alpha, double beta, const Vector& target) {
    auto in = state();
    in.set_W_x_dot_dot_coeff(mass);
    in.set_alpha(alpha);
    in.set_beta(beta);
    auto out = model_.createOutArgs();
    out.set_f(f_);
    out.set_W_op(w_);
    if (nonnull(prec_)) out.set_W_prec(prec_);
    model_.evalModel(in, out);
    if (nonnull(prec_))
      Thyra::initializePreconditionedOp<double>(*model_.get_W_factory(), w_, prec_, solver_.ptr());
    else
      Thyra::initializeOp<double>(*model_.get_W_factory(), w_, solver_.ptr());
    const Thyra::SolveCriteria<double> criteria(
        Thyra::SolveMeasureType(Thyra::SOLVE_MEASURE_NORM_RESIDUAL, Thyra::SOLVE_MEASURE_NORM_RHS), 1e-10);
    Thyra::assign(du_.ptr(), 0.0);
    Thyra::solve<double>(*solver_, Thyra::NOTRANS, *f_, du_.ptr(), Teuchos::constPtr(criteria));
    Thyra::Vp_StV(target.ptr(), -1.0, *du_);
    return Thyra::norm_2(*du_);
  }

  const Thyra::ModelEvaluator<double>& model_;
  Teuchos::RCP<Thyra::LinearOpBase<double>> w_;
  Teuchos::RCP<Thyra::PreconditionerBase<double>> prec_;  ///< or null
  Teuchos::RCP<Thyra::LinearOpWithSolveBase<double>> solver_;
  Vector f_, du_;
  double time_ = 0;
};
