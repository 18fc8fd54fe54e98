// A problem of known residual and tangent, as Thyra sees it.
#include "solve/newton/problem_evaluator.hpp"

#include <gtest/gtest.h>

#include <Thyra_LinearOpWithSolveBase.hpp>
#include <Thyra_LinearOpWithSolveFactoryBase.hpp>
#include <Thyra_VectorStdOps.hpp>
#include <Tpetra_Vector.hpp>
#include <cmath>
#include <functional>

#include "solve/choice/linear_solver.hpp"
#include "support/diagonal_problem.hpp"

namespace ixos {
namespace {

using ThyraVector = Teuchos::RCP<Thyra::VectorBase<double>>;
using Value = std::function<double(double id)>;

/// x^2 = id for each unknown; inadmissible if any x is negative.
class Squares final : public test::DiagonalProblem {
 public:
  bool residual(const Vector& x, Vector& f) override {
    ++residuals;
    return DiagonalProblem::residual(x, f);
  }
  void tangent(const Vector& x, Operator& w) override {
    ++tangents;
    DiagonalProblem::tangent(x, w);
  }

  int residuals = 0, tangents = 0;  ///< evaluations

 private:
  double value(double id, double x) const override { return x < 0 ? NAN : x * x - id; }
  double slope(double /*id*/, double x) const override { return 2 * x; }
};

Teuchos::ParameterList direct() {
  Teuchos::ParameterList list;
  list.set("Linear Solver Type", "Direct").set("Preconditioner Type", "None");
  return list;
}

class ProblemEvaluatorTest : public testing::Test {
 protected:
  ThyraVector vector(const Value& value) const {
    const ThyraVector result = Thyra::createMember(evaluator_->get_x_space());
    const auto view = Extract::getTpetraVector(result)->getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t i = 0; i < view.extent(0); ++i) view(i, 0) = value(id(i));
    return result;
  }
  void expect(const ThyraVector& found, const Value& value) const {
    const auto view = Extract::getTpetraVector(found)->getLocalViewHost(Tpetra::Access::ReadOnly);
    for (std::size_t i = 0; i < view.extent(0); ++i) EXPECT_NEAR(view(i, 0), value(id(i)), 1e-14) << id(i);
  }
  double id(std::size_t i) const { return problem_.id(i); }
  /// Returns the arguments of an evaluation at x = 1 + id.
  Thyra::ModelEvaluatorBase::InArgs<double> at_one_plus_id() const {
    auto in = evaluator_->createInArgs();
    in.set_x(vector([](double id) { return 1 + id; }));
    return in;
  }

  Squares problem_;
  LinearSolverFactory linear_solvers_{direct()};
  ProblemEvaluator::Factory linear_solver_ = linear_solvers_.strategy();
  Teuchos::RCP<const ProblemEvaluator> evaluator_ = Teuchos::rcp(new ProblemEvaluator(problem_, linear_solver_));
};

TEST_F(ProblemEvaluatorTest, SpacesAndSolverAreThoseOfTheProblem) {
  EXPECT_EQ(evaluator_->get_x_space()->dim(), Squares::unknowns);
  EXPECT_TRUE(evaluator_->get_x_space()->isCompatible(*evaluator_->get_f_space()));
  EXPECT_EQ(evaluator_->get_W_factory(), linear_solver_);
  EXPECT_TRUE(evaluator_->getNominalValues().get_x().is_null());
}

TEST_F(ProblemEvaluatorTest, EvaluatesWhatIsAskedForAndNothingElse) {
  const auto in = at_one_plus_id();
  const ThyraVector f = vector([](double) { return -1; }), product = vector([](double) { return -1; });
  const auto w = evaluator_->create_W_op();
  auto residual_only = evaluator_->createOutArgs(), tangent_only = evaluator_->createOutArgs();
  residual_only.set_f(f);
  evaluator_->evalModel(in, residual_only);
  expect(f, [](double id) { return (1 + id) * (1 + id) - id; });
  EXPECT_EQ(problem_.residuals, 1);
  EXPECT_EQ(problem_.tangents, 0);
  tangent_only.set_W_op(w);
  evaluator_->evalModel(in, tangent_only);
  EXPECT_EQ(problem_.residuals, 1);
  EXPECT_EQ(problem_.tangents, 1);
  Thyra::apply(*w, Thyra::NOTRANS, *vector([](double id) { return 3 - id; }), product.ptr());
  expect(product, [](double id) { return 2 * (1 + id) * (3 - id); });
}

TEST_F(ProblemEvaluatorTest, TheFactorySolvesWithTheTangent) {
  const auto w = evaluator_->create_W();
  ASSERT_TRUE(nonnull(w));
  auto out = evaluator_->createOutArgs();
  out.set_W(w);
  evaluator_->evalModel(at_one_plus_id(), out);
  const ThyraVector x = vector([](double) { return 0; });
  const auto status = Thyra::solve<double>(*w, Thyra::NOTRANS, *vector([](double id) { return 5 - id; }), x.ptr());
  EXPECT_EQ(status.solveStatus, Thyra::SOLVE_STATUS_CONVERGED);
  expect(x, [](double id) { return (5 - id) / (2 * (1 + id)); });
}

TEST_F(ProblemEvaluatorTest, AnInadmissibleStateFillsTheResidualWithNan) {
  auto in = evaluator_->createInArgs();
  in.set_x(vector([](double id) { return id == 2 ? -1 : 1; }));  // one unknown, on one of the ranks
  const ThyraVector f = vector([](double) { return 0; });
  auto out = evaluator_->createOutArgs();
  out.set_f(f);
  evaluator_->evalModel(in, out);
  {
    const auto view = Extract::getTpetraVector(f)->getLocalViewHost(Tpetra::Access::ReadOnly);
    for (std::size_t i = 0; i < view.extent(0); ++i) EXPECT_TRUE(std::isnan(view(i, 0))) << id(i);
  }
  evaluator_->evalModel(at_one_plus_id(), out);
  expect(f, [](double id) { return (1 + id) * (1 + id) - id; });
}

}  // namespace
}  // namespace ixos
