#include "rule/rule.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace ixos {
namespace {

void expect_point(const RulePoint& point, double weight, double from, double velocity, double to) {
  EXPECT_DOUBLE_EQ(point.weight, weight);
  EXPECT_DOUBLE_EQ(point.from, from);
  EXPECT_DOUBLE_EQ(point.velocity, velocity);
  EXPECT_DOUBLE_EQ(point.to, to);
}

TEST(RuleTest, EndRuleIsTheForceAtTheEnd) {
  const Rule rule = end_rule();
  ASSERT_EQ(rule.points.size(), 1u);
  expect_point(rule.points[0], 1, 0, 0, 1);
  EXPECT_EQ(rule.kept_weight, 0.0);
  EXPECT_EQ(rule.total_weight(), 1.0);
  EXPECT_FALSE(rule.uses_velocity());
}

TEST(RuleTest, PointsAtTheStartAreKept) {
  for (Path path : {Path::Linear, Path::Kinematic}) {
    const Rule rule = point_rule({0.0, 0.5, 0.0, 1.0}, {0.125, 0.25, 0.0625, 0.5}, path);
    EXPECT_EQ(rule.kept_weight, 0.1875);
    ASSERT_EQ(rule.points.size(), 2u);
    EXPECT_EQ(rule.points[0].weight, 0.25);
    EXPECT_EQ(rule.points[1].weight, 0.5);
    EXPECT_EQ(rule.total_weight(), 0.9375);
  }
}

TEST(RuleTest, LinearPathIsTheChord) {
  const double from = 2.0, to = -1.25;
  for (double xi : {0.125, 0.3, 0.5, 0.9, 1.0}) {
    const Rule rule = point_rule({xi}, {0.7});
    ASSERT_EQ(rule.points.size(), 1u);
    expect_point(rule.points[0], 0.7, 1 - xi, 0, xi);
    const RulePoint& point = rule.points[0];
    EXPECT_DOUBLE_EQ(point.from * from + point.to * to, from + xi * (to - from));
  }
}

TEST(RuleTest, KinematicPathStartsWithTheVelocityAndEndsAtTheUnknown) {
  // u(xi) = u_from + xi h v_from + xi^2 (u_s - u_from - h v_from), one unit value at a time.
  for (double xi : {0.125, 0.3, 0.5, 0.9, 1.0}) {
    const Rule rule = point_rule({xi}, {0.7}, Path::Kinematic);
    ASSERT_EQ(rule.points.size(), 1u);
    const auto path = [xi](double from, double hv, double to) { return from + xi * hv + xi * xi * (to - from - hv); };
    EXPECT_EQ(rule.points[0].weight, 0.7);
    EXPECT_NEAR(rule.points[0].from, path(1, 0, 0), 1e-15);
    EXPECT_NEAR(rule.points[0].velocity, path(0, 1, 0), 1e-15);
    EXPECT_NEAR(rule.points[0].to, path(0, 0, 1), 1e-15);
  }
}

TEST(RuleTest, BothPathsEndAtTheUnknown) {
  for (Path path : {Path::Linear, Path::Kinematic}) {
    const Rule rule = point_rule({1.0}, {1.0}, path);
    ASSERT_EQ(rule.points.size(), 1u);
    expect_point(rule.points[0], 1, 0, 0, 1);
  }
}

TEST(RuleTest, OnlyTheKinematicPathInsideTheSegmentUsesTheVelocity) {
  EXPECT_FALSE(gauss_rule(3).uses_velocity());
  EXPECT_FALSE(gauss_rule(3, Path::Linear).uses_velocity());
  EXPECT_TRUE(gauss_rule(3, Path::Kinematic).uses_velocity());
  // The trapezoid samples the ends of the segment, which do not depend on the path.
  EXPECT_FALSE(point_rule({0.0, 1.0}, {0.5, 0.5}, Path::Kinematic).uses_velocity());
}

TEST(RuleTest, GaussRulesAreConsistentAverages) {
  for (Path path : {Path::Linear, Path::Kinematic})
    for (int n = 1; n <= 64; ++n) {
      const Rule rule = gauss_rule(n, path);
      EXPECT_EQ(rule.points.size(), static_cast<std::size_t>(n));
      EXPECT_EQ(rule.kept_weight, 0.0);
      EXPECT_NEAR(rule.total_weight(), 1.0, 1e-13);
      // The mean of xi or of xi^2 over the segment; one point, the midpoint, gives 1/4 for the latter.
      double mean = 0;
      for (const RulePoint& point : rule.points) mean += point.weight * point.to;
      EXPECT_NEAR(mean, path == Path::Linear ? 1.0 / 2 : n == 1 ? 1.0 / 4 : 1.0 / 3, 1e-13) << n;
    }
}

TEST(RuleTest, MeansOverTheStraightPathAreTold) {
  for (const Rule& rule : {gauss_rule(2), gauss_rule(8), gauss_rule(64), exact_rule(), discrete_gradient_rule()})
    EXPECT_TRUE(rule.is_path_mean());
  for (const Rule& rule : {end_rule(), gauss_rule(1), gauss_rule(5, Path::Kinematic),
                           point_rule({0.0, 1.0}, {0.5, 0.5}), point_rule({0.5, 1.0}, {0.5, 0.5}), Rule{}})
    EXPECT_FALSE(rule.is_path_mean());
}

TEST(RuleTest, NumbersOfGaussPointsOutOfRangeAreRefused) {
  EXPECT_THROW(gauss_rule(0), InputError);
  EXPECT_THROW(gauss_rule(65, Path::Kinematic), InputError);
}

TEST(RuleTest, TheMeanTimeIsThatOfThePoints) {
  EXPECT_EQ(end_rule(0.3).mean_time(), 1);
  EXPECT_NEAR(gauss_rule(4).mean_time(), 0.5, 1e-15);
  EXPECT_NEAR(gauss_rule(3, Path::Kinematic).mean_time(), 0.5, 1e-15);
  EXPECT_EQ(point_rule({0, 1}, {0.5, 0.5}).mean_time(), 1) << "the kept part does not count";
  EXPECT_EQ(point_rule({0.5}, {1}).mean_time(), 0.5);
  EXPECT_EQ(discrete_gradient_rule().mean_time(), 0.5);
}

}  // namespace
}  // namespace ixos
