// Newton's method on equations of one unknown each, whose iterates have closed forms.
#include "solve/newton/newton.hpp"

#include <gtest/gtest.h>

#include <Tpetra_Vector.hpp>
#include <cmath>
#include <functional>

#include "support/diagonal_problem.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

using test::world;

/// Value and derivative of the equation of unknown `id` at x; NaN where x is inadmissible.
using Equation = std::function<std::pair<double, double>(double id, double x)>;

/// A system of equations that are all alike.
class Equations final : public test::DiagonalProblem {
 public:
  explicit Equations(Equation equation, bool kinks = false) : equation_(std::move(equation)), kinks_(kinks) {}
  bool has_kinks() const override { return kinks_; }

 private:
  double value(double id, double x) const override { return equation_(id, x).first; }
  double slope(double id, double x) const override { return equation_(id, x).second; }

  Equation equation_;
  bool kinks_;
};

constexpr int unknowns = Equations::unknowns;

/// Springs, one for each unknown, with a tangent of their own.
class Springs : public test::DiagonalProblem {
 public:
  explicit Springs(double tangent) : tangent_(tangent) {}
  bool is_gradient() const override { return true; }
  Potential potential(const Vector& x) override {
    double mine = 0, all = 0;
    const auto view = x.getLocalViewHost(Tpetra::Access::ReadOnly);
    for (std::size_t i = 0; i < view.extent(0); ++i) {
      const double force = value(id(i), view(i, 0));
      mine += force * force / (2 * stiffness(id(i)));
    }
    Teuchos::reduceAll(*world(), Teuchos::REDUCE_SUM, 1, &mine, &all);
    return {all, all};
  }
  virtual double stiffness(double id) const = 0;
  virtual double load(double id) const = 0;

 private:
  double value(double id, double x) const override { return stiffness(id) * x - load(id); }
  double slope(double, double) const override { return tangent_; }

  double tangent_;
};

/// x = 3 as the minimum of (x - 3)^2/2, with a tangent that is too stiff.
class StiffSprings final : public Springs {
 public:
  using Springs::Springs;
  double stiffness(double) const override { return 1; }
  double load(double) const override { return 3; }
};

/// Three springs each of stiffness 1 and 1/5, from forces of 1 at x = 0, with the tangent I/4. The last one has no
/// force.
class Ravine final : public Springs {
 public:
  Ravine() : Springs(0.25) {}
  double stiffness(double id) const override { return id < 3 ? 1 : 0.2; }
  double load(double id) const override { return id < 6 ? 1 : 0; }
};

struct Ending {
  NewtonResult result;
  std::vector<double> x;  ///< by unknown
};

Ending solve(test::DiagonalProblem& problem, double start, const NewtonOptions& options) {
  Teuchos::ParameterList list;
  list.set("Linear Solver Type", "Direct").set("Preconditioner Type", "None");
  NewtonSolver newton(problem, LinearSolverFactory(list), options);
  Vector x(problem.map());
  x.putScalar(start);
  Ending ending{newton.solve(x), std::vector<double>(unknowns, 0.0)};
  std::vector<double> mine(unknowns, 0.0);
  const auto view = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (std::size_t i = 0; i < view.extent(0); ++i) mine[static_cast<std::size_t>(problem.id(i))] = view(i, 0);
  Teuchos::reduceAll(*world(), Teuchos::REDUCE_SUM, unknowns, mine.data(), ending.x.data());
  return ending;
}

/// Solves from x = start on.
Ending solve(const Equation& equation, double start, const NewtonOptions& options, bool kinks = false) {
  Equations problem(equation, kinks);
  return solve(problem, start, options);
}

// The force of a slip that sticks up to 0.1 and slides beyond: from x = 10, full steps lead to -10 and back.
TEST(NewtonTest, FullStepsCycleAtAKinkUnlessTheyAreShortened) {
  const Equation slip = [](double, double x) {
    const bool sticks = std::abs(x) < 0.1;
    return std::pair{(sticks ? 10 * x : std::copysign(1.0, x)) + 0.1 * x, sticks ? 10.1 : 0.1};
  };
  const NewtonOptions options{1e-10, 100, {}};
  EXPECT_FALSE(solve(slip, 10, options).result.converged);
  const Ending ending = solve(slip, 10, options, true);
  EXPECT_TRUE(ending.result.converged) << ending.result.reason;
  for (const double x : ending.x) EXPECT_NEAR(x, 0, 1e-10);
}

