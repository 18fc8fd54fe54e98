#include "discretization/element_batches.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "mesh/generators/shapes.hpp"
#include "mesh/partition.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// This rank's cells of a grid of 5 x 3 cells, an odd number: on one rank the last batch is never full.
template <std::size_t Dim>
struct Grid {
  static constexpr std::size_t D = Dim, N = std::size_t{1} << Dim;
  using Batches = ElementBatches<N, D>;
  static constexpr std::size_t width = Batches::width;

  Grid() : mesh(part()), pattern(mesh), nodes(mesh.blocks[0].nodes) {}

  static LocalMesh part() {
    BoxShape shape;
    shape.dimension = static_cast<int>(D);
    shape.divisions = {5, 3, 1};
    const Mesh whole = box(shape);
    const Comm comm = test::world();
    return localize(whole, partition_nodes(whole, comm->getSize()), comm->getRank(), comm->getSize());
  }

  std::size_t cells() const { return nodes.size() / N; }
  std::size_t dofs() const { return mesh.coordinates.size(); }
  std::size_t dof(std::size_t cell, std::size_t a, std::size_t d) const {
    return static_cast<std::size_t>(nodes[cell * N + a]) * D + d;
  }
  /// Whole numbers without order: their sums are exact in any order.
  static double number(std::size_t k) { return static_cast<double>(k * 37 % 101) - 50; }

  /// No factors, and one for each node of each cell. Powers of two keep products exact.
  std::vector<std::vector<double>> scales() const {
    const double factors[] = {1, 2, -0.5, 4, -8};
    std::vector<double> scale;
    for (std::size_t k = 0; k < nodes.size(); ++k) scale.push_back(factors[k % 5]);
    return {{}, scale};
  }
  static double factor(const std::vector<double>& scale, std::size_t cell, std::size_t a) {
    return scale.empty() ? 1.0 : scale[cell * N + a];
  }

  /// A number for each degree of freedom of the batch's cells; none in lanes that repeat a cell.
  Small<Pack, N, D> numbers(const Batches& batches, std::size_t b) const {
    Small<Pack, N, D> values{};
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t d = 0; d < D; ++d)
        for (std::size_t i = 0; i < width; ++i)
          values[a][d][i] = i < batches.lanes(b) ? number(((b * width + i) * N + a) * D + d) : not_a_number;
    return values;
  }

  LocalMesh mesh;
  Pattern pattern;
  std::vector<int> nodes;
};

template <class G>
class ElementBatchesTest : public testing::Test {};
using Grids = testing::Types<Grid<2>, Grid<3>>;
TYPED_TEST_SUITE(ElementBatchesTest, Grids);

TYPED_TEST(ElementBatchesTest, EveryCellHasALane) {
  const TypeParam grid;
  const typename TypeParam::Batches batches(grid.nodes, grid.pattern), none({}, grid.pattern);
  EXPECT_EQ(none.cells(), 0U);
  EXPECT_EQ(none.size(), 0U);
  EXPECT_EQ(batches.cells(), grid.cells());
  std::size_t cell = 0;
  for (std::size_t b = 0; b < batches.size(); ++b) {
    EXPECT_GT(batches.lanes(b), 0U);
    EXPECT_LE(batches.lanes(b), TypeParam::width);
    for (std::size_t i = 0; i < batches.lanes(b); ++i, ++cell)
      for (std::size_t a = 0; a < TypeParam::N; ++a)
        EXPECT_EQ(static_cast<std::size_t>(batches.first_dof(b, a, i)), grid.dof(cell, a, 0));
  }
  EXPECT_EQ(cell, grid.cells());
}

TYPED_TEST(ElementBatchesTest, GathersTheNodesOfEachCell) {
  const TypeParam grid;
  std::vector<double> local;
  for (std::size_t k = 0; k < grid.dofs(); ++k) local.push_back(TypeParam::number(k));
  for (const auto& scale : grid.scales()) {
    const typename TypeParam::Batches batches(grid.nodes, grid.pattern, scale);
    for (std::size_t b = 0; b < batches.size(); ++b) {
      Small<Pack, TypeParam::N, TypeParam::D> values{};
      batches.gather(b, local.data(), values);
      for (std::size_t i = 0; i < TypeParam::width; ++i) {
        // Lanes beyond the last cell repeat the first cell of the batch.
        const std::size_t cell = b * TypeParam::width + (i < batches.lanes(b) ? i : 0);
        for (std::size_t a = 0; a < TypeParam::N; ++a) {
          EXPECT_EQ(batches.scale(b, a, i), TypeParam::factor(scale, cell, a));
          for (std::size_t d = 0; d < TypeParam::D; ++d)
            EXPECT_EQ(lane(values[a][d], i), TypeParam::factor(scale, cell, a) * local[grid.dof(cell, a, d)]);
        }
      }
    }
  }
}

