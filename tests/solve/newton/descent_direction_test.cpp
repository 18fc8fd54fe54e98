// The direction of Newton's method for problems whose tangents are multiples of the identity.
#include "solve/newton/descent_direction.hpp"

#include <gtest/gtest.h>

#include <NOX.H>
#include <NOX_GlobalData.H>
#include <NOX_Thyra.H>
#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_oblackholestream.hpp>
#include <Thyra_LinearOpWithSolveBase.hpp>
#include <Thyra_LinearOpWithSolveFactoryBase.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/error.hpp"
#include "solve/newton/newton.hpp"
#include "solve/newton/nox_vector.hpp"
#include "solve/newton/problem_evaluator.hpp"
#include "support/diagonal_problem.hpp"

namespace ixos {
namespace {

using test::world;

/// Equations whose tangents can be relaxed.
class Relaxable : public test::DiagonalProblem {
 public:
  void tangent(const Vector& x, Operator& w) override {
    levels.push_back(level);
    DiagonalProblem::tangent(x, w);
  }
  bool is_gradient() const override { return gradient; }
  void relax_tangent(int wanted) override { level = wanted; }

  bool gradient = true;
  int level = 0;            ///< of the tangent's relaxation
  std::vector<int> levels;  ///< at which tangents were evaluated
};

/// f = x, and the given tangents by level; the last one serves for all higher levels. A positive tangent descends.
class Bowl : public Relaxable {
 public:
  explicit Bowl(std::vector<double> tangents) : tangents_(std::move(tangents)) {}

 private:
  double value(double /*id*/, double x) const override { return x; }
  double slope(double /*id*/, double /*x*/) const override {
    return tangents_[std::min(static_cast<std::size_t>(level), tangents_.size() - 1)];
  }
  std::vector<double> tangents_;
};

/// KLU says when a matrix is singular.
Teuchos::ParameterList klu() {
  Teuchos::ParameterList list;
  list.set("Linear Solver Type", "Direct").set("Preconditioner Type", "None");
  list.sublist("Linear Solver Types").sublist("Direct").set("Solver Type", "KLU");
  return list;
}

/// NOX's own list; NOX prints nothing.
Teuchos::RCP<Teuchos::ParameterList> silent() {
  const auto list = Teuchos::parameterList();
  const Teuchos::RCP<std::ostream> nowhere = Teuchos::rcp(new Teuchos::oblackholestream);
  list->sublist("Printing").set("Output Information", 0).set("Output Stream", nowhere).set("Error Stream", nowhere);
  return list;
}

constexpr double given_tolerance = 0.25;  ///< of linear solves

class DescentDirectionTest : public testing::Test {
 protected:
  /// Computes the direction at x = 1 + id. Returns whether there is one.
  bool compute(Relaxable& problem, double tolerance = 0) {
    const LinearSolverFactory linear_solvers(klu());
    return compute_with(problem, linear_solvers.strategy(), tolerance);
  }
  bool compute_with(test::DiagonalProblem& problem, const ProblemEvaluator::Factory& linear_solver, double tolerance) {
    const auto evaluator = Teuchos::rcp(new ProblemEvaluator(problem, linear_solver));
    const auto start = Thyra::createMember(evaluator->get_x_space());
    {
      const auto view = Extract::getTpetraVector(start)->getLocalViewHost(Tpetra::Access::OverwriteAll);
      for (std::size_t i = 0; i < view.extent(0); ++i) view(i, 0) = 1 + problem.id(i);
    }
    const auto group = Teuchos::rcp(new NOX::Thyra::Group(NOX::Thyra::Vector(start), evaluator));
    const auto nox = silent();
    const auto solver = NOX::Solver::buildSolver(group, Teuchos::rcp(new NOX::StatusTest::MaxIters(1)), nox);
    Teuchos::ParameterList list("Direction");
    list.sublist("Newton").set("Forcing Term Method", "Constant");
    list.sublist("Newton").sublist("Linear Solver").set("Tolerance", given_tolerance);
    DescentDirection direction(problem, tolerance, Teuchos::rcp(new NOX::GlobalData(nox)), list);
    group->computeF();
    result_ = group->getX().clone(NOX::ShapeCopy);
    const bool found = direction.compute(*result_, *group, *solver);
    linear_tolerance_ = list.sublist("Newton").sublist("Linear Solver").get<double>("Tolerance");
    return found;
  }
  /// Expects the direction -x / tangent.
  void expect_direction(const Relaxable& problem, double tangent, int first = 0) const {
    const auto view = tpetra(*result_)->getLocalViewHost(Tpetra::Access::ReadOnly);
    for (std::size_t i = 0; i < view.extent(0); ++i)
      if (problem.id(i) >= first) {
        EXPECT_NEAR(view(i, 0), -(1 + problem.id(i)) / tangent, 1e-13) << problem.id(i);
      }
  }

