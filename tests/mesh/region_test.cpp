#include "mesh/region.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "mesh/generators/shapes.hpp"
#include "mesh/placement.hpp"
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
  sphere.sphere_radius = 0.98;
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

TEST(RegionTest, TheToleranceIsAThousandthOfTheShortestEdge) {
  EXPECT_DOUBLE_EQ(place_tolerance(bricks(2, 4, 2, 1)), 1e-3);
  EXPECT_DOUBLE_EQ(place_tolerance(bricks(3, 1, 2, 3)), 1e-3);
  BoxShape shape;
  shape.dimension = 3;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    shape.lengths = {8, 8, 8};
    shape.lengths[axis] = 0.5;
    shape.divisions = {2, 2, 2};
    EXPECT_DOUBLE_EQ(place_tolerance(box(shape)), 1e-3 * 0.25) << axis;
  }
  Mesh collapsed = bricks(2, 4, 2, 1);  // a corner that meets its neighbour
  collapsed.coordinates[2] = 0;
  EXPECT_DOUBLE_EQ(place_tolerance(collapsed), 1e-3) << "an edge without length is none";
}

double in_four_bytes(double x) { return static_cast<double>(static_cast<float>(x)); }
double in_six_digits(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return std::strtod(text, nullptr);
}
double in_eight_digits(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.8g", x);
  return std::strtod(text, nullptr);
}
using Rounding = double (*)(double);

/// Turns by 10 degrees about (1, 1, 1), in two dimensions about z, moves, and rounds the coordinates.
struct Turned {
  explicit Turned(Mesh whole, Rounding rounded) : exact(std::move(whole)) {
    if (exact.dimension == 3) placement.axis = {1 / std::sqrt(3.0), 1 / std::sqrt(3.0), 1 / std::sqrt(3.0)};
    placement.angle = 10;
    placement.translation = {0.1, 0.1, 0.1};
    move_nodes(placement, exact);
    mesh = exact;
    for (double& x : mesh.coordinates) x = rounded(x);
  }
  /// Returns where a point of the unturned mesh is, or where a direction looks.
  std::vector<double> place(const std::array<double, 3>& x, bool is_direction = false) const {
    Mesh point;
    point.dimension = exact.dimension;
    const auto d = static_cast<std::size_t>(exact.dimension);
    for (std::size_t i = 0; i < d; ++i) point.coordinates.push_back(x[i]);
    Placement own = placement;
    if (is_direction) own.translation = {};
    move_nodes(own, point);
    return point.coordinates;
  }
  Region plane(const std::array<double, 3>& through, const std::array<double, 3>& normal) const {
    Region region;
    region.plane_point = place(through);
    region.plane_normal = place(normal, true);
    return region;
  }
  Placement placement;
  Mesh exact, mesh;
};

