#include <gtest/gtest.h>

#include <cmath>

#include "interaction/catalogue.hpp"
#include "interaction/obstacle_fixture.hpp"

namespace ixos {
namespace {

using test::Point;

constexpr double radius = 2, angle = 25;  // degrees

std::shared_ptr<const Obstacle> cone(std::size_t dimension) {
  return make_obstacle("Cone", dimension, {{"Radius", radius}, {"Half Angle", angle}});
}

/// Returns the least distance from the meridian, the upper half of which is in the plane of the axis and the point:
/// many points of the arc and of the straight side, and the minimum of a parabola through the nearest three.
double distance(double across, double along) {  // from the tip, along the axis upwards
  const double alpha = angle * M_PI / 180, end = M_PI / 2 - alpha;
  const auto place = [&](double s) -> std::array<double, 2> {  // arc up to s = end, then the side
    if (s <= end) return {radius * std::sin(s), radius * (std::cos(s) - 1)};
    return {radius * std::sin(end) + (s - end) * std::sin(alpha),
            radius * (std::cos(end) - 1) - (s - end) * std::cos(alpha)};
  };
  const auto square = [&](double s) {
    const auto p = place(s);
    return std::pow(p[0] - across, 2) + std::pow(p[1] - along, 2);
  };
  constexpr double step = 1e-3;
  double best = 0;
  for (int k = 0; k < 20000; ++k)
    if (square(k * step) < square(best)) best = k * step;
  const double a = square(best - step), b = square(best), c = square(best + step);
  return std::sqrt(b - std::pow(c - a, 2) / (8 * (a - 2 * b + c)));
}

TEST(ConeTest, TheGapIsTheDistance) {
  const auto obstacle = cone(3);
  test::RandomPoints points({-6, -6, -8}, {6, 6, 4});
  for (int k = 0; k < 60; ++k) {
    const Point x = points();
    if (test::gap(*obstacle, x) < 0.05) continue;
    EXPECT_NEAR(test::gap(*obstacle, x), distance(std::hypot(x[0], x[1]), x[2]), 1e-6);
    EXPECT_NEAR(std::abs(test::gap(*cone(2), {x[0], x[2], 0})), distance(std::abs(x[0]), x[2]), 1e-6);
  }
}

TEST(ConeTest, TheTipAndTheSideAreOnTheSurface) {
  EXPECT_NEAR(test::gap(*cone(3), {0, 0, 0}), 0, 1e-15);
  const double alpha = angle * M_PI / 180;
  // The side meets the axis at R/sin(alpha) above the centre of the sphere.
  const double apex = radius / std::sin(alpha) - radius, depth = 7;
  EXPECT_NEAR(test::gap(*cone(3), {0, depth * std::tan(alpha), apex - depth}), 0, 1e-14);
}

TEST(ConeTest, NormalAndBendAreDerivativesOnBothSidesOfTheJoint) {
  test::RandomPoints points({-6, -6, -8}, {6, 6, 4});
  const auto space = cone(3), plane = cone(2);
  const double alpha = angle * M_PI / 180;
  for (int k = 0; k < 100; ++k) {
    const Point x = points();
    const auto apart = [&](double across, double along) {  // from the joint
      return std::abs(-(along + radius) * std::cos(alpha) + across * std::sin(alpha)) > 0.01;
    };
    if (test::gap(*space, x) > 0.05 && apart(std::hypot(x[0], x[1]), x[2]))
      test::expect_derivatives(*space, x, 3, 1e-8);
    const Point y{x[0], x[2], 0};
    if (test::gap(*plane, y) > 0.05 && apart(std::abs(x[0]), x[2])) test::expect_derivatives(*plane, y, 2, 1e-8);
  }
}

TEST(ConeTest, TheNormalIsContinuousAtTheJoint) {
  const double alpha = angle * M_PI / 180, out = radius + 0.3;
  const Point joint{out * std::cos(alpha), 0, -radius + out * std::sin(alpha)};
  const ObstacleGap above = cone(3)->at(test::packed(test::sum(joint, 1e-9, {-std::sin(alpha), 0, std::cos(alpha)})));
  const ObstacleGap below = cone(3)->at(test::packed(test::sum(joint, -1e-9, {-std::sin(alpha), 0, std::cos(alpha)})));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(above.normal[i][0], below.normal[i][0], 1e-8);
  EXPECT_NEAR(above.gap[0], 0.3, 1e-14);
  EXPECT_NEAR(below.gap[0], 0.3, 1e-14);
}

TEST(ConeTest, MeansAndBoundsHold) {
  test::RandomPoints points({-5, -5, -6}, {5, 5, 4});
  const auto obstacle = cone(3);
  for (int k = 0; k < 300; ++k) {
    const Point x0 = points(), x1 = points();
    if (test::gap(*obstacle, x0) < 0.1 || test::gap(*obstacle, x1) < 0.1) continue;
    test::expect_mean(*obstacle, x0, x1);
    test::expect_bounds(*obstacle, x0, x1, 0.05, 0.25, 1e-6);
  }
}

TEST(ConeTest, AnAxisPointsOutOfTheTip) {
  const auto obstacle = make_obstacle("Cone", 2, {{"Radius", radius}, {"Tip", {1.0, 2.0}}, {"Axis", {0.0, -3.0}}});
  EXPECT_NEAR(test::gap(*obstacle, {1, 0.5, 0}), 1.5, 1e-15);
}

}  // namespace
}  // namespace ixos
