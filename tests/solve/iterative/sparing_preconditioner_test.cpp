// CG applies its preconditioner once an iteration, and finds the same solution as if it did so once more.
#include "solve/iterative/sparing_preconditioner.hpp"

#include <gtest/gtest.h>

#include <Thyra_DefaultPreconditioner.hpp>
#include <Thyra_LinearOpWithSolveFactoryHelpers.hpp>
#include <Thyra_MultiVectorStdOps.hpp>
#include <Thyra_VectorStdOps.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <algorithm>
#include <cmath>
#include <utility>

#include "solve/choice/linear_solver.hpp"
#include "solve/thyra.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using Columns = Teuchos::RCP<Thyra::MultiVectorBase<double>>;

constexpr int size = 40;

/// Divides row i by 2 + i/10, and counts how often.
class Diagonal final : public Operator {
 public:
  explicit Diagonal(Teuchos::RCP<const Map> map) : map_(std::move(map)) {}
  Teuchos::RCP<const Map> getDomainMap() const override { return map_; }
  Teuchos::RCP<const Map> getRangeMap() const override { return map_; }
  void apply(const MultiVector& x, MultiVector& y, Teuchos::ETransp, double alpha, double beta) const override {
    ++applications;
    const auto in = x.getLocalViewHost(Tpetra::Access::ReadOnly);
    const auto out = y.getLocalViewHost(Tpetra::Access::ReadWrite);
    for (std::size_t i = 0; i < out.extent(0); ++i) {
      const auto row = static_cast<double>(map_->getGlobalElement(static_cast<LocalId>(i)));
      for (std::size_t k = 0; k < out.extent(1); ++k)
        out(i, k) = (beta == 0 ? 0 : beta * out(i, k)) + alpha * in(i, k) / (2 + 0.1 * row);
    }
  }
  mutable int applications = 0;

 private:
  Teuchos::RCP<const Map> map_;
};

/// Springs along a line, held at both ends, stiffer towards the last.
Teuchos::RCP<CrsMatrix> springs(const Teuchos::RCP<const Map>& map) {
  const auto matrix = Teuchos::rcp(new CrsMatrix(map, 3));
  for (GlobalId row = 0; row < size; ++row)
    if (map->isNodeGlobalElement(row))
      for (GlobalId column = std::max<GlobalId>(row - 1, 0); column <= std::min<GlobalId>(row + 1, size - 1); ++column)
        matrix->insertGlobalValues(row, Teuchos::tuple<GlobalId>(column),
                                   Teuchos::tuple<double>(row == column ? 2.1 + 0.1 * static_cast<double>(row) : -1));
  matrix->fillComplete();
  return matrix;
}

struct SparingPreconditionerTest : testing::Test {
  Teuchos::RCP<const Map> map = Teuchos::rcp(new Map(static_cast<Tpetra::global_size_t>(size), 0, test::world()));
  VectorSpace space = vector_space(map);
  Teuchos::RCP<Diagonal> diagonal = Teuchos::rcp(new Diagonal(map));
  Teuchos::RCP<const Thyra::PreconditionerBase<double>> given =
      Thyra::unspecifiedPrec<double>(const_linear_op(diagonal, space));

  /// Returns the iterations of CG for a right-hand side of norm sqrt(40) and the solution.
  std::pair<int, Teuchos::RCP<Thyra::VectorBase<double>>> solve(bool special) const {
    Teuchos::ParameterList list;
    list.set("Linear Solver Type", "Belos").set("Preconditioner Type", "Direct");
    auto& belos = list.sublist("Linear Solver Types").sublist("Belos");
    belos.set("Solver Type", "Pseudo Block CG");
    auto& cg = belos.sublist("Solver Types").sublist("Pseudo Block CG");
    cg.set("Maximum Iterations", 100).set("Verbosity", 0);
    if (special) cg.set("Output Frequency", -1);
    const LinearSolverFactory factory(list);
    const auto strategy = factory.strategy();
    const auto solver = strategy->createOp();
    Thyra::initializePreconditionedOp<double>(*strategy, const_linear_op(springs(map), space), given, solver.ptr());
    const auto b = Thyra::createMember(space), x = Thyra::createMember(space);
    Thyra::assign(b.ptr(), 1.0);
    Thyra::assign(x.ptr(), 0.0);
    const Thyra::SolveCriteria<double> criteria(
        Thyra::SolveMeasureType(Thyra::SOLVE_MEASURE_NORM_RESIDUAL, Thyra::SOLVE_MEASURE_NORM_RHS), 1e-8);
    const auto status = Thyra::solve<double>(*solver, Thyra::NOTRANS, *b, x.ptr(), Teuchos::constPtr(criteria));
    EXPECT_EQ(status.solveStatus, Thyra::SOLVE_STATUS_CONVERGED);
    return {status.extraParameters->get<int>("Iteration Count"), x};
  }
};

TEST_F(SparingPreconditionerTest, AppliesToVectorsOfAtLeastTheBound) {
  const auto bound = std::make_shared<double>(0);
  const auto op = sparing_preconditioner(given, bound)->getUnspecifiedPrecOp();
  const auto x = Thyra::createMember(space), y = Thyra::createMember(space);
  const auto applied = [&](double norm) {
    const int before = diagonal->applications;
    Thyra::assign(x.ptr(), norm / std::sqrt(size));
    Thyra::assign(y.ptr(), 1.0);
    Thyra::apply<double>(*op, Thyra::NOTRANS, *x, y.ptr(), 2.0, 3.0);
    return diagonal->applications - before;
  };
  EXPECT_EQ(applied(0.5), 1);
  *bound = 1;
  EXPECT_EQ(applied(1.5), 1);
  EXPECT_EQ(applied(0.5), 0);
  EXPECT_NEAR(Thyra::sum(*y), size * (2 * 0.5 / std::sqrt(size) + 3), 1e-12);
  *bound = 0.25;
  EXPECT_EQ(applied(0.5), 1);
}

TEST_F(SparingPreconditionerTest, SeveralColumnsAreAlwaysPreconditioned) {
  const auto op = sparing_preconditioner(given, std::make_shared<double>(1e9))->getUnspecifiedPrecOp();
  const Columns x = Thyra::createMembers(space, 2), y = Thyra::createMembers(space, 2);
  Thyra::assign(x.ptr(), 1.0);
  Thyra::apply<double>(*op, Thyra::NOTRANS, *x, y.ptr());
  EXPECT_EQ(diagonal->applications, 1);
}

TEST_F(SparingPreconditionerTest, CGAppliesItOnceAnIteration) {
  const auto [iterations, x] = solve(false);
  EXPECT_GT(iterations, 3);
  EXPECT_EQ(diagonal->applications, iterations);
  diagonal->applications = 0;
  const auto [more, same] = solve(true);
  EXPECT_EQ(more, iterations);
  EXPECT_EQ(diagonal->applications, iterations + 1);
  Thyra::Vp_StV(same.ptr(), -1.0, *x);
  EXPECT_EQ(Thyra::norm_inf(*same), 0);
}

}  // namespace
}  // namespace ixos
