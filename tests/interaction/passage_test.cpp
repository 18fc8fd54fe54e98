// Points that pass through an obstacle within one step.
#include "interaction/passage.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "interaction/catalogue.hpp"
#include "interaction/obstacle_fixture.hpp"

namespace ixos {
namespace {

using test::Point;

constexpr double radius = 0.3, scale = 0.25;

std::shared_ptr<const Obstacle> sphere(std::size_t dimension) {
  return make_obstacle("Sphere", dimension, {{"Radius", radius}});
}

bool passes(const Obstacle& obstacle, const Point& x0, const Point& x1, double own_scale = scale) {
  const bool passed = has_passed(way_through(obstacle, x0, x1), own_scale);
  const Pack may = may_pass(obstacle, test::packed(x0), test::packed(x1), own_scale);
  if (passed) {
    EXPECT_EQ(may[0], 1) << "the bound is no bound";
  }
  return passed;
}

/// A chord at the distance h from the centre is deepest in its middle, at h - R. Its ends have normals that make an
/// angle of 2 arccos(h/R).
TEST(PassageTest, AChordThroughASphereHasItsDepthAndItsTurn) {
  for (const double h : {0.0, 0.1, 0.2, 0.29}) {
    const WayThrough way = way_through(*sphere(2), {h, 1, 0}, {h, -2, 0});
    const double half = std::sqrt(radius * radius - h * h);
    EXPECT_NEAR(way.start, std::hypot(h, 1) - radius, 1e-14);
    EXPECT_NEAR(way.end, std::hypot(h, 2) - radius, 1e-14);
    EXPECT_GE(way.deepest, h - radius - 1e-14);
    EXPECT_LE(way.deepest, std::hypot(h, half / 32) - radius + 1e-12) << "the middle is half a sample away at most";
    EXPECT_NEAR(way.turn, std::cos(2 * std::acos(h / radius)), 1e-12);
  }
  const WayThrough beside = way_through(*sphere(3), {0.31, 1, 0}, {0.31, -2, 0});
  EXPECT_FALSE(beside.deepest < 0);
  EXPECT_FALSE(has_passed(beside, scale));
}

/// A chord of more than a right angle passes, in each direction, in the plane and in space; a flat one does not, unless
/// the law's scale is less than its depth.
TEST(PassageTest, WaysThroughTheInsidePass) {
  for (const std::size_t dimension : {std::size_t{2}, std::size_t{3}})
    for (const double sign : {1.0, -1.0})
      for (const double far : {0.4, 5.0, 100.0}) {
        const auto obstacle = sphere(dimension);
        EXPECT_TRUE(passes(*obstacle, {0.05, sign * far, 0}, {-0.05, -sign * far, 0})) << far;
        EXPECT_TRUE(passes(*obstacle, {sign * far, 0.2, 0}, {-sign * far, 0.2, 0})) << far;
        EXPECT_FALSE(passes(*obstacle, {sign * far, 0.28, 0}, {-sign * far, 0.28, 0})) << far;
        EXPECT_TRUE(passes(*obstacle, {sign * far, 0.28, 0}, {-sign * far, 0.28, 0}, 0.01)) << far;
        EXPECT_FALSE(passes(*obstacle, {sign * far, 0.31, 0}, {-sign * far, 0.31, 0}, 0.01)) << far;
      }
}

/// Beyond the centre, the law pushes a point out at the other side.
TEST(PassageTest, AnEndBeyondTheCentreHasPassed) {
  EXPECT_TRUE(passes(*sphere(2), {0, 0.5, 0}, {0, -0.1, 0}));
  EXPECT_TRUE(passes(*sphere(2), {0, 0.1, 0}, {0, -0.5, 0}));
  EXPECT_FALSE(passes(*sphere(2), {0, 0.5, 0}, {0, 0.1, 0})) << "an overlap, which the law notices";
  EXPECT_FALSE(passes(*sphere(2), {0, 0.1, 0}, {0, 0.5, 0})) << "pushed out";
}

/// No point passes in short steps, wherever it is: a run with shorter steps goes on.
TEST(PassageTest, ShortStepsPassNothing) {
  for (int k = 0; k <= 100; ++k) {
    const double y = 0.5 - 0.01 * k;
    for (const double x : {0.0, 0.1, 0.25}) EXPECT_FALSE(passes(*sphere(2), {x, y, 0}, {x, y - 0.01, 0}));
  }
}

TEST(PassageTest, NothingPassesThroughAHalfSpaceOrOutOfACavity) {
  const auto wall = make_obstacle("Half-Space", 2);
  for (const double y : {1.0, 0.0, -1.0, -100.0}) EXPECT_FALSE(passes(*wall, {0, 1, 0}, {5, y, 0}));
  const auto cavity = make_obstacle("Sphere", 2, {{"Radius", radius}, {"Cavity", true}});
  for (const double x : {0.1, 0.5, 10.0}) EXPECT_FALSE(passes(*cavity, {-0.1, 0, 0}, {x, 0, 0}));
}

/// A cylinder in space is passed across its axis, not along it.
TEST(PassageTest, ACylinderIsPassedAcrossItsAxis) {
  const auto cylinder = make_obstacle("Cylinder", 3, {{"Radius", radius}, {"Axis", {0.0, 0.0, 1.0}}});
  EXPECT_TRUE(passes(*cylinder, {0.1, 1, -3}, {0.1, -1, 3}));
  EXPECT_FALSE(passes(*cylinder, {0, 0.35, -3}, {0, 0.35, 3}));
}

/// A crest of a sine wall, 2 A high, is passed from valley to valley where the normals at both ends are vertical.
TEST(PassageTest, ACrestIsPassed) {
  const auto wall = make_obstacle("Sine Wall", 2, {{"Amplitude", 0.5}, {"Period", 2.0}});
  double low = 0;  // a valley
  for (int k = 0; k <= 200; ++k)
    if (test::gap(*wall, {0.01 * k, 2, 0}) > test::gap(*wall, {low, 2, 0})) low = 0.01 * k;
  double height = 2;
  while (test::gap(*wall, {low, height - 0.01, 0}) > 0) height -= 0.01;
  EXPECT_TRUE(passes(*wall, {low, height, 0}, {low + 2, height, 0}, 0.1));
  EXPECT_FALSE(passes(*wall, {low, height + 1.2, 0}, {low + 2, height + 1.2, 0}, 0.1));
}

}  // namespace
}  // namespace ixos
