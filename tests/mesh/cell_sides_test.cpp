#include "mesh/cell_sides.hpp"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "mesh/generators/shapes.hpp"

namespace ixos {
namespace {

Mesh bricks(int dimension, int x, int y, int z) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.divisions = {x, y, z};
  return box(shape);
}

std::set<SideCorners> corners(const Mesh& mesh, const std::vector<Side>& sides) {
  std::set<SideCorners> result;
  for (const Side& side : sides) result.insert(sorted_corners(mesh, side));
  return result;
}

TEST(CellSidesTest, TheBoundaryIsTheGeneratorsSurface) {
  for (const Mesh& mesh : {disk({}), bricks(2, 3, 2, 1), bricks(3, 2, 3, 1)}) {
    const std::vector<Side> boundary = boundary_sides(mesh);
    for (const SideSet& set : mesh.side_sets) {
      if (set.name != "surface") continue;
      EXPECT_EQ(boundary.size(), set.sides.size());
      EXPECT_EQ(corners(mesh, boundary), corners(mesh, set.sides));
    }
  }
  EXPECT_EQ(boundary_sides(bricks(2, 3, 2, 1)).size(), 2U * (3 + 2));
  EXPECT_EQ(boundary_sides(bricks(3, 2, 3, 1)).size(), 2U * (2 * 3 + 2 * 1 + 3 * 1));
}

TEST(CellSidesTest, OppositeSidesShareNoCorner) {
  for (const Mesh& mesh : {bricks(2, 1, 1, 1), bricks(3, 1, 1, 1)}) {
    const CellType type = mesh.blocks[0].type;
    for (int side = 0; side < sides_per_cell(type); ++side) {
      const int other = opposite_side(type, side);
      EXPECT_EQ(opposite_side(type, other), side);
      for (int corner : side_nodes(type, side))
        for (int far : side_nodes(type, other)) EXPECT_NE(corner, far);
      const auto x = centre_of(mesh, corners_of(mesh, {0, 0, side})),
                 y = centre_of(mesh, corners_of(mesh, {0, 0, other}));
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(x[i] + y[i], i < static_cast<std::size_t>(mesh.dimension) ? 1 : 0, 1e-15);
    }
  }
}

TEST(CellSidesTest, CornersRunAlongTheRimOfTheSide) {
  const Mesh squares = bricks(2, 2, 1, 1), cube = bricks(3, 1, 1, 1);
  EXPECT_EQ(corners_of(squares, {0, 1, 1}), (SideCorners{2, 5, -1, -1}));
  EXPECT_EQ(sorted_corners(squares, {0, 1, 1}), (SideCorners{-1, -1, 2, 5}));
  // The bits of a cube's node numbers are its coordinates. Neighbours on the rim differ in one of them.
  for (int side = 0; side < 6; ++side) {
    const SideCorners rim = corners_of(cube, {0, 0, side});
    for (std::size_t a = 0; a < 4; ++a) {
      const int differs = rim[a] ^ rim[(a + 1) % 4];
      EXPECT_TRUE(differs == 1 || differs == 2 || differs == 4) << side;
    }
  }
}

TEST(CellSidesTest, TheBoundaryComesInTheOrderOfTheCells) {
  Mesh mesh = bricks(2, 4, 3, 1);
  const std::vector<int> all = mesh.blocks[0].nodes;
  mesh.blocks = {{"first", CellType::Quad4, {all.begin(), all.begin() + 20}},
                 {"second", CellType::Quad4, {all.begin() + 20, all.end()}}};
  const std::vector<Side> boundary = boundary_sides(mesh);
  ASSERT_EQ(boundary.size(), 14U);
  for (std::size_t k = 1; k < boundary.size(); ++k) {
    const Side &a = boundary[k - 1], &b = boundary[k];
    EXPECT_LT(std::tuple(a.block, a.cell, a.side), std::tuple(b.block, b.cell, b.side));
  }
}

TEST(CellSidesTest, NeighboursShareTheCornersOfTheirSide) {
  const Mesh mesh = bricks(2, 2, 1, 1);  // nodes 0 1 2 below, 3 4 5 above
  const std::vector<CellSide> sides = sorted_sides(mesh);
  ASSERT_EQ(sides.size(), 8U);
  const auto [begin, end] = sides_with(sides, sorted_corners({4, 1}));
  ASSERT_EQ(end - begin, 2);
  EXPECT_EQ(begin->cell, 0);  // the first cell's comes first
  EXPECT_EQ(begin->side.side, 1);
  EXPECT_EQ((begin + 1)->cell, 1);
  EXPECT_EQ((begin + 1)->side.side, 3);
  const auto [none, same] = sides_with(sides, sorted_corners({0, 2}));
  EXPECT_EQ(none, same);
}

}  // namespace
}  // namespace ixos
