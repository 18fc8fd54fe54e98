#include "histories/rigid_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

using Vector = std::array<double, 3>;

TimeValue sum(const std::vector<MotionShare>& shares, double time) {
  TimeValue total;
  for (const auto& [factor, motion] : shares) {
    const TimeValue value = motion->at(time);
    total.value += factor * value.value;
    total.rate += factor * value.rate;
    total.acceleration += factor * value.acceleration;
  }
  return total;
}

RigidMotionOptions turning(std::vector<double> axis, std::vector<double> point) {
  RigidMotionOptions options;
  options.angle = function_of_time([](double t) { return TimeValue{0.7 * t * t, 1.4 * t, 1.4}; });
  options.axis = std::move(axis);
  options.point = std::move(point);
  return options;
}

TEST(RigidMotionSerialTest, APointTurnsInThePlaneByAnyAngle) {
  const RigidMotion motion(2, turning({}, {1, 2}));
  const double x[] = {4, 6};  // r = (3, 4)
  for (const double t : {0.0, 0.3, 1.7, 9.0}) {
    const double angle = 0.7 * t * t, c = std::cos(angle), s = std::sin(angle), rate = 1.4 * t;
    const Vector r{3 * c - 4 * s, 3 * s + 4 * c, 0};
    const TimeValue u = sum(motion.displacement(x, 0), t), v = sum(motion.displacement(x, 1), t);
    EXPECT_NEAR(u.value, r[0] - 3, 1e-14);
    EXPECT_NEAR(v.value, r[1] - 4, 1e-14);
    EXPECT_NEAR(u.rate, -rate * r[1], 1e-12);
    EXPECT_NEAR(v.rate, rate * r[0], 1e-12);
    EXPECT_NEAR(u.acceleration, -1.4 * r[1] - rate * rate * r[0], 1e-11);
    EXPECT_NEAR(v.acceleration, 1.4 * r[0] - rate * rate * r[1], 1e-11);
  }
}

TEST(RigidMotionSerialTest, ThePoseHasThePlaceAndTheRates) {
  RigidMotionOptions options = turning({}, {1, 2});
  options.translation = {nullptr, function_of_time([](double t) { return TimeValue{3 * t, 3, 0}; })};
  const RigidMotion motion(2, options);
  EXPECT_TRUE(motion.turns());
  EXPECT_FALSE(motion.translates(0));
  EXPECT_TRUE(motion.translates(1));
  const double t = 0.9, angle = 0.7 * t * t;
  const RigidPose pose = motion.pose(t);
  EXPECT_EQ(pose.point, (Vector{1, 2, 0}));
  EXPECT_EQ(pose.translation, (Vector{0, 3 * t, 0}));
  EXPECT_EQ(pose.velocity, (Vector{0, 3, 0}));
  EXPECT_NEAR(pose.angle, angle, 1e-15);
  EXPECT_NEAR(pose.spin, 1.4 * t, 1e-15);
  const Vector turning = pose.turning(pose.angle, {3, 4, 7});
  EXPECT_NEAR(turning[0], 3 * std::cos(angle) - 4 * std::sin(angle) - 3, 1e-14);
  EXPECT_NEAR(turning[1], 3 * std::sin(angle) + 4 * std::cos(angle) - 4, 1e-14);
  EXPECT_EQ(turning[2], 0);
  EXPECT_DOUBLE_EQ(pose.turning(1e-9, {1, 0, 0})[0], -0.5e-18) << "no cancellation";
}

TEST(RigidMotionSerialTest, ATurnAboutTheDiagonalPermutesTheAxes) {
  RigidMotionOptions options;
  options.angle = constant(2 * M_PI / 3);
  options.axis = {5, 5, 5};
  options.point = {1, 1, 1};
  const RigidMotion motion(3, options);
  const double x[] = {2, 3, 5};  // r = (1, 2, 4) goes to (4, 1, 2)
  const Vector to{4, 1, 2}, from{1, 2, 4};
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    EXPECT_NEAR(sum(motion.displacement(x, i), 0).value, to[k] - from[k], 1e-14);
  }
}

TEST(RigidMotionSerialTest, RatesAreDerivatives) {
  const RigidMotion motion(3, turning({1, -2, 0.5}, {0.2, 0, -1}));
  for (const auto& function : motion.functions()) EXPECT_NO_THROW(check_over(*function, 0, 3, true));
  const auto rate = rate_of(sine(0, 2, 0.5, 0.3));
  EXPECT_NEAR(rate->at(1.2).value, sine(0, 2, 0.5, 0.3)->at(1.2).rate, 1e-15);
  EXPECT_NEAR(rate->at(1.2).rate, sine(0, 2, 0.5, 0.3)->at(1.2).acceleration, 1e-15);
}

TEST(RigidMotionSerialTest, SmallAnglesLoseNoDigits) {
  EXPECT_NEAR(versine_of(constant(1e-9))->at(0).value / 5e-19, 1, 1e-14);
}

TEST(RigidMotionSerialTest, ATranslationMovesThePointAndNoDerivative) {
  RigidMotionOptions options = turning({}, {1, 2});
  options.translation = {nullptr, sine(3, 0, 1, 0)};
  const RigidMotion motion(2, options);
  EXPECT_EQ(motion.point_at(0), (Vector{1, 5, 0}));
  const double x[] = {1, 2}, dx[] = {2, 0};
  EXPECT_NEAR(sum(motion.displacement(x, 1), 1).value, 3, 1e-15);
  EXPECT_NEAR(sum(motion.displacement_derivative(dx, 0), 1).value, 2 * (std::cos(0.7) - 1), 1e-15);
  EXPECT_NEAR(sum(motion.displacement_derivative(dx, 1), 1).value, 2 * std::sin(0.7), 1e-15);
}

TEST(RigidMotionSerialTest, WhatDoesNotMoveHasNoFunctions) {
  const RigidMotion still(2, {});
  const double x[] = {1, 2};
  EXPECT_FALSE(still.moves());
  EXPECT_TRUE(still.functions().empty());
  EXPECT_TRUE(still.displacement(x, 0).empty());
  EXPECT_TRUE(RigidMotion(2, turning({}, {})).moves());
}

TEST(RigidMotionSerialTest, BadVectorsAreRefused) {
  const auto message = [](int d, const RigidMotionOptions& options) {
    return test::refusal([&] { RigidMotion(d, options); });
  };
  test::expect_contains(message(3, turning({0, 0, 0}, {})), "the axis is {0, 0, 0}; it must have a direction");
  test::expect_contains(message(3, turning({}, {})), "a rotation in three dimensions needs an axis");
  test::expect_contains(message(2, turning({0, 0, 1}, {})), "turns about z; remove it");
  test::expect_contains(message(3, turning({0, 1}, {})), "the axis has 2 components");
  test::expect_contains(message(2, turning({}, {1, 2, 3})), "the point has 3 components");
  RigidMotionOptions options;
  options.axis = {0, 0, 1};
  test::expect_contains(message(3, options), "no rotation about it");
  options = {};
  options.translation = {nullptr};
  test::expect_contains(message(2, options), "the translation has 1 functions of time");
}

}  // namespace
}  // namespace ixos
