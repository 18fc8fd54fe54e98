// Newton's method on equations of one unknown each, whose iterates have closed forms.
#include "solve/newton.hpp"

#include <gtest/gtest.h>

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>
#include <cmath>
#include <functional>

#include "support/refusal.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::world;

/// Value and derivative of the equation of unknown `id` at x; NaN where x is inadmissible.
using Equation = std::function<std::pair<double, double>(double id, double x)>;

/// The same equation for each of seven unknowns, spread over the ranks; |f| must come below the tolerance itself.
class Diagonal final : public NonlinearProblem {
 public:
  explicit Diagonal(Equation equation)
      : equation_(std::move(equation)), map_(Teuchos::rcp(new Map(Tpetra::global_size_t{7}, 0, world()))) {}

  Teuchos::RCP<const Map> map() const override { return map_; }
  Teuchos::RCP<Operator> create_operator() override {
    const auto matrix = Teuchos::rcp(new CrsMatrix(map_, 1));
    for (LocalId i = 0; i < size(); ++i) {
      const GlobalId id = map_->getGlobalElement(i);
      matrix->insertGlobalValues(id, Teuchos::tuple<GlobalId>(id), Teuchos::tuple<double>(1.0));
    }
    matrix->fillComplete();
    return matrix;
  }
  bool residual(const Vector& x, Vector& f) override {
    const auto from = x.getLocalViewHost(Tpetra::Access::ReadOnly);
    const auto to = f.getLocalViewHost(Tpetra::Access::OverwriteAll);
    int inadmissible = 0, anywhere = 0;
    for (LocalId i = 0; i < size(); ++i) {
      to(i, 0) = equation_(id(i), from(i, 0)).first;
      if (std::isnan(to(i, 0))) inadmissible = 1;
    }
    Teuchos::reduceAll(*map_->getComm(), Teuchos::REDUCE_MAX, 1, &inadmissible, &anywhere);
    return anywhere == 0;
  }
  void tangent(const Vector& x, Operator& w) override {
    const auto from = x.getLocalViewHost(Tpetra::Access::ReadOnly);
    const auto values = dynamic_cast<CrsMatrix&>(w).getLocalMatrixHost().values;
    for (LocalId i = 0; i < size(); ++i) values(static_cast<std::size_t>(i)) = equation_(id(i), from(i, 0)).second;
  }
  double admissible_step(const Vector&, const Vector&) override { return 1; }
  double convergence_bound(double tolerance) const override { return tolerance; }

 private:
  LocalId size() const { return static_cast<LocalId>(Vector(map_).getLocalLength()); }
  double id(LocalId i) const { return static_cast<double>(map_->getGlobalElement(i)); }

  Equation equation_;
  Teuchos::RCP<const Map> map_;
};

struct Ending {
  NewtonResult result;
  std::vector<double> x;  ///< by unknown
};

/// Solves from x = start on.
Ending solve(const Equation& equation, double start, const NewtonOptions& options) {
  Teuchos::ParameterList list;
  list.set("Linear Solver Type", "Direct").set("Preconditioner Type", "None");
  Diagonal problem(equation);
  NewtonSolver newton(problem, LinearSolverFactory(list), options);
  Vector x(problem.map());
  x.putScalar(start);
  Ending ending{newton.solve(x), std::vector<double>(7, 0.0)};
  std::vector<double> mine(7, 0.0);
  const auto view = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (std::size_t i = 0; i < view.extent(0); ++i)
    mine[static_cast<std::size_t>(problem.map()->getGlobalElement(static_cast<LocalId>(i)))] = view(i, 0);
  Teuchos::reduceAll(*world(), Teuchos::REDUCE_SUM, 7, mine.data(), ending.x.data());
  return ending;
}

TEST(NewtonTest, SquareRootsFollowHeronsSequence) {
  const NewtonOptions options{1e-10, 100, {}};
  const Ending ending = solve([](double id, double x) { return std::pair{x * x - 2 - id, 2 * x}; }, 1.5, options);
  EXPECT_TRUE(ending.result.converged) << ending.result.reason;
  std::vector<double> heron(7, 1.5);
  const auto norm = [&heron] {
    double sum = 0;
    for (std::size_t i = 0; i < 7; ++i) sum += std::pow(heron[i] * heron[i] - 2 - static_cast<double>(i), 2);
    return std::sqrt(sum);
  };
  int iterations = 0;
  for (; norm() > 1e-10; ++iterations)
    for (std::size_t i = 0; i < 7; ++i) heron[i] = (heron[i] + (2 + static_cast<double>(i)) / heron[i]) / 2;
  EXPECT_EQ(ending.result.iterations, iterations);
  for (std::size_t i = 0; i < 7; ++i) EXPECT_NEAR(ending.x[i], heron[i], 1e-14) << i;
}

TEST(NewtonTest, ALinearProblemTakesOneIterationAndASolvedOneNone) {
  const Equation linear = [](double id, double x) { return std::pair{4 * x - id, 4.0}; };
  const Ending ending = solve(linear, 100, {1e-12, 100, {}});
  EXPECT_TRUE(ending.result.converged) << ending.result.reason;
  EXPECT_EQ(ending.result.iterations, 1);
  for (std::size_t i = 0; i < 7; ++i) EXPECT_NEAR(ending.x[i], static_cast<double>(i) / 4, 1e-13);
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
  for (; std::sqrt(7.0) * std::abs(1 - 1 / x) > 1e-12; ++iterations) x = 2 * x - x * x;
  EXPECT_EQ(ending.result.iterations, iterations);
  for (double found : ending.x) EXPECT_NEAR(found, 1, 1e-12);
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
