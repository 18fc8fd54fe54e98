#include "mesh/region.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/generators/shapes.hpp"
#include "mesh/selection.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

/// A box of unit cells.
Mesh bricks(int dimension, int x, int y, int z) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lengths = {double(x), double(y), double(z)};
  shape.divisions = {x, y, z};
  return box(shape);
}

std::size_t sides(Mesh mesh, const Region& region, const std::string& from = "") {
  add_side_set(mesh, "new", from, region);
  return mesh.side_sets.back().sides.size();
}
std::size_t nodes(Mesh mesh, const Region& region) {
  add_node_set(mesh, "new", "", region);
  return mesh.node_sets.back().nodes.size();
}

TEST(RegionTest, SidesWithoutASetComeFromTheWholeBoundary) {
  Mesh mesh = bricks(2, 4, 2, 1);
  mesh.side_sets.clear();
  EXPECT_EQ(sides(mesh, {}), 12U);
  Region bottom;
  bottom.upper = {4, 0};
  EXPECT_EQ(sides(mesh, bottom), 4U);
  mesh = bricks(3, 2, 3, 4);
  mesh.side_sets.clear();
  EXPECT_EQ(sides(mesh, {}), 2U * (6 + 8 + 12));
}

TEST(RegionTest, APlaneHoldsWhatLiesInIt) {
  Region plane;
  plane.plane_normal = {0, 0, -7};
  EXPECT_EQ(sides(bricks(3, 2, 3, 4), plane), 6U);  // z = 0
  plane.plane_point = {5, 5, 4};
  EXPECT_EQ(sides(bricks(3, 2, 3, 4), plane), 6U);
  EXPECT_EQ(nodes(bricks(3, 2, 3, 4), plane), 12U);
  Region diagonal;
  diagonal.plane_normal = {1, -1};
  EXPECT_EQ(nodes(bricks(2, 3, 3, 1), diagonal), 4U);
}

TEST(RegionTest, ASphereHoldsItsInsideAndItsSurface) {
  Region sphere;
  sphere.sphere_radius = 1;
  EXPECT_EQ(nodes(bricks(2, 4, 4, 1), sphere), 3U);
  sphere.sphere_center = {2, 2};
  EXPECT_EQ(nodes(bricks(2, 4, 4, 1), sphere), 5U);
  sphere.sphere_radius = 0.999;
  EXPECT_EQ(nodes(bricks(2, 4, 4, 1), sphere), 1U);
}

TEST(RegionTest, ANormalChoosesSidesByWhereTheyLook) {
  Region down;
  down.normal = {0, -2};
  EXPECT_EQ(sides(bricks(2, 4, 2, 1), down), 4U);
  // The disk's 16 sides look to 11.25 + 22.5 k degrees: two lie within 30 degrees of the direction, eight within 90.
  EXPECT_EQ(sides(disk({}), down), 2U);
  down.normal_angle = 90;
  EXPECT_EQ(sides(disk({}), down), 8U);
  down.normal_angle = 180;
  EXPECT_EQ(sides(disk({}), down), 16U);
  Region front;
  for (const auto& [direction, count] :
       {std::pair(std::vector<double>{-1, 0, 0}, 12U), {{0, 1, 0}, 8U}, {{0, 0, -1}, 6U}}) {
    front.normal = direction;
    EXPECT_EQ(sides(bricks(3, 2, 3, 4), front), count);
  }
}

TEST(RegionTest, AllConditionsHoldTogether) {
  Region region;
  region.normal = {0, -1};
  region.upper = {2, 9};
  EXPECT_EQ(sides(bricks(2, 4, 2, 1), region), 2U);
  region.sphere_radius = 1;
  EXPECT_EQ(sides(bricks(2, 4, 2, 1), region, "surface"), 1U);
}

TEST(RegionTest, WhatDoesNotFitTheMeshIsRefused) {
  const Mesh mesh = bricks(2, 4, 2, 1);
  Region region;
  const auto refused = [&](const std::string& words) {
    test::expect_contains(test::refusal([&] { sides(mesh, region); }), words);
  };
  region.lower = {0, 0, 0};
  refused("Lower has 3 coordinates, but the mesh has 2 dimensions");
  region = {};
  region.plane_normal = {0, 0};
  refused("Plane Normal is zero");
  region = {};
  region.plane_point = {0, 0};
  refused("Plane Point is given without Plane Normal");
  region = {};
  region.sphere_center = {0, 0};
  refused("Sphere Center is given without Sphere Radius");
  region = {};
  region.lower = {1.5, 0.5};
  region.upper = {2.5, 1.5};
  refused("no side of the boundary lies in the region; the mesh spans (0, 0) to (4, 2)");
  region = {};
  region.normal = {0, 1};
  test::expect_contains(test::refusal([&] { nodes(mesh, region); }), "Normal selects sides; a node has none");
  Mesh bare = mesh;
  bare.side_sets.clear();
  EXPECT_EQ(test::refusal([&] { sides(bare, {}, "foot"); }),
            "side set \"foot\" does not exist. The mesh has none; Mesh/Sets can select one");
}

}  // namespace
}  // namespace ixos
