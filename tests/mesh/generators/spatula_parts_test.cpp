// The spatula's pad, tip and shaft end.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "mesh/generators/spatula_surface.hpp"

namespace ixos {
namespace {

using test::area_vector;
using test::default_spatula;
using test::named;
using test::nodes_of;
using test::position;
using test::side_vector;
using test::small;
using test::Vec;

TEST(SpatulaPartsTest, PadIsTheFlatUnderside) {
  const SpatulaShape shape;
  const Mesh& mesh = default_spatula();
  const SideSet& pad = named(mesh.side_sets, "pad");
  const SpatulaDivisions d = spatula_divisions(shape);
  EXPECT_EQ(static_cast<int>(pad.sides.size()), 44 * d.pad + 24 * 10);
  std::set<int> cells;
  for (const Side& side : pad.sides) {
    EXPECT_TRUE(cells.insert(side.cell).second);
    EXPECT_LT(side_vector(mesh, side)[2], 0);
  }
  const std::vector<int>& nodes = named(mesh.node_sets, "pad").nodes;
  for (int node : nodes) EXPECT_EQ(position(mesh, node)[2], shape.gap);
  const Vec area = area_vector(mesh, "pad");
  EXPECT_NEAR(area[0], 0, 1e-9);
  EXPECT_NEAR(area[1], 0, 1e-9);
  EXPECT_NEAR(area[2] / -(17000 + 2400 + M_PI / 2 * 14400), 1, 3e-4);  // widening, straight part, ellipse
  // Nothing else touches the plane of the underside, nor lies below it.
  const std::set<int> flat(nodes.begin(), nodes.end());
  for (int node = 0; node < mesh.nodes(); ++node)
    EXPECT_TRUE(flat.count(node) == 1 || position(mesh, node)[2] > shape.gap);
}

TEST(SpatulaPartsTest, PadFacesHaveTheSizesWanted) {
  const Mesh& mesh = default_spatula();
  double along = 0, shortest = 1e9, across = 0;
  const SideSet& pad = named(mesh.side_sets, "pad");
  for (const Side& side : pad.sides) {
    const auto nodes = nodes_of(mesh, side);  // seen from below: two nodes across, then along
    const Vec a = position(mesh, nodes[0]), b = position(mesh, nodes[1]), c = position(mesh, nodes[2]);
    const double first = std::hypot(b[0] - a[0], b[1] - a[1]), second = std::hypot(c[0] - b[0], c[1] - b[1]);
    along += std::min(first, second) / static_cast<double>(pad.sides.size());
    shortest = std::min({shortest, first, second});
    across = std::max({across, first, second});
  }
  EXPECT_NEAR(along, 0.96, 0.1);
  EXPECT_GT(shortest, 0.4);
  EXPECT_LT(across, 9);
}

TEST(SpatulaPartsTest, TipIsTheForemostNodeOfTheUnderside) {
  for (int target : {300, 5000}) {
    const Mesh mesh = spatula(small(target));
    const std::vector<int>& tip = named(mesh.node_sets, "tip").nodes;
    ASSERT_EQ(tip.size(), 1u);
    const Vec p = position(mesh, tip[0]);
    EXPECT_NEAR(p[0], 230, 1e-12);
    EXPECT_EQ(p[1], 0);
    EXPECT_EQ(p[2], SpatulaShape().gap);
  }
}

TEST(SpatulaPartsTest, ShaftEndIsAPlaneDisk) {
  const Mesh& mesh = default_spatula();
  EXPECT_EQ(named(mesh.side_sets, "shaft end").sides.size(), 272u);
  const Vec area = area_vector(mesh, "shaft end");
  EXPECT_NEAR(area[0], -area[2], 1e-9);  // along the shaft, at 45 degrees
  EXPECT_NEAR(area[1], 0, 1e-9);
  // A polygon in the circle: 44 sides above and below, 2 at either end.
  const double below = 3 * M_PI / 4 / 44, end = M_PI / 8;
  EXPECT_NEAR(std::hypot(area[0], area[2]), 800 * (88 * std::sin(below) + 4 * std::sin(end)), 1e-8);
  const double r = 68, beyond = 280 - r * M_PI / 4, c = std::sqrt(0.5);
  const double x = -r * c - beyond * c, z = SpatulaShape().gap + 7.5 + r * (1 - c) + beyond * c;
  for (int node : named(mesh.node_sets, "shaft end").nodes) {
    const Vec p = position(mesh, node);
    EXPECT_NEAR((p[0] - x) * -c + (p[2] - z) * c, 0, 1e-10);
    EXPECT_LE(std::hypot(p[0] - x, std::hypot(p[1], p[2] - z)), 40 + 1e-10);
  }
}

}  // namespace
}  // namespace ixos
