// The merit function on pairs of coupled equations, one pair on each rank.
#include "solve/newton/incremental_potential.hpp"

#include <gtest/gtest.h>

#include <NOX_Thyra_Group.H>
#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>
#include <cmath>

#include "solve/choice/linear_solver.hpp"
#include "solve/newton/nox_vector.hpp"
#include "solve/newton/problem_evaluator.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::world;

/// f = (2 x + x^3 + t y, y - s x). With t = -s it is the gradient of x^2 + x^4/4 + y^2/2 + t x y.
class Pairs final : public NonlinearProblem {
 public:
  Pairs(double t, double s) : t_(t), s_(s), map_(Teuchos::rcp(new Map(unknown, 2, 0, world()))) {}

  Teuchos::RCP<const Map> map() const override { return map_; }
  Teuchos::RCP<Operator> create_operator() override {
    const auto matrix = Teuchos::rcp(new CrsMatrix(map_, 2));
    const GlobalId first = map_->getGlobalElement(0);
    for (GlobalId row : {first, first + 1})
      matrix->insertGlobalValues(row, Teuchos::tuple<GlobalId>(first, first + 1), Teuchos::tuple<double>(1.0, 1.0));
    matrix->fillComplete();
    return matrix;
  }
  bool residual(const Vector& x, Vector& f) override {
    const auto from = x.getLocalViewHost(Tpetra::Access::ReadOnly);
    const auto to = f.getLocalViewHost(Tpetra::Access::OverwriteAll);
    const double a = from(0, 0), b = from(1, 0);
    to(0, 0) = 2 * a + a * a * a + t_ * b;
    to(1, 0) = b - s_ * a;
    return !std::isnan(a);
  }
  void tangent(const Vector& x, Operator& w) override {
    const double a = x.getLocalViewHost(Tpetra::Access::ReadOnly)(0, 0);
    const auto values = dynamic_cast<CrsMatrix&>(w).getLocalMatrixHost().values;
    values(0) = 2 + 3 * a * a;
    values(1) = t_;
    values(2) = -s_;
    values(3) = 1;
  }
  double admissible_step(const Vector&, const Vector&) override { return 1; }
  double convergence_bound(double tolerance) const override { return tolerance; }
  bool is_gradient() const override { return t_ == -s_; }
  double way_left(const Vector&) override { return way; }
  Potential potential(const Vector& x) override {
    EXPECT_TRUE(is_gradient()) << "there is no potential to ask for";
    const auto from = x.getLocalViewHost(Tpetra::Access::ReadOnly);
    const double a = from(0, 0), b = from(1, 0), mine = a * a + a * a * a * a / 4 + b * b / 2 + t_ * a * b;
    double all = 0;
    Teuchos::reduceAll(*world(), Teuchos::REDUCE_SUM, 1, &mine, &all);
    return {all, std::abs(all)};
  }

  double way = 0;  ///< to prescribed values

 private:
  static constexpr Tpetra::global_size_t unknown = static_cast<Tpetra::global_size_t>(-1);
  double t_, s_;
  Teuchos::RCP<const Map> map_;
};

class IncrementalPotentialTest : public testing::Test {
 protected:
  IncrementalPotentialTest() : matrix_solver_(klu()) {}

  /// KLU solves with unsymmetric matrices too.
  static Teuchos::ParameterList klu() {
    Teuchos::ParameterList list;
    list.set("Linear Solver Type", "Direct").set("Preconditioner Type", "None");
    list.sublist("Linear Solver Types").sublist("Direct").set("Solver Type", "KLU");
    return list;
  }
  /// Returns the group at x = (a, b) on each rank, with f, the tangent and Newton's direction.
  Teuchos::RCP<NOX::Thyra::Group> group(Pairs& problem, double a, double b) const {
    const auto evaluator = Teuchos::rcp(new ProblemEvaluator(problem, matrix_solver_.strategy()));
    const auto start = Thyra::createMember(evaluator->get_x_space());
    fill(*Extract::getTpetraVector(start), a, b);
    const auto result = Teuchos::rcp(new NOX::Thyra::Group(NOX::Thyra::Vector(start), evaluator));
    result->computeF();
    if (std::isnan(a)) return result;
    result->computeJacobian();
    Teuchos::ParameterList solve;
    solve.set("Tolerance", 1e-10);
    result->computeNewton(solve);
    return result;
  }
  static void fill(Vector& vector, double a, double b) {
    const auto view = vector.getLocalViewHost(Tpetra::Access::OverwriteAll);
    view(0, 0) = a;
    view(1, 0) = b;
  }
  static Teuchos::RCP<NOX::Abstract::Vector> direction(const NOX::Abstract::Group& group, double a, double b) {
    const auto result = group.getX().clone(NOX::ShapeCopy);
    fill(*tpetra(*result), a, b);
    return result;
  }

