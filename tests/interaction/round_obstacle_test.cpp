#include "interaction/round_obstacle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

#include "interaction/catalogue.hpp"
#include "interaction/obstacle_fixture.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

using test::dot;
using test::packed;
using test::Point;
using test::sum;

const Point center{0.3, -0.2, 0.5}, axis{0.48, 0.6, 0.64};
constexpr double radius = 3;

/// A sphere or a cylinder, from outside or as a cavity.
struct Case {
  bool axial, cavity;
};

class RoundObstacleTest : public testing::TestWithParam<Case> {
 protected:
  RoundObstacleTest() {
    RoundShape shape;
    shape.center = center;
    shape.radius = radius;
    shape.cavity = GetParam().cavity;
    if (GetParam().axial) {
      shape.axis = axis;
      obstacle_ = std::make_unique<RoundObstacle<true>>(shape);
    } else {
      obstacle_ = std::make_unique<RoundObstacle<false>>(shape);
    }
  }
  /// The gap from the distance to the centre, or to the axis by the cross product.
  double gap(const Point& x) const {
    const Point y = sum(x, -1, center);
    const Point cross{y[1] * axis[2] - y[2] * axis[1], y[2] * axis[0] - y[0] * axis[2],
                      y[0] * axis[1] - y[1] * axis[0]};
    const double distance = GetParam().axial ? std::sqrt(dot(cross, cross)) : std::sqrt(dot(y, y));
    return GetParam().cavity ? radius - distance : distance - radius;
  }
  /// Returns a random point on the free side.
  Point free_point() {
    std::uniform_real_distribution<double> coordinate(-7, 7);
    for (;;) {
      const Point x{coordinate(random_), coordinate(random_), coordinate(random_)};
      if (gap(x) > 0.05) return x;
    }
  }
  std::mt19937 random_{1};
  std::unique_ptr<const Obstacle> obstacle_;
};

TEST_P(RoundObstacleTest, GapNormalAndBendAreThoseOfTheDistance) {
  for (int k = 0; k < 50; ++k) {
    const Point x = free_point();
    const ObstacleGap found = obstacle_->at(packed(x));
    EXPECT_NEAR(found.gap[0], gap(x), 1e-14);
    for (std::size_t i = 0; i < 3; ++i) {
      Point e{};
      e[i] = 1;
      EXPECT_NEAR(test::derivative([&](double s) { return gap(sum(x, s, e)); }), double(found.normal[i][0]), 1e-8);
      for (std::size_t j = 0; j < 3; ++j)
        EXPECT_NEAR(
            test::derivative([&](double s) { return double(obstacle_->at(packed(sum(x, s, e))).normal[j][0]); }),
            double(found.bend[j][i][0]), 1e-7);
    }
  }
}

TEST_P(RoundObstacleTest, TheMeanNormalMeasuresTheChangeOfTheGapToRounding) {
  for (int k = 0; k < 200; ++k) {
    const Point x0 = free_point(), x1 = free_point(), d = sum(x1, -1, x0);
    const MeanGap mean = obstacle_->mean(packed(x0), packed(x1));
    const Point n{mean.normal[0][0], mean.normal[1][0], mean.normal[2][0]};
    EXPECT_NEAR(dot(n, d), gap(x1) - gap(x0), 1e-13);
    for (std::size_t j = 0; j < 3; ++j) {
      Point e{};
      e[j] = 1;
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(test::derivative([&](double s) {
                      return double(obstacle_->mean(packed(x0), packed(sum(x1, s, e))).normal[i][0]);
                    }),
                    double(mean.slope[i][j][0]), 1e-7);
    }
    // No moment about the centre, or about the axis: the force is parallel to the mean position across it.
    const Point y = sum(sum(sum({}, 0.5, x0), 0.5, x1), -1, center);
    const Point moment{y[1] * n[2] - y[2] * n[1], y[2] * n[0] - y[0] * n[2], y[0] * n[1] - y[1] * n[0]};
    if (GetParam().axial)
      EXPECT_NEAR(dot(moment, axis), 0, 1e-14);
    else
      EXPECT_NEAR(dot(moment, moment), 0, 1e-28);
  }
}

TEST_P(RoundObstacleTest, LeastGapAndAdmissibleStepAreExact) {
  for (int k = 0; k < 300; ++k) {
    const Point x0 = free_point(), x1 = free_point(), d = sum(x1, -1, x0);
    const double least = 0.04, step = obstacle_->admissible_step(packed(x0), packed(d), least)[0];
    double sampled = gap(x0), reached = 1;
    constexpr int samples = 4000;
    for (int i = samples; i >= 0; --i) {
      const double there = gap(sum(x0, static_cast<double>(i) / samples, d));
      sampled = std::min(sampled, there);
      if (there < least) reached = static_cast<double>(i) / samples;
    }
    const double bound = obstacle_->least_gap(packed(x0), packed(x1))[0];
    EXPECT_LE(bound, sampled + 1e-14);
    EXPECT_NEAR(bound, sampled, 0.01);
    EXPECT_NEAR(step, reached, 1.0 / samples + 1e-12);
    EXPECT_GE(gap(sum(x0, step, d)), least - 1e-13);
  }
}