TYPED_TEST(ElementBatchesTest, ForcesAndDiagonalsAreAddedOnceForEachCell) {
  const TypeParam grid;
  for (const auto& scale : grid.scales()) {
    const typename TypeParam::Batches batches(grid.nodes, grid.pattern, scale);
    std::vector<double> force(grid.dofs(), 1.0), diagonal(grid.dofs(), 2.0);
    std::vector<double> expected_force = force, expected_diagonal = diagonal;
    for (std::size_t b = 0; b < batches.size(); ++b) {
      batches.scatter_force(b, grid.numbers(batches, b), force.data());
      batches.scatter_diagonal(b, grid.numbers(batches, b), diagonal.data());
    }
    for (std::size_t cell = 0; cell < grid.cells(); ++cell)
      for (std::size_t a = 0; a < TypeParam::N; ++a)
        for (std::size_t d = 0; d < TypeParam::D; ++d) {
          const double number = TypeParam::number((cell * TypeParam::N + a) * TypeParam::D + d);
          const double factor = TypeParam::factor(scale, cell, a);
          expected_force[grid.dof(cell, a, d)] += factor * number;
          expected_diagonal[grid.dof(cell, a, d)] += factor * factor * number;
        }
    EXPECT_EQ(force, expected_force);
    EXPECT_EQ(diagonal, expected_diagonal);
  }
}

TYPED_TEST(ElementBatchesTest, TangentsAreAddedToTheRowsOfOwnedNodes) {
  constexpr std::size_t N = TypeParam::N, D = TypeParam::D, M = N * D;
  const TypeParam grid;
  for (const auto& scale : grid.scales()) {
    const typename TypeParam::Batches batches(grid.nodes, grid.pattern, scale);
    std::vector<double> values(static_cast<std::size_t>(grid.pattern.pairs()) * D * D, 1.0);
    for (std::size_t b = 0; b < batches.size(); ++b) {
      Small<Pack, M> k{};
      for (std::size_t r = 0; r < M; ++r)
        for (std::size_t c = 0; c < M; ++c)
          for (std::size_t i = 0; i < TypeParam::width; ++i)
            k[r][c][i] =
                i < batches.lanes(b) ? TypeParam::number(((b * TypeParam::width + i) * M + r) * M + c) : not_a_number;
      batches.scatter_tangent(b, k, values.data());
    }
    std::vector<double> dense(grid.dofs() * grid.dofs(), 0.0);
    for (std::size_t cell = 0; cell < grid.cells(); ++cell)
      for (std::size_t r = 0; r < M; ++r)
        for (std::size_t c = 0; c < M; ++c)
          dense[grid.dof(cell, r / D, r % D) * grid.dofs() + grid.dof(cell, c / D, c % D)] +=
              TypeParam::factor(scale, cell, r / D) * TypeParam::factor(scale, cell, c / D) *
              TypeParam::number((cell * M + r) * M + c);
    // The values of the matrix stand row by row, as in Pattern::create_matrix().
    std::size_t next = 0;
    for (std::size_t row = 0; row < static_cast<std::size_t>(grid.pattern.rows()); ++row)
      for (std::size_t i = 0; i < D; ++i)
        for (int p = grid.pattern.row_start()[row]; p < grid.pattern.row_start()[row + 1]; ++p)
          for (std::size_t j = 0; j < D; ++j) {
            const auto column = static_cast<std::size_t>(grid.pattern.columns()[static_cast<std::size_t>(p)]) * D + j;
            EXPECT_EQ(values[next++], 1 + dense[(row * D + i) * grid.dofs() + column]) << row << ' ' << column;
          }
    EXPECT_EQ(next, values.size());
  }
}

// Numbers of one component are those of vectors and matrices whose other components are 0.
TYPED_TEST(ElementBatchesTest, OneComponentIsAVectorWithoutOthers) {
  constexpr std::size_t N = TypeParam::N, D = TypeParam::D;
  const TypeParam grid;
  std::vector<double> local;
  for (std::size_t k = 0; k < grid.dofs(); ++k) local.push_back(TypeParam::number(k));
  for (const auto& scale : grid.scales())
    for (std::size_t d = 0; d < D; ++d) {
      const typename TypeParam::Batches batches(grid.nodes, grid.pattern, scale);
      std::vector<double> force = local, expected_force = local;
      std::vector<double> values(static_cast<std::size_t>(grid.pattern.pairs()) * D * D, 1.0), expected_values = values;
      for (std::size_t b = 0; b < batches.size(); ++b) {
        Small<Pack, N, D> all{};
        std::array<Pack, N> own{};
        batches.gather(b, local.data(), all);
        batches.gather(b, local.data(), d, own);
        Small<Pack, N> k{};
        Small<Pack, N * D> matrix{};
        for (std::size_t a = 0; a < N; ++a) {
          EXPECT_TRUE(all_of(own[a] == all[a][d]));
          for (std::size_t i = 0; i < D; ++i)
            if (i != d) all[a][i] = 0.0;
          for (std::size_t c = 0; c < N; ++c)
            matrix[a * D + d][c * D + d] = k[a][c] = Pack(TypeParam::number((b * N + a) * N + c));
        }
        batches.scatter_force(b, all, expected_force.data());
        batches.scatter_force(b, d, own, force.data());
        batches.scatter_tangent(b, matrix, expected_values.data());
        batches.scatter_tangent(b, d, k, values.data());
      }
      EXPECT_EQ(force, expected_force);
      EXPECT_EQ(values, expected_values);
    }
}

}  // namespace
}  // namespace ixos
