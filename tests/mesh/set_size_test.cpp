#include "mesh/set_size.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/generators/shapes.hpp"
#include "mesh/placement.hpp"

namespace ixos {
namespace {

SetSize size_of(const Mesh& mesh, const std::string& name, bool of_sides) {
  const std::vector<SetSize> sizes = set_sizes(mesh);
  return *std::find_if(sizes.begin(), sizes.end(),
                       [&](const SetSize& size) { return size.name == name && size.of_sides == of_sides; });
}

Mesh bricks(int dimension, const std::array<double, 3>& lengths, const std::array<int, 3>& divisions) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lengths = lengths;
  shape.divisions = divisions;
  return box(shape);
}

TEST(SetSizeTest, SidesOfABoxHaveItsLengthsAndAreas) {
  const Mesh plate = bricks(2, {3, 2, 1}, {4, 5, 1});
  EXPECT_EQ(size_of(plate, "bottom", true).count, 4U);
  EXPECT_NEAR(size_of(plate, "bottom", true).measure, 3, 1e-14);
  EXPECT_NEAR(size_of(plate, "surface", true).measure, 10, 1e-14);
  EXPECT_EQ(size_of(plate, "left", false).count, 6U);
  EXPECT_EQ(size_of(plate, "left", false).measure, 0);
  Mesh block = bricks(3, {3, 2, 5}, {2, 3, 4});
  for (const bool turned : {false, true}) {
    if (turned) {
      Placement placement;
      placement.axis = {0.6, 0, 0.8};
      placement.angle = 37;
      move_nodes(placement, block);
    }
    EXPECT_NEAR(size_of(block, "bottom", true).measure, 6, 1e-13);
    EXPECT_NEAR(size_of(block, "left", true).measure, 10, 1e-13);
    EXPECT_NEAR(size_of(block, "front", true).measure, 15, 1e-13);
  }
  EXPECT_EQ(size_of(block, "bottom", true).count, 6U);
}

TEST(SetSizeTest, SidesOfABodyOfRevolutionAreRings) {
  Mesh tube = bricks(2, {2, 5, 1}, {3, 4, 1});
  for (std::size_t k = 0; k < tube.coordinates.size(); k += 2) tube.coordinates[k] += 1;  // from the radius 1 to 3
  tube.axisymmetric = true;
  EXPECT_NEAR(size_of(tube, "left", true).measure, 2 * M_PI * 1 * 5, 1e-12);
  EXPECT_NEAR(size_of(tube, "right", true).measure, 2 * M_PI * 3 * 5, 1e-12);
  EXPECT_NEAR(size_of(tube, "top", true).measure, M_PI * (9 - 1), 1e-12);
}

TEST(SetSizeTest, QuadraticSidesFollowTheCircle) {
  DiskShape shape;
  shape.cell_order = 2;
  EXPECT_NEAR(size_of(disk(shape), "surface", true).measure, M_PI * 10, 1e-3 * M_PI * 10);
  shape.half = true;
  Mesh ball = disk(shape);
  ball.axisymmetric = true;
  EXPECT_NEAR(size_of(ball, "surface", true).measure, M_PI * 100, 1e-3 * M_PI * 100);
  // 16 chords of a circle.
  EXPECT_NEAR(size_of(disk({}), "surface", true).measure, 16 * 10 * std::sin(M_PI / 16), 1e-12);
}

TEST(SetSizeTest, TheWordsHaveTheUnitOfTheBody) {
  EXPECT_EQ(in_words({"foot", true, 8, 2.5}, 2), "side set foot: 8 sides, 2.5 L0");
  EXPECT_EQ(in_words({"foot", true, 1, 2.5}, 3), "side set foot: 1 side, 2.5 L0^2");
  EXPECT_EQ(in_words({"head", false, 9, 0}, 3), "node set head: 9 nodes");
}

}  // namespace
}  // namespace ixos
