// Solves on the first rank for matrices of all ranks.
#include "solve/iterative/collected_cg.hpp"

#include <gtest/gtest.h>

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::world;

constexpr int size = 12;

/// Springs along a line, held at both ends: 2 + shift on the diagonal, -1 beside it.
Teuchos::RCP<CrsMatrix> springs(double shift) {
  const auto map = Teuchos::rcp(new Map(static_cast<Tpetra::global_size_t>(size), 0, world()));
  const auto matrix = Teuchos::rcp(new CrsMatrix(map, 3));
  for (GlobalId row = 0; row < size; ++row)
    if (map->isNodeGlobalElement(row))
      for (GlobalId column = std::max<GlobalId>(row - 1, 0); column <= std::min<GlobalId>(row + 1, size - 1); ++column)
        matrix->insertGlobalValues(row, Teuchos::tuple<GlobalId>(column),
                                   Teuchos::tuple<double>(row == column ? 2 + shift : -1));
  matrix->fillComplete();
  return matrix;
}

struct System {
  explicit System(double shift) : matrix(springs(shift)), whole(matrix), b(matrix->getRangeMap(), 1), x(b.getMap(), 1) {
    whole.refresh();
    for (std::size_t i = 0; i < b.getLocalLength(); ++i)
      b.replaceLocalValue(
          static_cast<LocalId>(i), 0,
          std::sin(1.0 + 0.7 * static_cast<double>(b.getMap()->getGlobalElement(static_cast<LocalId>(i)))));
    x.putScalar(7);  // of no account
  }
  /// With 1/(2 + row/10) as the preconditioner.
  CollectedSolve solve(double tolerance = 1e-12, int iterations = 50) {
    std::vector<double> z(size);
    return collected_cg(
        whole,
        [&z](const double* r) {
          for (std::size_t i = 0; i < z.size(); ++i) z[i] = r[i] / (2.0 + 0.1 * static_cast<double>(i));
          return static_cast<const double*>(z.data());
        },
        b, x, tolerance, iterations);
  }
  /// Returns |A x - b|/|b|.
  double residual() const {
    MultiVector r(b, Teuchos::Copy);
    matrix->apply(x, r, Teuchos::NO_TRANS, 1.0, -1.0);
    return r.getVector(0)->norm2() / b.getVector(0)->norm2();
  }

  Teuchos::RCP<CrsMatrix> matrix;
  CollectedMatrix whole;
  MultiVector b, x;
};

TEST(CollectedCgTest, SolvesInAtMostAsManyIterationsAsThereAreUnknowns) {
  System system(0.1);
  const CollectedSolve solve = system.solve(1e-8);
  EXPECT_EQ(solve.status, CollectedSolve::Converged);
  EXPECT_LE(solve.iterations, size);
  EXPECT_GT(solve.iterations, 1);
  EXPECT_LE(solve.residual, 1e-8);
  EXPECT_NEAR(system.residual(), solve.residual, 1e-12);
}

TEST(CollectedCgTest, StopsAtTheToleranceOrAtTheLastIteration) {
  System loose(0.1), short_of_time(0.1);
  const CollectedSolve solve = loose.solve(0.1);
  EXPECT_EQ(solve.status, CollectedSolve::Converged);
  EXPECT_LT(solve.iterations, System(0.1).solve().iterations);
  EXPECT_NEAR(loose.residual(), solve.residual, 1e-12);
  EXPECT_LE(solve.residual, 0.1);
  const CollectedSolve unfinished = short_of_time.solve(1e-12, 2);
  EXPECT_EQ(unfinished.status, CollectedSolve::Unconverged);
  EXPECT_EQ(unfinished.iterations, 2);
  EXPECT_NEAR(short_of_time.residual(), unfinished.residual, 1e-12);
}

TEST(CollectedCgTest, AMatrixOfNewValuesIsRefreshed) {
  System system(0.1);
  system.solve();
  const auto values = system.matrix->getLocalMatrixHost().values;
  for (std::size_t k = 0; k < values.extent(0); ++k) values(k) *= 3;
  system.whole.refresh();
  system.solve();
  EXPECT_LT(system.residual(), 1e-11);
}

TEST(CollectedCgTest, AllRanksLearnWhatIsWrong) {
  EXPECT_EQ(System(-3).solve().status, CollectedSolve::NegativeCurvature);
  System system(0.1);
  if (world()->getRank() == world()->getSize() - 1)
    system.b.replaceLocalValue(0, 0, std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(system.solve().status, CollectedSolve::NotFinite);
}

TEST(CollectedCgTest, NoLoadTakesNoIteration) {
  System system(0.1);
  system.b.putScalar(0);
  const CollectedSolve solve = system.solve();
  EXPECT_EQ(solve.status, CollectedSolve::Converged);
  EXPECT_EQ(solve.iterations, 0);
  EXPECT_EQ(system.x.getVector(0)->norm2(), 0);
}

}  // namespace
}  // namespace ixos
