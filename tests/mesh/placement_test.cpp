#include "mesh/placement.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/generators/shapes.hpp"

namespace ixos {
namespace {

Mesh points(int dimension, const std::vector<double>& coordinates) {
  Mesh mesh;
  mesh.dimension = dimension;
  mesh.coordinates = coordinates;
  return mesh;
}

TEST(PlacementTest, APartTurnsAboutItsPointBeforeItMoves) {
  Mesh mesh = points(2, {3, 1, 1, 1});
  Placement placement;
  placement.angle = 30;
  placement.point = {1, 1, 0};
  placement.translation = {10, 20, 0};
  move_nodes(placement, mesh);
  EXPECT_DOUBLE_EQ(mesh.coordinates[0], 11 + std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(mesh.coordinates[1], 22);
  EXPECT_EQ(mesh.coordinates[2], 11);
  EXPECT_EQ(mesh.coordinates[3], 21);
}

TEST(PlacementTest, QuartersOfATurnAreExact) {
  const std::vector<std::pair<double, std::vector<double>>> turns{
      {0, {3, 1}}, {90, {-1, 3}}, {180, {-3, -1}}, {-90, {1, -3}}, {450, {-1, 3}}, {-540, {-3, -1}}, {3600, {3, 1}}};
  for (const auto& [angle, expected] : turns) {
    Mesh mesh = points(2, {3, 1});
    Placement placement;
    placement.angle = angle;
    move_nodes(placement, mesh);
    EXPECT_EQ(mesh.coordinates, expected) << angle;
  }
}

TEST(PlacementTest, AThirdOfATurnAboutTheDiagonalPermutesTheAxes) {
  Mesh mesh = points(3, {1, 2, 3, 5, 5, 5});
  Placement placement;
  placement.angle = 120;
  placement.axis.fill(1 / std::sqrt(3.0));
  move_nodes(placement, mesh);
  const std::vector<double> expected{3, 1, 2, 5, 5, 5};
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(mesh.coordinates[k], expected[k], 1e-14);
}

TEST(PlacementTest, AMeshThatStaysKeepsItsBits) {
  DiskShape shape;
  shape.center = {0.1, 0.7};
  const Mesh before = disk(shape);
  Mesh mesh = before;
  Placement placement;
  placement.point = {0.3, 0.9, 0};
  move_nodes(placement, mesh);
  EXPECT_EQ(mesh.coordinates, before.coordinates);
}

}  // namespace
}  // namespace ixos
