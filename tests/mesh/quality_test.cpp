#include "mesh/quality.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/cell_order.hpp"
#include "mesh/generators/shapes.hpp"

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

// A tube of radii 1 and 3 and length 2, its straight cells sheared along the axis: pi (9 - 1) 2, whatever the cells. A
// cone's frustum of radii 2 and 1 and height 3: pi 3 (4 + 2 + 1)/3. Each is the body's volume, not that of the section.
TEST(MeshQualityTest, OfABodyOfRevolutionCountsTheVolumeOfTheBody) {
  for (const bool quadratic : {false, true}) {
    BoxShape shape;
    shape.lower = {1, 0, 0};
    shape.lengths = {2, 2, 1};
    shape.divisions = {3, 2, 1};
    Mesh tube = box(shape);
    for (std::size_t i = 0; i < tube.coordinates.size(); i += 2) tube.coordinates[i + 1] += 0.3 * tube.coordinates[i];
    shape.lower = {0, 0, 0};
    shape.lengths = {1, 3, 1};
    Mesh frustum = box(shape);
    for (std::size_t i = 0; i < frustum.coordinates.size(); i += 2)
      frustum.coordinates[i] *= 2 - frustum.coordinates[i + 1] / 3;
    for (Mesh* mesh : {&tube, &frustum}) {
      if (quadratic) raise_order(*mesh);
      mesh->axisymmetric = true;
    }
    EXPECT_NEAR(mesh_quality(tube).volume, 16 * M_PI, 1e-12);
    EXPECT_NEAR(mesh_quality(frustum).volume, 7 * M_PI, 1e-12);
    EXPECT_NE(to_string(mesh_quality(tube)).find("volume 50.2655\n"), std::string::npos);
    tube.axisymmetric = false;
    EXPECT_NEAR(mesh_quality(tube).volume, 4, 1e-13);
  }
}

TEST(MeshQualityTest, IsWrittenInThreeLines) {
  EXPECT_EQ(to_string(mesh_quality(brick())),
            "1 cells, 8 nodes, volume 8\n"
            "scaled Jacobian: least 1.000 (block \"body\", cell 1 at (0.5, 1, 2)), 5th percentile 1.000, mean 1.000\n"
            "largest aspect ratio: 4.0 (block \"body\", cell 1 at (0.5, 1, 2))\n");
}

TEST(MeshQualityTest, NamesTheWorstCellsAndWarnsOfVeryBadOnes) {
  for (int dimension : {2, 3}) {
    BoxShape shape;
    shape.dimension = dimension;
    shape.lengths = {3, 1, 1};
    shape.divisions = {3, 1, 1};
    Mesh mesh = box(shape);
    EXPECT_EQ(quality_warning(mesh_quality(mesh)), "");
    // The second cell is made thin.
    const auto d = static_cast<std::size_t>(dimension);
    for (std::size_t n = 0; n < mesh.coordinates.size(); n += d)
      if (mesh.coordinates[n] == 1) mesh.coordinates[n] = 1.992;
    const MeshQuality thin = mesh_quality(mesh);
    EXPECT_NEAR(thin.largest_aspect_ratio, 125, 1e-9);
    EXPECT_EQ(thin.longest.cell, 2);
    EXPECT_NEAR(thin.longest.centre[0], 1.996, 1e-14);
    EXPECT_NE(quality_warning(thin).find("block \"body\", cell 2 at (1.996, 0.5"), std::string::npos)
        << quality_warning(thin);
    EXPECT_NE(quality_warning(thin).find("has an aspect ratio of 125"), std::string::npos);
    // The last cell sheared by a factor of 20: the sine of its angle is 1/sqrt(401), and its edges' ratio sqrt(401).
    mesh = box(shape);
    for (std::size_t n = 0; n < mesh.coordinates.size(); n += d)
      if (mesh.coordinates[n] >= 2) mesh.coordinates[n + 1] += 20 * (mesh.coordinates[n] - 2);
    const MeshQuality sheared = mesh_quality(mesh);
    EXPECT_NEAR(sheared.least_scaled_jacobian, 1 / std::sqrt(401.0), 1e-14);
    EXPECT_EQ(sheared.most_distorted.cell, 3);
    EXPECT_NEAR(sheared.most_distorted.centre[1], 10.5, 1e-13);
    EXPECT_NE(quality_warning(sheared).find("has a scaled Jacobian of 0.050"), std::string::npos);
  }
}

TEST(MeshQualityTest, OfAnEmptyMeshIsZero) { EXPECT_EQ(mesh_quality({}).cells, 0); }

}  // namespace
}  // namespace ixos
