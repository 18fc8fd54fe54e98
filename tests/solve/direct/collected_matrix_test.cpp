// Matrices whose entries say where they stand, collected from all ranks.
#include "solve/direct/collected_matrix.hpp"

#include <gtest/gtest.h>

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

#include "solve/direct/selected_entries.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::world;

/// No two entries are alike.
double entry(GlobalId row, GlobalId column) { return static_cast<double>(100 * row + column + 1); }

/// Most rows have columns of other ranks.
std::set<GlobalId> columns_of(GlobalId row, int n) { return {row, (row + 3) % n, (row + 7) % n}; }

Teuchos::RCP<CrsMatrix> cyclic(int n) {
  const auto map = Teuchos::rcp(new Map(static_cast<Tpetra::global_size_t>(n), 0, world()));
  const auto matrix = Teuchos::rcp(new CrsMatrix(map, 3));
  for (GlobalId row = 0; row < n; ++row)
    if (map->isNodeGlobalElement(row))
      for (const GlobalId column : columns_of(row, n))
        matrix->insertGlobalValues(row, Teuchos::tuple<GlobalId>(column), Teuchos::tuple<double>(entry(row, column)));
  matrix->fillComplete();
  return matrix;
}

/// Expects `factor` times the matrix on the first rank.
void expect_whole(CollectedMatrix& whole, int n, double factor) {
  EXPECT_EQ(whole.root(), world()->getRank() == 0);
  if (!whole.root()) return;
  ASSERT_EQ(whole.size(), n);
  int k = 0;
  for (int row = 0; row < n; ++row) {
    EXPECT_EQ(whole.starts()[row], k);
    for (const GlobalId column : columns_of(row, n)) {  // in ascending order
      ASSERT_LT(k, whole.entries());
      EXPECT_EQ(whole.columns()[k], column) << row;
      EXPECT_EQ(whole.values()[k], factor * entry(row, column)) << row;
      ++k;
    }
  }
  EXPECT_EQ(whole.entries(), k);
}

// A matrix of one row leaves all ranks but one without any.
constexpr int sizes[] = {11, 1};

TEST(CollectedMatrixTest, TheFirstRankHasAllRowsWithTheirColumnsInOrder) {
  for (int n : sizes) {
    CollectedMatrix whole(cyclic(n));
    whole.refresh();
    expect_whole(whole, n, 1);
  }
}

TEST(CollectedMatrixTest, RefreshCollectsThePresentValues) {
  for (int n : sizes) {
    const auto matrix = cyclic(n);
    CollectedMatrix whole(matrix);
    whole.refresh();
    const auto values = matrix->getLocalMatrixHost().values;
    for (std::size_t k = 0; k < values.extent(0); ++k) values(k) *= -2;
    whole.refresh();
    expect_whole(whole, n, -2);
  }
}

TEST(CollectedMatrixTest, SelectedEntriesComeInTheOrderAskedFor) {
  for (int n : sizes) {
    const auto matrix = cyclic(n);
    CollectedMatrix whole(matrix);
    whole.refresh();
    std::vector<int> entries;
    std::vector<std::size_t> targets;
    std::vector<double> expected(static_cast<std::size_t>(whole.root() ? 2 * whole.entries() : 0), 5.0),
        found(expected);
    if (whole.root())
      for (int k = whole.entries() - 1; k >= 0; --k) {  // backwards, without each third
        if (k % 3 == 1) continue;
        entries.push_back(k);
        targets.push_back(static_cast<std::size_t>((7 * k) % whole.entries() * 2));
        expected[targets.back()] = -2 * whole.values()[k];
      }
    SelectedEntries some;
    if (whole.root()) some.select(whole, entries, targets);
    some.share(whole);
    const auto values = matrix->getLocalMatrixHost().values;
    for (std::size_t k = 0; k < values.extent(0); ++k) values(k) *= -2;
    some.copy(found.data());
    EXPECT_EQ(found, expected);
  }
}

TEST(CollectedMatrixTest, AllRanksLearnTheFirstRanksStatus) {
  const CollectedMatrix whole(cyclic(11));
  EXPECT_EQ(whole.agreed(40 + world()->getRank()), 40);
  const double mine = world()->getRank();
  EXPECT_EQ(whole.agreed({mine, mine + 0.5, 2.0}), (std::array<double, 3>{0.0, 0.5, 2.0}));
}

TEST(CollectedMatrixTest, TheFirstRankSolvesForAllRanks) {
  for (int n : sizes) {
    const auto matrix = cyclic(n);
    CollectedMatrix whole(matrix);
    MultiVector b(matrix->getRowMap(), 2), x(matrix->getRowMap(), 2);
    x.putScalar(std::numeric_limits<double>::quiet_NaN());
    const auto id = [&](std::size_t i) { return matrix->getRowMap()->getGlobalElement(static_cast<LocalId>(i)); };
    const auto given = [](GlobalId row, std::size_t column) {
      return static_cast<double>(row + 1) + 0.5 * static_cast<double>(column);
    };
    {
      const auto view = b.getLocalViewHost(Tpetra::Access::OverwriteAll);
      for (std::size_t i = 0; i < view.extent(0); ++i)
        for (std::size_t column = 0; column < 2; ++column) view(i, column) = given(id(i), column);
    }
    // In the place of a solver: each unknown takes the right-hand side of the opposite row.
    int columns = 0;
    whole.solve(b, x, [&](const std::vector<const double*>& rhs, const std::vector<double*>& solutions) {
      for (std::size_t column = 0; column < rhs.size(); ++column, ++columns)
        for (int row = 0; row < n; ++row) solutions[column][row] = 3 * rhs[column][n - 1 - row];
    });
    EXPECT_EQ(columns, whole.root() ? 2 : 0);
    const auto view = x.getLocalViewHost(Tpetra::Access::ReadOnly);
    for (std::size_t i = 0; i < view.extent(0); ++i)
      for (std::size_t column = 0; column < 2; ++column)
        EXPECT_EQ(view(i, column), 3 * given(n - 1 - id(i), column)) << id(i);
  }
}

}  // namespace
}  // namespace ixos
