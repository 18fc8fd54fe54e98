#include "discretization/pattern.hpp"

#include <gtest/gtest.h>

#include <Tpetra_CrsMatrix.hpp>
#include <set>

#include "fem/with_element.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "support/scene_text.hpp"
#include "support/solids.hpp"

namespace ixos {
namespace {

std::unique_ptr<Model> body(const Mesh& mesh) {
  return test::model_of(mesh, test::elastic(linear_elastic, 0.2), Inertia::None);
}

Mesh grid(int dimension, int n, int m, int l) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.divisions = {n, m, l};
  return box(shape);
}

std::vector<Mesh> meshes() {
  std::vector<Mesh> all{grid(2, 4, 3, 0), grid(3, 3, 2, 2), grid(2, 4, 3, 0), grid(3, 3, 2, 2)};
  enrich(all[2], "bottom", ContactElement::Q1C3);
  enrich(all[3], "bottom", ContactElement::Q1CH);
  return all;
}

TEST(PatternTest, CouplesTheNodesThatShareACell) {
  for (const Mesh& mesh : meshes()) {
    const auto model = body(mesh);
    const LocalMesh& local = model->mesh();
    std::vector<std::set<int>> expected(static_cast<std::size_t>(local.nodes()));
    for (const LocalBlock& block : local.blocks) {
      const int n = nodes_per_cell(block.type);
      for (int cell = 0; cell < block.cells(); ++cell)
        for (int a = 0; a < n; ++a)
          for (int b = 0; b < n; ++b)
            expected[static_cast<std::size_t>(block.nodes[cell_entry(cell, n, a)])].insert(
                block.nodes[cell_entry(cell, n, b)]);
    }
    const Pattern& pattern = model->pattern();
    ASSERT_EQ(pattern.rows(), local.owned_nodes);
    for (int row = 0; row < pattern.rows(); ++row) {
      const auto at = static_cast<std::size_t>(row);
      const auto begin = pattern.columns().begin() + pattern.row_start()[at];
      const auto end = pattern.columns().begin() + pattern.row_start()[at + 1];
      EXPECT_EQ(std::vector<int>(begin, end), std::vector<int>(expected[at].begin(), expected[at].end())) << row;
    }
  }
}

// Along each direction a grid of n cells has n + 1 nodes and 2n pairs of neighbours: 3n + 1 pairs.
TEST(PatternTest, HasTheNumberOfPairsOfAGrid) {
  for (int dimension : {2, 3}) {
    const auto model = body(grid(dimension, 5, 3, 2));
    double pairs = model->pattern().pairs();
    model->space().sum(&pairs, 1);
    EXPECT_EQ(pairs, (3 * 5 + 1) * (3 * 3 + 1) * (dimension == 2 ? 1 : 3 * 2 + 1));
  }
}

TEST(PatternTest, OffsetsLeadToTheEntriesOfTheMatrix) {
  for (const Mesh& mesh : meshes()) {
    const auto model = body(mesh);
    const Pattern& pattern = model->pattern();
    const int d = model->mesh().dimension;
    const auto matrix = pattern.create_matrix(model->space());
    const auto rows = matrix->getLocalMatrixHost();
    std::vector<int> visits(static_cast<std::size_t>(rows.nnz()), 0);
    int pair = 0;
    for (int row = 0; row < pattern.rows(); ++row)
      for (int p = pattern.row_start()[static_cast<std::size_t>(row)];
           p < pattern.row_start()[static_cast<std::size_t>(row) + 1]; ++p) {
        const int column = pattern.columns()[static_cast<std::size_t>(p)];
        EXPECT_EQ(pattern.pair(row, column), pair++);
        for (int i = 0; i < d; ++i)
          for (int j = 0; j < d; ++j) {
            const auto entry = static_cast<std::size_t>(pattern.offset(row, column) + i * pattern.stride(row) + j);
            const auto line = static_cast<std::size_t>(row * d + i);
            ASSERT_LT(entry, visits.size());
            EXPECT_GE(entry, static_cast<std::size_t>(rows.graph.row_map(line)));
            EXPECT_LT(entry, static_cast<std::size_t>(rows.graph.row_map(line + 1)));
            EXPECT_EQ(rows.graph.entries(entry), column * d + j);
            ++visits[entry];
          }
      }
    EXPECT_EQ(visits, std::vector<int>(visits.size(), 1));
    EXPECT_EQ(pair, pattern.pairs());
  }
}

TEST(PatternTest, AWalkOverTheRowsSeesTheMatrixInTheOrderOfMemory) {
  for (const Mesh& mesh : meshes()) {
    const auto model = body(mesh);
    const Pattern& pattern = model->pattern();
    const auto matrix = pattern.create_matrix(model->space());
    const auto rows = matrix->getLocalMatrixHost();
    std::size_t entry = 0;
    int next = 0;
    pattern.for_each_row(rows.values.data(), [&](int row, const auto& entries) {
      EXPECT_EQ(row, next++);
      EXPECT_EQ(entry, static_cast<std::size_t>(rows.graph.row_map(row)));
      entries([&](int column, double& value) {
        EXPECT_EQ(&value, &rows.values(entry));
        EXPECT_EQ(column, rows.graph.entries(entry++));
      });
    });
    EXPECT_EQ(entry, static_cast<std::size_t>(rows.nnz()));
    EXPECT_EQ(next, model->space().owned());
  }
}

TEST(PatternTest, APairThatIsNotThereIsRefused) {
  const auto model = body(grid(2, 9, 9, 0));
  const Pattern& pattern = model->pattern();
  if (pattern.rows() == 0) return;
  // A node has 9 neighbours at most, and there are more nodes.
  const std::set<int> neighbours(pattern.columns().begin(), pattern.columns().begin() + pattern.row_start()[1]);
  int other = 0;
  while (neighbours.count(other) > 0) ++other;
  EXPECT_THROW(pattern.pair(0, other), std::logic_error);
  EXPECT_THROW(pattern.offset(0, other), std::logic_error);
}

TEST(PatternTest, RowsOfOtherRanksAreNotThere) {
  const auto model = body(grid(2, 4, 3, 0));
  const Pattern& pattern = model->pattern();
  EXPECT_EQ(pattern.pair(pattern.rows(), 0), -1);
  EXPECT_EQ(pattern.offset(pattern.rows(), 0), -1);
}

}  // namespace
}  // namespace ixos