TEST_P(RoundObstacleTest, ADirectionOfZeroLengthIsAdmissible) {
  EXPECT_EQ(obstacle_->admissible_step(packed(free_point()), packed({}), 0.04)[0], 1);
}

// A force needs no direction there: all directions are alike.
TEST_P(RoundObstacleTest, AtTheCentreTheNormalIsZero) {
  const ObstacleGap found = obstacle_->at(packed(center));
  EXPECT_EQ(found.gap[0], GetParam().cavity ? radius : -radius);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(found.normal[i][0], 0);
}

INSTANTIATE_TEST_SUITE_P(All, RoundObstacleTest,
                         testing::Values(Case{false, false}, Case{false, true}, Case{true, false}, Case{true, true}));

TEST(CylinderTest, TheAxisIsAcrossThePlaneOrInIt) {
  const Settings settings{{"Radius", 2.0}, {"Axis", {0.0, 0.0, 5.0}}};
  EXPECT_NEAR(make_obstacle("Cylinder", 3, settings)->at({3.0, 4.0, 9.0}).gap[0], 3, 1e-15);
  EXPECT_NEAR(make_obstacle("Cylinder", 2, {{"Radius", 2.0}})->at({3.0, 4.0, 0.0}).gap[0], 3, 1e-15);
  const Settings strip{{"Radius", 2.0}, {"Axis", {0.0, 1.0}}};
  EXPECT_NEAR(make_obstacle("Cylinder", 2, strip)->at({-3.0, 40.0, 0.0}).gap[0], 1, 1e-15);
}

TEST(CoaxialTest, SpheresCylindersAndConesOnTheAxisAre) {
  const auto is_coaxial = [](const std::string& name, const Settings& more) {
    Settings settings = more;
    settings.emplace_back("Radius", 2.0);
    return make_obstacle(name, 2, settings)->is_coaxial();
  };
  EXPECT_TRUE(is_coaxial("Sphere", {{"Center", {0.0, 3.0}}}));
  EXPECT_FALSE(is_coaxial("Sphere", {{"Center", {1e-3, 3.0}}}));
  EXPECT_FALSE(is_coaxial("Cylinder", {}));
  EXPECT_TRUE(is_coaxial("Cylinder", {{"Axis", {0.0, -2.0}}}));
  EXPECT_FALSE(is_coaxial("Cylinder", {{"Axis", {1.0, 0.0}}}));
  EXPECT_TRUE(is_coaxial("Cone", {}));
  EXPECT_FALSE(is_coaxial("Cone", {{"Tip", {0.5, 0.0}}}));
  EXPECT_FALSE(is_coaxial("Cone", {{"Axis", {0.1, 1.0}}}));
}

TEST(RoundAreaFactorTest, RefersToTheRadiusOfTheSurface) {
  const auto factor_of = [](const std::string& name, int dimension, bool cavity, int body_dimension) {
    const Settings settings{{"Radius", 2.0}, {"Cavity", cavity}, {"Area Factor", true}};
    return make_obstacle(name, static_cast<std::size_t>(dimension), settings)->area_factor(body_dimension);
  };
  EXPECT_FALSE(make_obstacle("Sphere", 3, {{"Radius", 2.0}})->area_factor(3));
  EXPECT_EQ(factor_of("Sphere", 3, false, 3)->power, 2);
  EXPECT_EQ(factor_of("Sphere", 2, false, 2)->power, 1);
  EXPECT_EQ(factor_of("Sphere", 2, false, 3)->power, 2);  // a body of revolution
  EXPECT_EQ(factor_of("Cylinder", 3, false, 3)->power, 1);
  EXPECT_EQ(factor_of("Sphere", 3, false, 3)->radius, 2);
  EXPECT_EQ(factor_of("Sphere", 3, true, 3)->radius, -2);
  const auto strip = make_obstacle("Cylinder", 2, {{"Radius", 2.0}, {"Axis", {0.0, 1.0}}, {"Area Factor", true}});
  EXPECT_EQ(strip->area_factor(3)->power, 1);  // about the axis of a body of revolution
  EXPECT_EQ(strip->area_factor(3)->radius, 2);
  EXPECT_EQ(test::refusal([&] { strip->area_factor(2); }),
            "an Area Factor has no meaning in front of a strip, whose sides are flat");
}

}  // namespace
}  // namespace ixos