  /// Expects that slope and quadratic model belong to the merit at (a, b).
  void expect_derivatives(Pairs& problem, double a, double b) const {
    const IncrementalPotential merit(problem);
    const auto here = group(problem, a, b);
    const double h = 1e-4;
    for (const auto& [u, v] : {std::pair{1.0, 0.0}, std::pair{0.0, 1.0}, std::pair{0.6, -0.8}}) {
      const auto merit_at = [&, u = u, v = v](double s) {
        return merit.computef(*group(problem, a + s * u, b + s * v));
      };
      const double difference = (8 * (merit_at(h) - merit_at(-h)) - merit_at(2 * h) + merit_at(-2 * h)) / (12 * h);
      const auto way = direction(*here, u, v);
      EXPECT_NEAR(merit.computeSlope(*way, *here), difference, 1e-9 * world()->getSize());
      const auto gradient = direction(*here, 0, 0);
      merit.computeGradient(*here, *gradient);
      EXPECT_NEAR(gradient->innerProduct(*way), difference, 1e-9 * world()->getSize());
    }
  }

  LinearSolverFactory matrix_solver_;
};

TEST_F(IncrementalPotentialTest, IsThePotentialOfAGradient) {
  Pairs problem(0.7, -0.7);
  const IncrementalPotential merit(problem);
  const auto here = group(problem, 0.8, -1.1);
  EXPECT_NEAR(merit.computef(*here), world()->getSize() * (0.64 + 0.1024 + 0.605 - 0.616), 1e-14 * world()->getSize());
  expect_derivatives(problem, 0.8, -1.1);
}

TEST_F(IncrementalPotentialTest, IsHalfTheSquareOfAResidualWithoutAPotential) {
  Pairs problem(-3, 2);
  const IncrementalPotential merit(problem);
  const auto here = group(problem, 0.8, -1.1);
  const double f[2] = {1.6 + 0.512 + 3.3, -1.1 - 1.6}, square = f[0] * f[0] + f[1] * f[1];
  EXPECT_NEAR(merit.computef(*here), world()->getSize() * square / 2, 1e-13 * world()->getSize());
  expect_derivatives(problem, 0.8, -1.1);
  // Newton's direction descends with the slope -|f|^2, and the model is zero at its end.
  EXPECT_NEAR(merit.computeSlope(here->getNewton(), *here), -world()->getSize() * square,
              1e-12 * world()->getSize() * square);
  EXPECT_NEAR(merit.computeQuadraticModel(here->getNewton(), *here), 0, 1e-12 * world()->getSize() * square);
}

TEST_F(IncrementalPotentialTest, TheMinimizerMinimizesTheModelAlongTheGradient) {
  for (const auto& [t, s] : {std::pair{0.7, -0.7}, std::pair{-3.0, 2.0}}) {
    Pairs problem(t, s);
    const IncrementalPotential merit(problem);
    const auto here = group(problem, 0.8, -1.1);
    const auto gradient = direction(*here, 0, 0), best = direction(*here, 0, 0);
    merit.computeGradient(*here, *gradient);
    merit.computeQuadraticMinimizer(*here, *best);
    const double cosine = gradient->innerProduct(*best) / (gradient->norm() * best->norm());
    EXPECT_NEAR(cosine, -1, 1e-14);
    const double least = merit.computeQuadraticModel(*best, *here);
    for (double factor : {0.9, 1.1}) {
      const auto other = best->clone(NOX::DeepCopy);
      other->scale(factor);
      EXPECT_GT(merit.computeQuadraticModel(*other, *here), least) << factor;
    }
  }
}

TEST_F(IncrementalPotentialTest, TheWayToPrescribedValuesOutweighsAll) {
  for (const auto& [t, s] : {std::pair{0.7, -0.7}, std::pair{-3.0, 2.0}}) {
    Pairs problem(t, s);
    const IncrementalPotential merit(problem);
    const auto here = group(problem, 1e3, 1e3);
    const double reached = merit.computef(*here);
    problem.way = 1e-20;
    const double nearly = merit.computef(*here);
    EXPECT_GT(nearly, 1e6 * reached);
    EXPECT_LT(merit.computeSlope(here->getNewton(), *here), -nearly);
  }
}

TEST_F(IncrementalPotentialTest, IsInfiniteWhereTheResidualFails) {
  Pairs problem(-3, 2);
  EXPECT_EQ(IncrementalPotential(problem).computef(*group(problem, NAN, 1)), INFINITY);
}

}  // namespace
}  // namespace ixos
