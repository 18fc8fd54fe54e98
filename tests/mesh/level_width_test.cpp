#include "mesh/level_width.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "mesh/generators/shapes.hpp"

namespace ixos {
namespace {

Mesh grid(int dimension, int n, int m, int l = 1) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.divisions = {n, m, l};
  return box(shape);
}

/// Exchanges the numbers of two nodes in the cells.
void exchange(Mesh& mesh, int a, int b) {
  for (ElementBlock& block : mesh.blocks)
    for (int& node : block.nodes) node = node == a ? b : node == b ? a : node;
}

/// Appends a mesh that does not touch the first.
void append(Mesh& mesh, const Mesh& other) {
  for (ElementBlock block : other.blocks) {
    for (int& node : block.nodes) node += mesh.nodes();
    mesh.blocks.push_back(std::move(block));
  }
  mesh.coordinates.insert(mesh.coordinates.end(), other.coordinates.begin(), other.coordinates.end());
}

// Nodes of a cell are neighbours, so the levels from an end of a grid are its cross-sections.
TEST(MeanLevelWidthTest, OfAGridIsItsCrossSection) {
  EXPECT_DOUBLE_EQ(mean_level_width(grid(2, 7, 3)), 4);
  EXPECT_DOUBLE_EQ(mean_level_width(grid(2, 3, 7)), 4);
  EXPECT_DOUBLE_EQ(mean_level_width(grid(2, 5, 5)), 6);
  EXPECT_DOUBLE_EQ(mean_level_width(grid(3, 9, 4, 2)), 5 * 3);
  EXPECT_DOUBLE_EQ(mean_level_width(grid(3, 2, 2, 6)), 3 * 3);
}

TEST(MeanLevelWidthTest, OfOneCellHasTwoLevels) {
  EXPECT_DOUBLE_EQ(mean_level_width(grid(2, 1, 1)), 4 / 2.0);
  EXPECT_DOUBLE_EQ(mean_level_width(grid(3, 1, 1)), 8 / 2.0);
}

TEST(MeanLevelWidthTest, DoesNotDependOnTheNodeThatComesFirst) {
  for (int node = 0; node < 2 * 11; ++node) {
    Mesh strip = grid(2, 10, 1);
    exchange(strip, 0, node);
    EXPECT_DOUBLE_EQ(mean_level_width(strip), 2) << node;
  }
}

TEST(MeanLevelWidthTest, BlocksThatShareNodesAreOneMesh) {
  Mesh strip = grid(2, 10, 1);
  ElementBlock second = strip.blocks[0];
  const std::size_t half = strip.blocks[0].nodes.size() / 2;
  strip.blocks[0].nodes.resize(half);
  second.nodes.erase(second.nodes.begin(), second.nodes.begin() + static_cast<std::ptrdiff_t>(half));
  strip.blocks.push_back(second);
  EXPECT_DOUBLE_EQ(mean_level_width(strip), 2);
}

TEST(MeanLevelWidthTest, LevelsOfPartsThatDoNotTouchAddUp) {
  Mesh mesh = grid(2, 4, 1);    // 10 nodes in 5 levels
  append(mesh, grid(2, 9, 2));  // 30 nodes in 10 levels
  EXPECT_DOUBLE_EQ(mean_level_width(mesh), (10 + 30) / (5 + 10.0));
}

TEST(MeanLevelWidthTest, WithoutCellsOrWithoutNodes) {
  Mesh mesh;
  EXPECT_EQ(mean_level_width(mesh), 0);
  mesh.coordinates.assign(2 * 5, 0.0);  // five nodes, each a part of its own
  EXPECT_DOUBLE_EQ(mean_level_width(mesh), 1);
}

}  // namespace
}  // namespace ixos