TEST(NewtonTest, SquareRootsFollowHeronsSequence) {
  const NewtonOptions options{1e-10, 100, {}};
  const Ending ending = solve([](double id, double x) { return std::pair{x * x - 2 - id, 2 * x}; }, 1.5, options);
  EXPECT_TRUE(ending.result.converged) << ending.result.reason;
  std::vector<double> heron(unknowns, 1.5);
  const auto norm = [&heron] {
    double sum = 0;
    for (std::size_t i = 0; i < unknowns; ++i) sum += std::pow(heron[i] * heron[i] - 2 - static_cast<double>(i), 2);
    return std::sqrt(sum);
  };
  int iterations = 0;
  for (; norm() > 1e-10; ++iterations)
    for (std::size_t i = 0; i < unknowns; ++i) heron[i] = (heron[i] + (2 + static_cast<double>(i)) / heron[i]) / 2;
  EXPECT_EQ(ending.result.iterations, iterations);
  for (std::size_t i = 0; i < unknowns; ++i) EXPECT_NEAR(ending.x[i], heron[i], 1e-14) << i;
}

// From above a root, Newton's iterates come down to it: the last one errs to one side. Another solve with the last
// residual and the last tangent takes off the error but for its share of the change of the tangent.
TEST(NewtonTest, ACorrectionTakesOffTheErrorThatTheToleranceLeaves) {
  const Equation square = [](double id, double x) { return std::pair{x * x - 2 - id, 2 * x}; };
  NewtonOptions options{1e-3, 100, {}};
  const Ending plain = solve(square, 4, options);
  options.corrects = true;
  const Ending corrected = solve(square, 4, options);
  ASSERT_TRUE(plain.result.converged && corrected.result.converged);
  EXPECT_EQ(corrected.result.iterations, plain.result.iterations);
  double before = 0, after = 0;
  for (std::size_t i = 0; i < unknowns; ++i) {
    const double root = std::sqrt(2 + static_cast<double>(i));
    EXPECT_GE(plain.x[i], root * (1 - 1e-15));
    before = std::max(before, plain.x[i] - root);
    after = std::max(after, std::abs(corrected.x[i] - root));
  }
  EXPECT_GT(before, 1e-7);
  EXPECT_LT(after, 0.03 * before);
}

TEST(NewtonTest, ALinearProblemTakesOneIterationAndASolvedOneNone) {
  const Equation linear = [](double id, double x) { return std::pair{4 * x - id, 4.0}; };
  const Ending ending = solve(linear, 100, {1e-12, 100, {}});
  EXPECT_TRUE(ending.result.converged) << ending.result.reason;
  EXPECT_EQ(ending.result.iterations, 1);
  for (std::size_t i = 0; i < unknowns; ++i) EXPECT_NEAR(ending.x[i], static_cast<double>(i) / 4, 1e-13);
  const Ending solved = solve([](double, double x) { return std::pair{x - 3, 1.0}; }, 3, {1e-12, 100, {}});
  EXPECT_TRUE(solved.result.converged);
  EXPECT_EQ(solved.result.iterations, 0);
}

TEST(NewtonTest, AnEquationWithoutASolutionIsAFailureWithAReason) {
  const Ending ending = solve([](double, double x) { return std::pair{x * x + 1, 2 * x}; }, 2, {1e-10, 30, {}});
  EXPECT_FALSE(ending.result.converged);
  EXPECT_FALSE(ending.result.reason.empty());
  // A limit that is too low says how far it came.
  const Ending short_of = solve([](double, double x) { return std::pair{x * x - 2, 2 * x}; }, 50, {1e-10, 3, {}});
  EXPECT_FALSE(short_of.result.converged);
  EXPECT_EQ(short_of.result.iterations, 3);
  test::expect_contains(short_of.result.reason, "did not converge in 3 iterations");
}

TEST(NewtonTest, AStepIntoTheInadmissibleIsHalved) {
  // 1 - 1/x for x > 0: the step from 3.5 leads to 2 x - x^2 = -5.25, half of it to -0.875, a quarter to 1.3125.
  const Ending ending = solve(
      [](double, double x) {
        return std::pair{x > 0 ? 1 - 1 / x : NAN, 1 / (x * x)};
      },
      3.5, {1e-12, 100, {}});
  EXPECT_TRUE(ending.result.converged) << ending.result.reason;
  double x = 1.3125;
  int iterations = 1;
  for (; std::sqrt(double{unknowns}) * std::abs(1 - 1 / x) > 1e-12; ++iterations) x = 2 * x - x * x;
  EXPECT_EQ(ending.result.iterations, iterations);
  for (double found : ending.x) EXPECT_NEAR(found, 1, 1e-12);
}

