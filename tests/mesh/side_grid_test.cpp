// How faces of a surface meet.
#include "mesh/side_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "mesh/generators/shapes.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

/// A sheet of n x m faces with nodes (n + 1) j + i. `bend`: the height of the nodes with i > 1 per unit of i.
struct Sheet {
  int n, m;
  std::vector<Vec<3>> x;
  std::vector<SideGrid::Face> faces;

  Sheet(int across, int along, double bend = 0, double stretch = 1) : n(across), m(along) {
    for (int j = 0; j <= m; ++j)
      for (int i = 0; i <= n; ++i)
        x.push_back({i == 0 ? 0.0 : 1 + stretch * (i - 1), double(j), bend * std::max(0, i - 1)});
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < n; ++i) faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  }
  int at(int i, int j) const { return (n + 1) * j + i; }
  SideGrid grid() const {
    std::vector<long long> numbers;
    for (std::size_t k = 0; k < x.size(); ++k) numbers.push_back(static_cast<long long>(k) + 1);
    return {faces, x, "sheet", numbers};
  }
};

TEST(SideGridTest, LinesContinueThroughRegularNodesAndAlongRims) {
  const Sheet sheet(3, 3);
  const SideGrid grid = sheet.grid();
  const int node = sheet.at(1, 1);
  EXPECT_TRUE(grid.is_regular(node));
  EXPECT_FALSE(grid.is_regular(sheet.at(0, 1)));
  EXPECT_EQ(grid.continuation(node, sheet.at(0, 1)), sheet.at(2, 1));
  EXPECT_EQ(grid.continuation(node, sheet.at(1, 2)), sheet.at(1, 0));
  EXPECT_EQ(grid.continuation(sheet.at(0, 1), sheet.at(0, 2)), sheet.at(0, 0));  // along the rim
  EXPECT_EQ(grid.continuation(sheet.at(0, 1), sheet.at(1, 1)), -1);              // into the rim
  EXPECT_EQ(grid.continuation(sheet.at(0, 0), sheet.at(1, 0)), -1);              // a corner
  EXPECT_TRUE(grid.is_crease(sheet.at(0, 1), sheet.at(0, 2)));
  EXPECT_EQ(grid.across(0, sheet.at(1, 0), sheet.at(1, 1)), 1);
  EXPECT_EQ(grid.across(0, sheet.at(0, 0), sheet.at(1, 0)), -1);
  EXPECT_EQ(grid.opposite(0, sheet.at(0, 0)), sheet.at(1, 1));
  EXPECT_EQ(grid.opposite(0, sheet.at(3, 3)), -1);
  EXPECT_TRUE(grid.has(0, sheet.at(1, 1)));
}

TEST(SideGridTest, SharpEdgesAreCreases) {
  const Sheet flat(3, 3, 0.5), sharp(3, 3, 0.7);  // 27 and 35 degrees
  EXPECT_FALSE(flat.grid().is_crease(flat.at(1, 1), flat.at(1, 2)));
  const SideGrid grid = sharp.grid();
  EXPECT_TRUE(grid.is_crease(sharp.at(1, 1), sharp.at(1, 2)));
  EXPECT_FALSE(grid.is_regular(sharp.at(1, 1)));
  EXPECT_EQ(grid.continuation(sharp.at(1, 1), sharp.at(1, 2)), sharp.at(1, 0));  // along the crease
  EXPECT_EQ(grid.continuation(sharp.at(1, 1), sharp.at(2, 1)), -1);
}

TEST(SideGridTest, TheEdgesAcrossAStripHaveItsMeanLength) {
  Sheet sheet(3, 2, 0, 2);
  sheet.x[static_cast<std::size_t>(sheet.at(3, 2))][0] += 0.3;
  const SideGrid grid = sheet.grid();
  EXPECT_DOUBLE_EQ(grid.strip_length(sheet.at(0, 1), sheet.at(1, 1)), 1);
  EXPECT_DOUBLE_EQ(grid.strip_length(sheet.at(1, 0), sheet.at(2, 0)), 2);
  for (int j = 0; j <= 2; ++j) EXPECT_DOUBLE_EQ(grid.strip_length(sheet.at(2, j), sheet.at(3, j)), 2.1);
}

TEST(SideGridTest, RefusesThreeFacesAtAnEdgeAndOppositeDirections) {
  Sheet sheet(2, 1);
  sheet.x.push_back({1, 0, 1});
  sheet.x.push_back({1, 1, 1});
  sheet.faces.push_back({sheet.at(1, 0), sheet.at(1, 1), 7, 6});
  EXPECT_NE(test::refusal([&] { sheet.grid(); }).find("meet in the edge between the nodes 2 and 5"), std::string::npos);
  Sheet turned(2, 1);
  std::swap(turned.faces[1][1], turned.faces[1][3]);
  EXPECT_NE(test::refusal([&] { turned.grid(); }).find("opposite directions"), std::string::npos);
}

TEST(SideGridTest, CreasesThatEndInsideAreOpen) {
  EXPECT_EQ(Sheet(3, 3, 0.7).grid().open_creases().count, 0);  // from rim to rim
  // A ridge of the height h = 0.57 begins in the middle. The edge in front of it has faces with the normals (-h, -h, 2)
  // and (h, -h, 2), which meet at more than 30 degrees. It begins on flat ground. The sides rise by less, atan h.
  Sheet roof(4, 4);
  for (const int j : {3, 4}) roof.x[static_cast<std::size_t>(roof.at(2, j))][2] = 0.57;
  const SideGrid::OpenCreases open = roof.grid().open_creases();
  EXPECT_EQ(open.count, 1);
  EXPECT_NEAR(open.angle, std::acos(4 / (4 + 2 * 0.57 * 0.57)), 1e-12);
}

/// The faces in the middle of the cube's edges have their middles at 30 degrees from each other, and meet at more.
TEST(SideGridTest, OnlyCoarseBallsHaveOpenCreases) {
  for (const int divisions : {2, 3, 4, 5}) {
    BallShape shape;
    shape.core_divisions = divisions;
    shape.rings = 1;
    const Mesh mesh = ball(shape);
    // With two divisions all edges are creases, so that none of them ends.
    EXPECT_EQ(open_creases(mesh, mesh.side_sets.front()).count, divisions == 3 ? 12 : 0) << divisions;
  }
}

}  // namespace
}  // namespace ixos
