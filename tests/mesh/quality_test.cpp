#include "mesh/quality.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/generators.hpp"

namespace ixos {
namespace {

Mesh brick() {
  BoxShape shape;
  shape.dimension = 3;
  shape.lengths = {1, 2, 4};
  return box(shape);
}

TEST(MeshQualityTest, OfBricksIsOne) {
  BoxShape shape;
  shape.dimension = 3;
  shape.lengths = {2, 3, 4};
  shape.divisions = {2, 2, 2};
  const MeshQuality quality = mesh_quality(box(shape));
  EXPECT_EQ(quality.cells, 8);
  EXPECT_EQ(quality.nodes, 27);
  EXPECT_NEAR(quality.least_scaled_jacobian, 1, 1e-14);
  EXPECT_NEAR(quality.mean_scaled_jacobian, 1, 1e-14);
  EXPECT_NEAR(quality.low_scaled_jacobian, 1, 1e-14);
  EXPECT_NEAR(quality.largest_aspect_ratio, 2, 1e-14);
  EXPECT_NEAR(quality.volume, 24, 1e-13);
}

TEST(MeshQualityTest, OfAShearedCellIsTheSineOfItsAngle) {
  for (int dimension : {2, 3}) {
    BoxShape shape;
    shape.dimension = dimension;
    Mesh mesh = box(shape);
    const auto dim = static_cast<std::size_t>(dimension);
    for (std::size_t a = 0; a < mesh.coordinates.size(); a += dim) mesh.coordinates[a] += mesh.coordinates[a + 1];
    const MeshQuality quality = mesh_quality(mesh);
    EXPECT_NEAR(quality.least_scaled_jacobian, std::sqrt(0.5), 1e-14);
    EXPECT_NEAR(quality.largest_aspect_ratio, std::sqrt(2.0), 1e-14);
    EXPECT_NEAR(quality.volume, 1, 1e-14);
  }
}

TEST(MeshQualityTest, SeesCornersThatGaussPointsDoNot) {
  Mesh mesh = box({});  // the unit square; its last corner pushed beyond the diagonal of the others
  const int corner = mesh.blocks[0].nodes[2];
  for (std::size_t d : {0u, 1u}) mesh.coordinates[2 * static_cast<std::size_t>(corner) + d] = 0.45;
  EXPECT_NO_THROW(check_cells(mesh));
  EXPECT_LT(mesh_quality(mesh).least_scaled_jacobian, 0);
}

TEST(MeshQualityTest, OfATwistedBrickCountsItsVolumeExactly) {
  Mesh mesh = brick();
  // The top's corner at (1, 2) lifted by 1: volume 8 and a bilinear cap of mean height 1/4 over an area of 2.
  mesh.coordinates[3 * static_cast<std::size_t>(mesh.blocks[0].nodes[6]) + 2] += 1;
  EXPECT_NEAR(mesh_quality(mesh).volume, 8.5, 1e-13);
}

TEST(MeshQualityTest, IsWrittenInThreeLines) {
  EXPECT_EQ(to_string(mesh_quality(brick())),
            "1 cells, 8 nodes, volume 8\n"
            "scaled Jacobian: least 1.000, 5 % at most 1.000, mean 1.000\n"
            "largest aspect ratio: 4.0\n");
}

TEST(MeshQualityTest, OfAnEmptyMeshIsZero) { EXPECT_EQ(mesh_quality({}).cells, 0); }

}  // namespace
}  // namespace ixos
