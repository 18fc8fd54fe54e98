// Parts of cells: their places, and the shapes of bisected simplices.
#include "mesh/splitting/tree_cell.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace ixos {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A whole triangle or tetrahedron. `longest`: the edges of a tetrahedron, 01 02 12 03 13 23, by their length, the
/// longest last; the marked edges follow. The default has all of them in one plane.
TreeCell whole_simplex(int dimension, const std::array<int, 6>& ranks = {5, 3, 4, 0, 1, 2}) {
  TreeCell cell;
  cell.shape = TreeShape::Simplex;
  cell.count = static_cast<std::int8_t>(dimension + 1);
  for (std::size_t k = 1; k <= at(dimension); ++k) cell.vertices[k][k - 1] = 1;
  const auto longest = [&](int left_out) {
    MarkedEdges::Edge found{};
    int most = -1, edge = 0;
    for (int b = 1; b < cell.count; ++b)
      for (int a = 0; a < b; ++a, ++edge)
        if (a != left_out && b != left_out && ranks[at(edge)] > most) {
          most = ranks[at(edge)];
          found = {static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b)};
        }
    return found;
  };
  cell.marks.refinement = longest(-1);
  for (int corner = 0; corner < 4; ++corner) cell.marks.faces[at(corner)] = longest(corner);
  return cell;
}

std::vector<TreeCell> parts_of(const TreeCell& whole, int generations) {
  std::vector<TreeCell> parts{whole};
  for (int generation = 0; generation < generations; ++generation) {
    std::vector<TreeCell> next;
    for (const TreeCell& part : parts)
      for (const int end : {0, 1}) next.push_back(simplex_part(part, end, 0));
    parts = std::move(next);
  }
  return parts;
}

double volume(const TreeCell& cell) {
  std::array<std::array<double, 3>, 3> e{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (std::size_t k = 0; k < at(cell.dimension()); ++k)
    for (std::size_t i = 0; i < 3; ++i) e[k][i] = cell.place(static_cast<int>(k) + 1)[i] - cell.place(0)[i];
  return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) - e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
         e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}

TEST(TreeCellTest, PartsOfSimplicesAreHalvesOfTheSameOrientation) {
  for (const int dimension : {2, 3})
    for (int generations = 0; generations < 9; ++generations)
      for (const TreeCell& part : parts_of(whole_simplex(dimension), generations)) {
        EXPECT_EQ(volume(part), std::ldexp(1.0, -generations));
        EXPECT_EQ(part.halvings[0], generations);
      }
}

/// The squares of all edges over the largest, in order.
std::vector<long> shape_of(const TreeCell& cell) {
  std::vector<double> squares;
  for (int a = 0; a < cell.count; ++a)
    for (int b = 0; b < a; ++b) {
      double sum = 0;
      for (std::size_t i = 0; i < 3; ++i)
        sum += std::pow((1 + 0.3 * static_cast<double>(i)) * (cell.place(a)[i] - cell.place(b)[i]), 2);
      squares.push_back(sum);
    }
  std::sort(squares.begin(), squares.end());
  std::vector<long> shape;
  for (const double square : squares) shape.push_back(std::lround(1e6 * square / squares.back()));
  return shape;
}

// Newest-vertex bisection makes four shapes of triangles (Mitchell 1989); that of tetrahedra at most 72 (Arnold,
// Mukherjee, Pouly 2000), so that no generation is flatter than the first ones.
TEST(TreeCellTest, ThereAreFewShapes) {
  for (const auto& [dimension, most] : {std::pair(2, 4U), std::pair(3, 72U)}) {
    std::set<std::vector<long>> shapes;
    for (int generations = 0; generations <= 12; ++generations)
      for (const TreeCell& part : parts_of(whole_simplex(dimension), generations)) shapes.insert(shape_of(part));
    EXPECT_LE(shapes.size(), most);
    const std::size_t early = shapes.size();
    for (const TreeCell& part : parts_of(whole_simplex(dimension), 14)) shapes.insert(shape_of(part));
    EXPECT_EQ(shapes.size(), early) << "later generations look like earlier ones";
  }
}

// Whatever edges of a tetrahedron are marked first.
TEST(TreeCellTest, EveryMarkingHasFewShapes) {
  std::array<int, 6> ranks{0, 1, 2, 3, 4, 5};
  int number = 0;
  do {
    if (number++ % 7 != 0) continue;
    const TreeCell whole = whole_simplex(3, ranks);
    std::set<std::vector<long>> early, all;
    for (int generations = 0; generations <= 10; ++generations)
      for (const TreeCell& part : parts_of(whole, generations)) {
        if (generations < 8) early.insert(shape_of(part));
        all.insert(shape_of(part));
      }
    ASSERT_LE(all.size(), 72U);
    ASSERT_EQ(all.size(), early.size());
  } while (std::next_permutation(ranks.begin(), ranks.end()));
}

TEST(TreeCellTest, DepthTellsWhatIsInside) {
  TreeCell box;
  box.count = 4;
  box.lower = {-1, 0, 0};
  box.upper = {0, 1, 0};
  EXPECT_EQ(box.depth({-0.25, 0.5, 0}), 0.25);
  EXPECT_EQ(box.depth({-0.25, -0.5, 0}), -0.5);
  const TreeCell triangle = whole_simplex(2), part = simplex_part(triangle, 0, 7);
  EXPECT_NEAR(triangle.depth({0.25, 0.25, 0}), 0.25, 1e-15);
  EXPECT_NEAR(triangle.depth({0.75, 0.75, 0}), -0.5, 1e-15);
  EXPECT_TRUE(triangle.contains(part));
  EXPECT_FALSE(part.contains(triangle));
  EXPECT_TRUE(part.is_same_part(part));
  EXPECT_FALSE(part.is_same_part(simplex_part(triangle, 1, 7)));
  EXPECT_EQ(part.corners[1], 7);
}

TEST(TreeCellTest, FacesOfTheWholeCellAreTouchedByTheirParts) {
  for (const int dimension : {2, 3}) {
    const TreeCell whole = whole_simplex(dimension);
    for (int face = 0; face < whole.faces(); ++face) {
      EXPECT_TRUE(whole.touches(face));
      const int generations = 2 * dimension;
      int touching = 0;
      for (const TreeCell& part : parts_of(whole, generations)) touching += part.touches(face) ? 1 : 0;
      // As each face is bisected, too: 2^(D - 1) parts of it for each halving of all edges.
      EXPECT_EQ(touching, 1 << (2 * (dimension - 1))) << dimension << "D, face " << face;
    }
  }
  TreeCell box;
  box.count = 8;
  box.lower = {-1, -1, -1};
  box.upper = {1, 1, 0};
  EXPECT_TRUE(box.touches(4));
  EXPECT_FALSE(box.touches(5));
  EXPECT_EQ(box.corners_on(5), (std::vector<int>{4, 5, 6, 7}));
}

TEST(TreeCellTest, ShapesAreSplitInTheirWays) {
  EXPECT_EQ(tree_shape(ReferenceShape::Triangle), TreeShape::Simplex);
  EXPECT_EQ(tree_shape(ReferenceShape::Hexahedron), TreeShape::Box);
  EXPECT_EQ(tree_shape(ReferenceShape::Pyramid), TreeShape::Whole);
}

}  // namespace
}  // namespace ixos
