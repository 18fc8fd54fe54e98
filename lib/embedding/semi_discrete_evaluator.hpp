/// The semi-discrete model for the time integrators of other libraries.
#pragma once
#include <Thyra_StateFuncModelEvaluatorBase.hpp>
#include <memory>
#include <string>
#include <vector>

#include "embedding/semi_discrete_balance.hpp"
#include "embedding/semi_discrete_responses.hpp"
#include "embedding/semi_discrete_tangent.hpp"
#include "model/model.hpp"
#include "solve/choice/linear_solver.hpp"
#include "solve/thyra.hpp"

namespace ixos {

/// f(x'', x', x, t) = M x'' + C x' + f_v(x, x') + f_el(x) + f_c(x) - f_ext(t) as a Thyra model evaluator, x
/// displacements [L0], f nodal forces [E0 L0^(D-1)]. x'' and x' may be null, which stands for zero. Thyra leaves
/// W_x_dot_dot_coeff of fresh InArgs uninitialised: set it. Without a time in the InArgs t is 0.
///
/// | output | value | if x is inadmissible (an inverted element, a gap <= 0) |
/// |---|---|---|
/// | f | the balance; x - u_bar(t) in rows of constrained degrees of freedom | NaN |
/// | W_op | W_x_dot_dot_coeff M + alpha C + beta K; see below | NaN |
/// | W_prec | a preconditioner of W_op | stays as it was; unusable if it belongs to the W_op of this call |
/// | g_j | see Response | NaN |
/// | DgDx, DgDx_dot of g_0 | gradients of the energies: a column for each component | NaN |
///
/// W has beta (W_x_dot_dot_coeff if beta is 0) on the diagonal of constrained degrees of freedom and zeros in their
/// rows and columns: start Newton's method from an x that meets them. K is df/dx of elasticity, interactions and
/// viscosity. Only g_0 has derivatives. isFailed() of the caller's OutArgs stays false, because Thyra evaluates a copy
/// of them: test f, g or the norm of W for NaN.
///
/// If W_op and W_prec are evaluated together, W_prec refers to that W_op and reads it at each application; alone it has
/// its own operator. Every evaluation renews it, a multigrid on the prolongators of its first matrix. Throws
/// std::runtime_error if the matrix cannot be factored, std::logic_error for operators of another version of the
/// discretization. Operators and preconditioners apply to MultiVectors of any number of columns.
///
/// The model must outlive the evaluator. All functions are collective, except those that return spaces and names.
class SemiDiscreteEvaluator final : public Thyra::StateFuncModelEvaluatorBase<double> {
 public:
  using Factory = Teuchos::RCP<const Thyra::LinearOpWithSolveFactoryBase<double>>;
  using LinearOp = Teuchos::RCP<Thyra::LinearOpBase<double>>;
  using InArgs = Thyra::ModelEvaluatorBase::InArgs<double>;
  using OutArgs = Thyra::ModelEvaluatorBase::OutArgs<double>;

  /// Without a linear solver get_W_factory() is null, and the caller solves with W_op by other means. W_prec is
  /// not offered. Both constructors throw InputError if a law or a material has a history: the evaluator has no steps
  /// to follow.
  explicit SemiDiscreteEvaluator(const Model& model, Factory linear_solver = Teuchos::null);

  /// With Ixos' linear solvers: get_W_factory() is the list's solver with its kept preconditioner, which also accepts a
  /// W_prec; W_prec is offered if the list has a preconditioner; W_op is matrix-free if the list asks for that.
  /// `reactions`: the node sets of g_3; without any there are only g_0 to g_2. Constraints are added to the model
  /// before. Throws InputError for such a set without prescribed displacements, and if a term cannot be applied
  /// matrix-free.
  SemiDiscreteEvaluator(const Model& model, std::shared_ptr<const LinearSolverFactory> linear_solver,
                        const std::vector<std::string>& reactions = {});

  VectorSpace get_x_space() const override { return space_; }
  VectorSpace get_f_space() const override { return space_; }
  InArgs createInArgs() const override { return in_; }
  InArgs getNominalValues() const override { return nominal_; }
  Factory get_W_factory() const override { return strategy_; }
  LinearOp create_W_op() const override;
  /// Null if the evaluator has no preconditioner.
  Teuchos::RCP<Thyra::PreconditionerBase<double>> create_W_prec() const override;
  VectorSpace get_g_space(int j) const override { return responses_.space(j); }
  Teuchos::ArrayView<const std::string> get_g_names(int j) const override;

  /// Return derivatives of the balance in all rows and columns, also those of constrained degrees of freedom: M,
  /// applied without a matrix, and new matrices of C = df/dx' and of K = df/dx at x, x'. x and x' are those of the
  /// InArgs, whose other values do not count.
  LinearOp mass() const;
  LinearOp damping(const InArgs& in) const { return unconstrained(in, {0, 1, 0}); }
  LinearOp stiffness(const InArgs& in) const { return unconstrained(in, {0, 0, 1}); }
  /// Returns W of the InArgs' coefficients likewise, as a new matrix.
  LinearOp unconstrained_W(const InArgs& in) const { return unconstrained(in, weights(in)); }

  /// Sets `force`, on the x-space, to one part of the balance, in rows of constrained degrees of freedom too. The
  /// balance adds all parts but External, which it subtracts. Returns whether x is admissible; if it is not, the
  /// parts that depend on x are NaN.
  bool nodal_force(NodalForce part, const InArgs& in, const Teuchos::Ptr<Thyra::VectorBase<double>>& force) const;

 private:
  OutArgs createOutArgsImpl() const override { return out_; }
  void evalModelImpl(const InArgs& in, const OutArgs& out) const override;
  void make_arguments(bool preconditioned);
  void enter(const InArgs& in) const;
  static TangentWeights weights(const InArgs& in);
  void evaluate_W(const InArgs& in, const LinearOp& op) const;
  void evaluate_preconditioner(const InArgs& in, const OutArgs& out) const;
  void evaluate_gradients(const OutArgs& out) const;
  void fail(const OutArgs& out) const;
  LinearOp unconstrained(const InArgs& in, const TangentWeights& weights) const;

  const Model& model_;
  std::shared_ptr<const LinearSolverFactory> linear_solver_;  ///< null if the caller gave a Thyra factory
  Factory strategy_;
  VectorSpace space_;
  SemiDiscreteResponses responses_;
  mutable SemiDiscreteBalance balance_;
  InArgs in_, nominal_;
  OutArgs out_;
};

}  // namespace ixos
