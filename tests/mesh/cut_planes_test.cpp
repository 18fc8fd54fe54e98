#include "mesh/cut_planes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "mesh/connected_parts.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/placement.hpp"
#include "mesh/selection.hpp"

namespace ixos {
namespace {

std::vector<CutPlane> planes(const Mesh& mesh, const std::string& set) {
  return cut_planes(mesh, side_set_named(mesh, set), connected_parts(mesh));
}

/// A box from `lower`, whose lower side is shifted up by `bottom` (x, y).
Mesh bowl(int dimension, const std::array<double, 3>& lower, const std::function<double(double, double)>& bottom) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lower = lower;
  shape.lengths = {8, 8, 8};
  shape.divisions = {8, 8, 2};
  Mesh mesh = box(shape);
  const auto d = static_cast<std::size_t>(dimension);
  for (std::size_t k = 0; k < mesh.coordinates.size(); k += d)
    mesh.coordinates[k + d - 1] += bottom(mesh.coordinates[k], d == 3 ? mesh.coordinates[k + 1] : 0.0);
  return mesh;
}
double parabola(double x, double y) { return (x * x + y * y) / 60; }

TEST(CutPlanesTest, AHalfDiskEndsAtOne) {
  DiskShape shape;
  EXPECT_TRUE(planes(disk(shape), "surface").empty()) << "a whole disk";
  shape.half = true;
  Mesh half = disk(shape);
  const std::vector<CutPlane> found = planes(half, "surface");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].axis, 0U);
  EXPECT_NEAR(found[0].place, 0, 1e-12);
  const auto axis =
      std::find_if(half.node_sets.begin(), half.node_sets.end(), [](const NodeSet& set) { return set.name == "axis"; });
  std::vector<int> nodes = axis->nodes;
  std::sort(nodes.begin(), nodes.end());
  EXPECT_EQ(found[0].nodes, nodes);
  half.axisymmetric = true;
  EXPECT_TRUE(planes(half, "surface").empty()) << "its axis is no end";
}

TEST(CutPlanesTest, ATurnedHalfDiskEndsWhereItsPlaneIs) {
  DiskShape shape;
  shape.half = true;
  for (const auto& [angle, axis] : {std::pair(90.0, 1U), std::pair(180.0, 0U), std::pair(270.0, 1U)}) {
    Mesh half = disk(shape);
    Placement placement;
    placement.angle = angle;
    move_nodes(placement, half);
    const std::vector<CutPlane> found = planes(half, "surface");
    ASSERT_EQ(found.size(), 1U) << angle;
    EXPECT_EQ(found[0].axis, axis) << angle;
  }
}

TEST(CutPlanesTest, AQuarterOfABowlEndsAtTwo) {
  const std::vector<CutPlane> half = planes(bowl(2, {0, 0, 0}, parabola), "bottom");
  ASSERT_EQ(half.size(), 1U);
  EXPECT_EQ(half[0].axis, 0U);
  EXPECT_EQ(half[0].nodes.size(), 9U);
  const std::vector<CutPlane> quarter = planes(bowl(3, {0, 0, 0}, parabola), "bottom");
  ASSERT_EQ(quarter.size(), 2U);
  for (std::size_t axis : {0U, 1U}) {
    EXPECT_EQ(quarter[axis].axis, axis);
    EXPECT_EQ(quarter[axis].place, 0);
    EXPECT_EQ(quarter[axis].nodes.size(), 27U);
  }
}

TEST(CutPlanesTest, WholeAndFlatBodiesEndAtNone) {
  EXPECT_TRUE(planes(bowl(2, {-4, 0, 0}, parabola), "bottom").empty()) << "a whole bowl";
  EXPECT_TRUE(planes(bowl(3, {-4, -4, 0}, parabola), "bottom").empty()) << "a whole bowl in space";
  for (const int dimension : {2, 3}) {
    EXPECT_TRUE(planes(bowl(dimension, {0, 0, 0}, [](double, double) { return 0; }), "bottom").empty()) << "a box";
    EXPECT_TRUE(planes(bowl(dimension, {0, 0, 0}, [](double x, double) { return x / 10; }), "bottom").empty())
        << "a wedge";
    EXPECT_TRUE(planes(bowl(dimension, {2, 2, 0}, parabola), "bottom").empty()) << "a piece beside the middle";
  }
}

}  // namespace
}  // namespace ixos
