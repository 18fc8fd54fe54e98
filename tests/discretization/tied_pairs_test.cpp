// Matrices of meshes with tied nodes: what elements write, condensed, is C^T K C.
#include "discretization/tied_pairs.hpp"

#include <gtest/gtest.h>

#include <Tpetra_CrsMatrix.hpp>
#include <cmath>

#include "discretization/discretization.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/splitting/refine.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

Mesh refined(int dimension) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.divisions = {2, 2, 2};
  Mesh mesh = box(shape);
  RefinedRegion region;
  region.levels = 2;
  region.lower.assign(static_cast<std::size_t>(dimension), -1);
  region.upper.assign(static_cast<std::size_t>(dimension), 0.1);
  refine(mesh, {{"corner", region}}, 1);
  return mesh;
}

/// A number for two degrees of freedom, the same in any order: that of an element matrix, whatever the element.
double entry(int i, int j) { return std::cos(1.0 + i + j + 0.3 * i * j); }

TEST(TiedPairsTest, CondensedMatricesAreThoseOfTheFreeNodes) {
  for (const int dimension : {2, 3}) {
    const Mesh mesh = refined(dimension);
    const std::vector<int> owner(static_cast<std::size_t>(mesh.nodes()), 0);
    const Discretization discretization(localize(mesh, owner, 0, 1), test::world());
    const LocalMesh& local = discretization.mesh();
    const Pattern& pattern = discretization.pattern();
    const auto d = static_cast<std::size_t>(dimension);
    const auto all = static_cast<std::size_t>(local.nodes()) * d,
               free = static_cast<std::size_t>(local.owned_nodes) * d;
    const auto matrix = pattern.create_matrix(discretization.space());
    double* values = matrix->getLocalMatrixHost().values.data();
    std::vector<std::vector<double>> dense(all, std::vector<double>(all, 0.0));
    const LocalBlock& block = local.blocks[0];
    const int n = nodes_per_cell(block.type);
    for (int cell = 0; cell < block.cells(); ++cell)
      for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b) {
          const int row = block.nodes[cell_entry(cell, n, a)], column = block.nodes[cell_entry(cell, n, b)];
          for (std::size_t i = 0; i < d; ++i)
            for (std::size_t j = 0; j < d; ++j) {
              const double value = entry(a * dimension + static_cast<int>(i), b * dimension + static_cast<int>(j));
              dense[static_cast<std::size_t>(row) * d + i][static_cast<std::size_t>(column) * d + j] += value;
              values[static_cast<std::size_t>(pattern.offset(row, column)) +
                     static_cast<std::size_t>(pattern.stride(row)) * i + j] += value;
            }
        }
    pattern.condense(values);
    // C, column by column: what a unit of a free degree of freedom moves.
    std::vector<std::vector<double>> c(free, std::vector<double>(all, 0.0));
    for (std::size_t k = 0; k < free; ++k) {
      c[k][k] = 1;
      local.ties.interpolate(c[k].data(), d);
    }
    std::vector<std::vector<double>> condensed(free, std::vector<double>(free, 0.0));
    pattern.for_each_row(values, [&](int row, const auto& entries) {
      entries([&](int column, double value) {
        condensed[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = value;
      });
    });
    for (std::size_t r = 0; r < free; ++r) {
      std::vector<double> kc(all, 0.0);
      for (std::size_t i = 0; i < all; ++i)
        for (std::size_t j = 0; j < all; ++j) kc[i] += dense[i][j] * c[r][j];
      for (std::size_t s = 0; s < free; ++s) {
        double expected = 0;
        for (std::size_t i = 0; i < all; ++i) expected += c[s][i] * kc[i];
        EXPECT_NEAR(condensed[s][r], expected, 1e-12);
      }
    }
    for (std::size_t i = pattern.matrix_values(); i < pattern.values(); ++i) ASSERT_EQ(values[i], 0);
    EXPECT_LT(static_cast<double>(pattern.values()), 4.0 * static_cast<double>(pattern.matrix_values()));
  }
}

}  // namespace
}  // namespace ixos