// With twice the stiffness, the secant finds the minimum. With ten times, the first step is lengthened to 3 and to 9
// times, where a tenth of the slope is left.
TEST(NewtonTest, StepsAreLengthenedWhileThePotentialFallsSteeply) {
  StiffSprings twice(2), ten_times(10);
  const Ending at_once = solve(twice, 0, {1e-10, 100, {}});
  EXPECT_TRUE(at_once.result.converged) << at_once.result.reason;
  EXPECT_EQ(at_once.result.iterations, 1);
  const Ending ending = solve(ten_times, 0, {1e-10, 100, {}});
  EXPECT_TRUE(ending.result.converged) << ending.result.reason;
  int iterations = 0;
  for (double error = 3; std::sqrt(double{unknowns}) * error > 1e-10; error /= 10) ++iterations;
  EXPECT_EQ(ending.result.iterations, iterations);
  for (double found : ending.x) EXPECT_NEAR(found, 3, 1e-10);
}

// Along the gradient from equal forces, the potential of two stiffnesses 1 and 1/5 is least after a step of 5/3, and
// each such step leaves 2/3 of the error, with alternate signs (Kantorovich). The full step of 4 is shortened to it.
// Two steps and the line from the start through their end lead to the minimum of a quadratic potential of two
// variables.
TEST(NewtonTest, TwoStepsInARavineLeadToItsEnd) {
  Ravine ravine;
  const Ending ending = solve(ravine, 0, {1e-10, 100, {}});
  EXPECT_TRUE(ending.result.converged) << ending.result.reason;
  EXPECT_EQ(ending.result.iterations, 2);
  for (int i = 0; i < unknowns; ++i)
    EXPECT_NEAR(ending.x[static_cast<std::size_t>(i)], ravine.load(i) / ravine.stiffness(i), 1e-10);
}

// Full steps for arctan x = 0 diverge from 3 on: the first one leads to 3 - 10 arctan 3 = -9.49. NOX's line searches
// shorten it until |f| falls. The problem has no potential.
TEST(NewtonTest, NoxOwnLineSearchesDescendTheResidualWithoutAPotential) {
  for (const char* method : {"Backtrack", "Polynomial"}) {
    NewtonOptions options{1e-12, 100, {}};
    options.nox.sublist("Line Search").set("Method", method);
    const Ending ending = solve([](double, double x) { return std::pair{std::atan(x), 1 / (1 + x * x)}; }, 3, options);
    EXPECT_TRUE(ending.result.converged) << method << ": " << ending.result.reason;
    for (double found : ending.x) EXPECT_NEAR(found, 0, 1e-12) << method;
  }
}

// The list of the user guide. Full steps for arctan x = 0 are x - (1 + x^2) arctan x: they converge from 1.3, and from
// 1.5 each is longer than the one before.
TEST(NewtonTest, AListGivesNewtonsMethodAlone) {
  NewtonOptions options{1e-12, 8, {}};
  options.nox.sublist("Direction").set("Method", "Newton");
  options.nox.sublist("Line Search").set("Method", "Full Step");
  const auto arctan = [](double, double x) { return std::pair{std::atan(x), 1 / (1 + x * x)}; };
  const Ending ending = solve(arctan, 1.3, options);
  EXPECT_TRUE(ending.result.converged) << ending.result.reason;
  double x = 1.3;
  int iterations = 0;
  for (; std::sqrt(double{unknowns}) * std::abs(std::atan(x)) > 1e-12; ++iterations) x -= (1 + x * x) * std::atan(x);
  EXPECT_EQ(ending.result.iterations, iterations);
  EXPECT_FALSE(solve(arctan, 1.5, options).result.converged);
}

TEST(NewtonTest, ListsThatNoxDoesNotKnowAreRefused) {
  const auto refusal = [](const std::function<void(Teuchos::ParameterList&)>& change) {
    NewtonOptions options;
    change(options.nox);
    return test::refusal([&] { solve([](double, double x) { return std::pair{x, 1.0}; }, 1, options); });
  };
  test::expect_contains(refusal([](Teuchos::ParameterList& nox) { nox.sublist("Line Serach"); }),
                        "did you mean \"Line Search\"?");
  test::expect_contains(
      refusal([](Teuchos::ParameterList& nox) { nox.sublist("Line Search").set("Method", "None such"); }),
      "Nonlinear Solver/NOX: ");
}

}  // namespace
}  // namespace ixos