TEST(RegionTest, CoordinatesOfFewDigitsLoseNoSideAndNoNode) {
  for (const Rounding rounded : {in_four_bytes, in_six_digits, in_eight_digits}) {
    const Turned plate(bricks(2, 8, 2, 1), rounded);
    const Region bottom = plate.plane({0, 0, 0}, {0, 1, 0});
    double farthest = 0;
    for (int node = 0; node < 9; ++node) farthest = std::max(farthest, Inside(plate.mesh, bottom).excess(node));
    EXPECT_GT(farthest, 1e-9) << "the rounding is not seen";
    EXPECT_EQ(sides(plate.mesh, bottom), 8U);
    EXPECT_EQ(nodes(plate.mesh, plate.plane({0, 2, 0}, {0, 3, 0})), 9U);

    const Turned block(bricks(3, 2, 3, 4), rounded);
    EXPECT_EQ(sides(block.mesh, block.plane({0, 0, 4}, {0, 0, 1})), 6U);
    EXPECT_EQ(nodes(block.mesh, block.plane({0, 0, 4}, {0, 0, 1})), 12U);

    // The surface of a ball or a disk lies in the ball through its nodes.
    for (const bool solid : {false, true}) {
      const Turned round_body(solid ? ball({}) : disk({}), rounded);
      Region sphere;
      sphere.sphere_radius = 5;
      sphere.sphere_center = round_body.place({0, 0, 0});
      EXPECT_EQ(sides(round_body.mesh, sphere), sides(round_body.mesh, {})) << solid;
      EXPECT_EQ(nodes(round_body.mesh, sphere), static_cast<std::size_t>(round_body.mesh.nodes())) << solid;
    }

    // A box around the left half, whose faces go through nodes.
    Turned shifted(bricks(2, 8, 2, 1), [](double x) { return x; });
    for (double& x : shifted.mesh.coordinates) x = rounded(x / 3);
    Region half;
    for (const auto& corner : {std::array<double, 3>{0, 0, 0}, {4, 2, 0}}) {
      const std::vector<double> place = shifted.place(corner);
      auto& bound = half.lower.empty() ? half.lower : half.upper;
      for (const double x : place) bound.push_back(x / 3);
    }
    std::size_t expected = 0;
    for (int node = 0; node < shifted.exact.nodes(); ++node) {
      const double* x = &shifted.exact.coordinates[2 * static_cast<std::size_t>(node)];
      const bool across = x[0] / 3 >= half.lower[0] - 1e-12 && x[0] / 3 <= half.upper[0] + 1e-12;
      if (across && x[1] / 3 >= half.lower[1] - 1e-12 && x[1] / 3 <= half.upper[1] + 1e-12) ++expected;
    }
    EXPECT_EQ(nodes(shifted.mesh, half), expected);
  }
}

/// Coordinates of three digits before the point have errors of 5e-4 with six digits, of four digits 5e-3.
TEST(RegionTest, LongMeshesOfFewDigitsKeepTheirSidesOrAreRefused) {
  const Turned strip(bricks(2, 512, 1, 1), in_six_digits);
  EXPECT_EQ(sides(strip.mesh, strip.plane({0, 0, 0}, {0, 1, 0})), 512U);
  const Turned longer(bricks(2, 5000, 1, 1), in_six_digits);
  const Region bottom = longer.plane({0, 0, 0}, {0, 1, 0});
  test::expect_contains(test::refusal([&] { sides(longer.mesh, bottom); }), "Give the set a Tolerance: 0.00");
  Region wide = bottom;
  wide.tolerance = 0.02;
  EXPECT_EQ(sides(longer.mesh, wide), 5000U);
}

TEST(RegionTest, WhatIsLeftOutNearTheRegionIsRefusedUnlessTheToleranceIsGiven) {
  Mesh mesh = bricks(2, 4, 2, 1);
  Region bottom;
  bottom.plane_normal = {0, 1};
  double& height = mesh.coordinates[2 * 2 + 1];  // of the third node of five
  height = -0.0005;
  EXPECT_EQ(sides(mesh, bottom), 4U);
  height = -0.005;
  const std::string message = test::refusal([&] { sides(mesh, bottom); });
  test::expect_contains(message, "the set \"new\" takes 2 side(s) and leaves out 2 that are 0.005 to 0.005 L0 outside");
  test::expect_contains(message, "0.001 L0 (a thousandth of the mesh's shortest edge)");
  test::expect_contains(message, "Give the set a Tolerance: 0.0055 takes them too, 0.0025 leaves them out");
  test::expect_contains(test::refusal([&] { nodes(mesh, bottom); }), "takes 4 node(s) and leaves out 1 that are 0.005");
  for (const auto& [tolerance, count] : {std::pair(0.0055, 4U), std::pair(0.0025, 2U)}) {
    bottom.tolerance = tolerance;
    EXPECT_EQ(sides(mesh, bottom), count);
  }
  bottom.tolerance = 0;
  height = -0.02;
  EXPECT_EQ(sides(mesh, bottom), 2U);
  // A side that looks elsewhere is not meant.
  Region left;
  left.upper = {0.995, 2};
  left.normal = {-1, 0};
  EXPECT_EQ(sides(bricks(2, 4, 2, 1), left), 2U);
  left.normal = {0, -1};
  test::expect_contains(test::refusal([&] { sides(bricks(2, 4, 2, 1), left); }), "leaves out 1 that are 0.005");
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
