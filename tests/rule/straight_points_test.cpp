#include "rule/straight_points.hpp"

#include <gtest/gtest.h>

namespace ixos {
namespace {

TEST(StraightPointsTest, TheyAreTwoOrMoreOnTheChord) {
  EXPECT_TRUE(has_straight_points(gauss_rule(2)));
  EXPECT_TRUE(has_straight_points(point_rule({0.5, 1.0}, {0.25, 0.75})));
  EXPECT_FALSE(has_straight_points(gauss_rule(1)));
  EXPECT_FALSE(has_straight_points(end_rule()));
  EXPECT_FALSE(has_straight_points(gauss_rule(2, Path::Kinematic)));
  EXPECT_FALSE(has_straight_points(discrete_gradient_rule()));
}

}  // namespace
}  // namespace ixos