  Teuchos::RCP<NOX::Abstract::Vector> result_;
  double linear_tolerance_ = 0;
};

using Levels = std::vector<int>;

TEST_F(DescentDirectionTest, NewtonsDirectionStaysIfItDescends) {
  Bowl problem({4.0, 100.0});
  EXPECT_TRUE(compute(problem));
  expect_direction(problem, 4);
  EXPECT_EQ(problem.levels, Levels{0});
}

TEST_F(DescentDirectionTest, TheTangentIsRelaxedUntilTheDirectionDescends) {
  Bowl problem({-1.0, -0.5, 0.25, 100.0});
  EXPECT_TRUE(compute(problem));
  expect_direction(problem, 0.25);
  EXPECT_EQ(problem.levels, (Levels{0, 1, 2}));
  EXPECT_EQ(problem.level, 0) << "the next tangent is exact again";
}

TEST_F(DescentDirectionTest, ASingularTangentIsRelaxedToo) {
  Bowl problem({0.0, 0.0, 2.0});
  EXPECT_TRUE(compute(problem));
  expect_direction(problem, 2);
  EXPECT_EQ(problem.levels, (Levels{0, 1, 2}));
}

TEST_F(DescentDirectionTest, WithoutAPotentialThereIsNothingToDescend) {
  Bowl problem({-1.0, 2.0});
  problem.gradient = false;
  EXPECT_TRUE(compute(problem));
  expect_direction(problem, -1);
  EXPECT_EQ(problem.levels, Levels{0});
}

TEST_F(DescentDirectionTest, TangentsThatAllAscendGiveNoDirection) {
  Bowl problem({-1.0});
  EXPECT_FALSE(compute(problem));
  EXPECT_GT(problem.levels.size(), 2U);
  EXPECT_EQ(problem.level, 0);
}

TEST_F(DescentDirectionTest, TangentsThatAreAllSingularAreAFailureOfTheSolver) {
  Bowl problem({0.0});
  EXPECT_THROW(compute(problem), std::exception);
  EXPECT_GT(problem.levels.size(), 2U);
  EXPECT_EQ(problem.level, 0);
}

/// Throws at the first tangent.
template <class Error>
class Broken final : public Bowl {
 public:
  Broken() : Bowl({1.0}) {}
  void tangent(const Vector& x, Operator& w) override {
    Bowl::tangent(x, w);
    throw Error("the tangent");
  }
};

// A relaxed tangent would not cure what the problem throws.
TEST_F(DescentDirectionTest, ExceptionsOfTheProblemPass) {
  Broken<std::runtime_error> broken;
  EXPECT_THROW(compute(broken), std::runtime_error);
  EXPECT_EQ(broken.levels, Levels{0});
  EXPECT_EQ(broken.level, 0);
  Broken<InputError> refused;
  EXPECT_THROW(compute(refused), InputError);
  EXPECT_EQ(refused.levels, Levels{0});
}

/// A linear solver of which every solve throws.
template <class Error>
class BrokenSolve final : public Thyra::LinearOpWithSolveBase<double> {
 public:
  VectorSpace range() const override { return op->range(); }
  VectorSpace domain() const override { return op->domain(); }
  Teuchos::RCP<const Thyra::LinearOpBase<double>> op;

 private:
  bool opSupportedImpl(Thyra::EOpTransp) const override { return false; }
  void applyImpl(Thyra::EOpTransp, const Thyra::MultiVectorBase<double>&,
                 const Teuchos::Ptr<Thyra::MultiVectorBase<double>>&, double, double) const override {}
  bool solveSupportsImpl(Thyra::EOpTransp) const override { return true; }
  bool solveSupportsSolveMeasureTypeImpl(Thyra::EOpTransp, const Thyra::SolveMeasureType&) const override {
    return true;
  }
  Thyra::SolveStatus<double> solveImpl(Thyra::EOpTransp, const Thyra::MultiVectorBase<double>&,
                                       const Teuchos::Ptr<Thyra::MultiVectorBase<double>>&,
                                       const Teuchos::Ptr<const Thyra::SolveCriteria<double>>) const override {
    throw Error("the solve");
  }
};

template <class Error>
class BrokenSolver final : public Thyra::LinearOpWithSolveFactoryBase<double> {
  using Op = Thyra::LinearOpWithSolveBase<double>;
  using Source = Thyra::LinearOpSourceBase<double>;
  using List = Teuchos::RCP<Teuchos::ParameterList>;

