// Gauss points of a side integrate polynomials of its parameters.
#include "geometry/patch_points.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ixos {
namespace {

TEST(PatchPointsTest, MomentsAreExact) {
  for (int along = 1; along <= 6; ++along)
    for (int power = 0; power < 2 * along; ++power) {
      double line = 0, face = 0;
      for (const PatchPoint<2>& point : patch_points<2>(along)) line += point.weight * std::pow(point.xi[0], power);
      for (const PatchPoint<3>& point : patch_points<3>(along))
        face += point.weight * std::pow(point.xi[0], power) * std::pow(point.xi[1], 2 * along - 1 - power);
      EXPECT_NEAR(line, 1.0 / (power + 1), 1e-14);
      EXPECT_NEAR(face, 1.0 / ((power + 1) * (2 * along - power)), 1e-14);
    }
}

TEST(PatchPointsTest, TheFirstParameterIsTheFastest) {
  const auto points = patch_points<3>(3);
  ASSERT_EQ(points.size(), 9U);
  EXPECT_LT(points[0].xi[0], points[1].xi[0]);
  EXPECT_EQ(points[0].xi[1], points[1].xi[1]);
  EXPECT_LT(points[0].xi[1], points[3].xi[1]);
}

TEST(PatchPointsTest, TheDefaultIsFive) {
  EXPECT_EQ(points_on_a_side(0), 5);
  EXPECT_EQ(points_on_a_side(3), 3);
}

}  // namespace
}  // namespace ixos
