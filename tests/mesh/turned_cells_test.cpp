#include "mesh/turned_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "mesh/cell_order.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/quality.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

/// Three by two (by two) cells.
Mesh bricks(int dimension, bool quadratic) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lengths = {3, 2, 2};
  shape.divisions = {3, 2, 2};
  Mesh mesh = box(shape);
  if (quadratic) raise_order(mesh);
  return mesh;
}

/// Reflects the whole body in the plane x = 1.5: all cells become mirror images.
void reflect(Mesh& mesh) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  for (std::size_t i = 0; i < mesh.coordinates.size(); i += d) mesh.coordinates[i] = 3 - mesh.coordinates[i];
}

void expect_the_same_sides(const Mesh& mesh, const Mesh& before) {
  for (std::size_t s = 0; s < mesh.side_sets.size(); ++s)
    for (std::size_t k = 0; k < mesh.side_sets[s].sides.size(); ++k) {
      const auto nodes = [&](const Mesh& own) {
        const std::vector<int> all = nodes_of_side(own, own.side_sets[s].sides[k]);
        return std::set<int>(all.begin(), all.end());
      };
      EXPECT_EQ(nodes(mesh), nodes(before)) << mesh.side_sets[s].name;
    }
}

TEST(TurnedCellsTest, AReflectedBodyIsSoundAndKeepsItsSides) {
  for (const int dimension : {2, 3})
    for (const bool quadratic : {false, true}) {
      Mesh mesh = bricks(dimension, quadratic);
      reflect(mesh);
      const Mesh before = mesh;
      EXPECT_NE(test::refusal([&] { check_cells(mesh); }), "");
      turn_cells(mesh);
      EXPECT_NO_THROW(check_cells(mesh));
      EXPECT_NO_THROW(require_shared_middles(mesh));
      EXPECT_EQ(mesh.coordinates, before.coordinates);
      EXPECT_NEAR(mesh_quality(mesh).volume, dimension == 2 ? 6 : 12, 1e-13);
      EXPECT_NEAR(mesh_quality(mesh).least_scaled_jacobian, 1, 1e-13);
      ASSERT_FALSE(mesh.side_sets.empty());
      expect_the_same_sides(mesh, before);
      EXPECT_EQ(mesh.notes.size(), dimension == 2 ? 0U : 1U);
      const Mesh once = mesh;
      turn_cells(mesh);
      EXPECT_EQ(mesh.blocks[0].nodes, once.blocks[0].nodes);
    }
}

// Each cell may have its own orientation; the second reflection gives the numbering of before.
TEST(TurnedCellsTest, SingleCellsAreTurned) {
  for (const int dimension : {2, 3})
    for (const bool quadratic : {false, true}) {
      const Mesh sound = bricks(dimension, quadratic);
      Mesh mirrored = sound;
      reflect(mirrored);
      turn_cells(mirrored);  // numbers of nodes that are mirror images of those of `sound`
      Mesh mesh = sound;
      const auto n = static_cast<std::ptrdiff_t>(nodes_per_cell(mesh.blocks[0].type));
      for (const std::ptrdiff_t cell : {0, 4})
        std::copy_n(mirrored.blocks[0].nodes.begin() + cell * n, n, mesh.blocks[0].nodes.begin() + cell * n);
      EXPECT_NE(mesh.blocks[0].nodes, sound.blocks[0].nodes);
      turn_cells(mesh);
      EXPECT_EQ(mesh.blocks[0].nodes, sound.blocks[0].nodes);
    }
}

// The outer column of nodes lies beyond the one inside: the last cells have the numbering of their neighbours, but a
// negative volume, and overlap with them.
TEST(TurnedCellsTest, FoldedCellsAreLeftToTheCheck) {
  for (const int dimension : {2, 3}) {
    Mesh mesh = bricks(dimension, false);
    const auto d = static_cast<std::size_t>(dimension);
    for (std::size_t i = 0; i < mesh.coordinates.size(); i += d)
      if (mesh.coordinates[i] == 3) mesh.coordinates[i] = 1.5;
    const Mesh before = mesh;
    turn_cells(mesh);
    EXPECT_EQ(mesh.blocks[0].nodes, before.blocks[0].nodes);
    test::expect_contains(test::refusal([&] { check_cells(mesh); }),
                          dimension == 2 ? "cell 3 at (1.75, 0.5): inverted" : "cell 3 at (1.75, 0.5, 0.5): inverted");
  }
}

TEST(TurnedCellsTest, SoundAndEmptyMeshesStayAsTheyAre) {
  Mesh mesh = bricks(2, false);
  const Mesh before = mesh;
  turn_cells(mesh);
  EXPECT_EQ(mesh.blocks[0].nodes, before.blocks[0].nodes);
  EXPECT_TRUE(mesh.notes.empty());
  Mesh empty;
  turn_cells(empty);
  EXPECT_EQ(empty.cells(), 0);
}

}  // namespace
}  // namespace ixos