 public:
  bool isCompatible(const Source&) const override { return true; }
  Teuchos::RCP<Op> createOp() const override { return Teuchos::rcp(new BrokenSolve<Error>); }
  void initializeOp(const Teuchos::RCP<const Source>& source, Op* op, Thyra::ESupportSolveUse) const override {
    dynamic_cast<BrokenSolve<Error>&>(*op).op = source->getOp();
  }
  void uninitializeOp(Op*, Teuchos::RCP<const Source>*, Teuchos::RCP<const Thyra::PreconditionerBase<double>>*,
                      Teuchos::RCP<const Source>*, Thyra::ESupportSolveUse*) const override {}
  void setParameterList(const List&) override {}
  List getNonconstParameterList() override { return Teuchos::null; }
  List unsetParameterList() override { return Teuchos::null; }
};

TEST_F(DescentDirectionTest, RefusalsOfTheLinearSolverPass) {
  Bowl refused({1.0});
  EXPECT_THROW(compute_with(refused, Teuchos::rcp(new BrokenSolver<InputError>), 0), InputError);
  EXPECT_EQ(refused.levels, Levels{0});
  EXPECT_EQ(refused.level, 0);
  Bowl unread({1.0});
  EXPECT_THROW(compute_with(unread, Teuchos::rcp(new BrokenSolver<FileError>), 0), FileError);
  EXPECT_EQ(unread.levels, Levels{0});
  Bowl broken({1.0});
  EXPECT_THROW(compute_with(broken, Teuchos::rcp(new BrokenSolver<std::runtime_error>), 0), std::runtime_error);
  EXPECT_GT(broken.levels.size(), 2U) << "relaxed tangents are tried";
}

/// Prescribes the value of unknown 0.
class DrivenBowl final : public Bowl {
 public:
  DrivenBowl() : Bowl({3.0}) { gradient = false; }
  static constexpr double target = 0.7;
  void complete_direction(const Vector& x, Vector& direction) override {
    if (!map()->isNodeGlobalElement(0)) return;
    const auto from = x.getLocalViewHost(Tpetra::Access::ReadOnly);
    direction.getLocalViewHost(Tpetra::Access::ReadWrite)(0, 0) = target - from(0, 0);
  }
};

TEST_F(DescentDirectionTest, PrescribedValuesGoTheWholeWay) {
  DrivenBowl problem;
  EXPECT_TRUE(compute(problem));
  if (problem.map()->isNodeGlobalElement(0)) {
    EXPECT_EQ(tpetra(*result_)->getLocalViewHost(Tpetra::Access::ReadOnly)(0, 0), DrivenBowl::target - 1);
  }
  expect_direction(problem, 3, 1);
}

TEST_F(DescentDirectionTest, AToleranceHandsTheAccuracyOfLinearSolvesToTheForcingTerm) {
  Bowl problem({1.0});
  EXPECT_TRUE(compute(problem, 0));
  EXPECT_EQ(linear_tolerance_, given_tolerance);
  EXPECT_TRUE(compute(problem, 1e-9));
  EXPECT_EQ(linear_tolerance_, ForcingTerm()(0, 10.0, 1e-9)) << "that of a first iteration";
  EXPECT_NE(linear_tolerance_, given_tolerance);
}

/// The potential x^4/4 - x^2/2 has a maximum at 0 and minima at 1 and -1.
class TwoValleys final : public Relaxable {
 public:
  Potential potential(const Vector& x) override {
    double mine[2] = {}, all[2] = {};
    const auto view = x.getLocalViewHost(Tpetra::Access::ReadOnly);
    for (std::size_t i = 0; i < view.extent(0); ++i) {
      const double square = view(i, 0) * view(i, 0);
      mine[0] += square * square / 4 - square / 2;
      mine[1] += square * square / 4 + square / 2;
    }
    Teuchos::reduceAll(*world(), Teuchos::REDUCE_SUM, 2, mine, all);
    return {all[0], all[1]};
  }

 private:
  double value(double /*id*/, double x) const override { return x * x * x - x; }
  double slope(double /*id*/, double x) const override { return 3 * x * x - 1 + level; }
};

// Newton's method for x^3 - x = 0 goes from 0.1 to 0, where the potential has its maximum.
TEST_F(DescentDirectionTest, NewtonsMethodThenEndsInAMinimum) {
  for (bool gradient : {false, true}) {
    TwoValleys problem;
    problem.gradient = gradient;
    NewtonSolver newton(problem, LinearSolverFactory(klu()), {1e-10, 100, {}});
    Vector x(problem.map());
    {
      const auto view = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
      for (std::size_t i = 0; i < view.extent(0); ++i) view(i, 0) = problem.id(i) > 3 ? -0.1 : 0.1;
    }
    const NewtonResult result = newton.solve(x);
    EXPECT_TRUE(result.converged) << result.reason;
    const auto view = x.getLocalViewHost(Tpetra::Access::ReadOnly);
    for (std::size_t i = 0; i < view.extent(0); ++i)
      EXPECT_NEAR(view(i, 0), !gradient ? 0 : problem.id(i) > 3 ? -1 : 1, 1e-9) << problem.id(i);
  }
}

}  // namespace
}  // namespace ixos
