#include "interaction/obstacle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ixos {
namespace {

using Point = std::array<double, 3>;

PackPoint packed(const Point& x) { return {x[0], x[1], x[2]}; }

Point sum(const Point& x, double factor, const Point& y) {
  return {x[0] + factor * y[0], x[1] + factor * y[1], x[2] + factor * y[2]};
}

/// The obstacles of this file say where they are, and no more: the rest is Obstacle's own.
class Plane final : public Obstacle {
 public:
  Plane(const Point& normal, double offset) : normal_(normal), offset_(offset) {}
  Sight at(const PackPoint& x) const override {
    Sight sight;
    sight.gap = x[0] * normal_[0] + x[1] * normal_[1] + x[2] * normal_[2] - offset_;
    sight.normal = packed(normal_);
    return sight;
  }

 private:
  Point normal_;
  double offset_;
};

/// A ball about the origin.
class Ball final : public Obstacle {
 public:
  explicit Ball(double radius) : radius_(radius) {}
  Sight at(const PackPoint& x) const override {
    const Pack distance = std::experimental::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    Sight sight;
    sight.gap = distance - radius_;
    for (std::size_t i = 0; i < 3; ++i) sight.normal[i] = x[i] / distance;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        sight.bend[i][j] = ((i == j ? 1.0 : 0.0) - sight.normal[i] * sight.normal[j]) / distance;
    return sight;
  }

 private:
  double radius_;
};

/// The "gap" x^p/p: no distance, but its mean normal has a closed form.
class Power final : public Obstacle {
 public:
  explicit Power(int p) : p_(p) {}
  Sight at(const PackPoint& x) const override {
    Sight sight;
    sight.normal = {power(x[0], p_ - 1), Pack(0.0), Pack(0.0)};
    sight.gap = power(x[0], p_) / p_;
    sight.bend[0][0] = (p_ - 1) * power(x[0], p_ - 2);
    return sight;
  }

 private:
  static Pack power(const Pack& x, int p) {
    Pack result = 1.0;
    for (int k = 0; k < p; ++k) result *= x;
    return result;
  }
  int p_;
};

/// The "gap" x y z.
class Saddle final : public Obstacle {
 public:
  Sight at(const PackPoint& x) const override {
    Sight sight;
    sight.gap = x[0] * x[1] * x[2];
    sight.normal = {x[1] * x[2], x[0] * x[2], x[0] * x[1]};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if (i != j) sight.bend[i][j] = x[3 - i - j];
    return sight;
  }
};

const Point tilt{0.48, 0.6, 0.64};

double dot(const Point& x, const Point& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }

/// Returns n . (x1 - x0) with the mean normal.
double change(const Obstacle& obstacle, const Point& x0, const Point& x1) {
  const MeanSight mean = obstacle.mean(packed(x0), packed(x1));
  double result = 0;
  for (std::size_t i = 0; i < 3; ++i) result += lane(mean.normal[i], 0) * (x1[i] - x0[i]);
  return result;
}

double gap(const Obstacle& obstacle, const Point& x) { return obstacle.at(packed(x)).gap[0]; }

TEST(ObstacleMeanTest, OfAPlaneIsItsNormal) {
  const Plane plane(tilt, 0.5);
  const MeanSight mean = plane.mean(packed({1.0, -2.0, 0.5}), packed({3.0, 0.7, -1.5}));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(lane(mean.normal[i], 0), tilt[i], 1e-14);
    for (std::size_t j = 0; j < 3; ++j) EXPECT_EQ(lane(mean.slope[i][j], 0), 0);
  }
}

TEST(ObstacleMeanTest, WithoutAWayIsTheNormalThere) {
  const Ball ball(1);
  const PackPoint x = packed({1.0, 2.0, -1.5});
  const Sight sight = ball.at(x);
  const MeanSight mean = ball.mean(x, x);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(lane(mean.normal[i], 0), lane(sight.normal[i], 0), 1e-14);
    // The second point moves the points between by half its own way in the mean.
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(lane(mean.slope[i][j], 0), lane(sight.bend[i][j], 0) / 2, 1e-14);
  }
}

TEST(ObstacleMeanTest, IsExactForPolynomialsUpToDegreeSix) {
  for (int p = 2; p <= 6; ++p) {
    Pack x0 = 0.0, x1 = 0.0;  // a way of its own in each lane
    for (std::size_t i = 0; i < Pack::size(); ++i) {
      x0[i] = 0.3 + 0.05 * static_cast<double>(i);
      x1[i] = 1.2 - 0.04 * static_cast<double>(i);
    }
    const MeanSight mean = Power(p).mean({x0, Pack(0.0), Pack(0.0)}, {x1, Pack(0.0), Pack(0.0)});
    for (std::size_t i = 0; i < Pack::size(); ++i) {
      const double a = lane(x0, i), b = lane(x1, i), way = b - a;
      const double normal = (std::pow(b, p) - std::pow(a, p)) / (p * way);
      EXPECT_NEAR(lane(mean.normal[0], i), normal, 1e-13) << p << ' ' << i;
      EXPECT_NEAR(lane(mean.slope[0][0], i), (std::pow(b, p - 1) - normal) / way, 1e-12) << p << ' ' << i;
    }
  }
}

// Over a way h, the mean of x^6 exceeds that of 3 Gauss points by h^6/2800: the mean square of the cubic polynomial
// with leading coefficient 1 that vanishes at the points.
TEST(ObstacleMeanTest, HasTheErrorOfThreeGaussPoints) {
  for (double h : {0.5, 1.0, 2.0}) {
    const double defect =
        gap(Power(7), {0.4 + h, 0, 0}) - gap(Power(7), {0.4, 0, 0}) - change(Power(7), {0.4, 0, 0}, {0.4 + h, 0, 0});
    EXPECT_NEAR(defect, std::pow(h, 7) / 2800, 1e-13 * std::pow(0.4 + h, 7));
  }
  // The error of the change of the gap is of order 7: half the way has 1/128 of it, in the limit of short ways.
  const Ball ball(1);
  const Point x{1.5, 0.5, 0.0}, d{-0.4, 0.3, 0.5};
  const auto error = [&](double s) {
    return std::abs(change(ball, x, sum(x, s, d)) - gap(ball, sum(x, s, d)) + gap(ball, x));
  };
  EXPECT_LT(error(0.5), error(1.0) / 100);
  EXPECT_GT(error(1.0), 1e-10);
}

TEST(ObstacleMeanTest, ComponentsStandInTheirPlaces) {
  const Point x0{0.3, 1.1, -0.7}, x1{0.9, 0.4, 0.6};
  const Saddle saddle;
  EXPECT_NEAR(change(saddle, x0, x1), gap(saddle, x1) - gap(saddle, x0), 1e-14);
  const MeanSight mean = saddle.mean(packed(x0), packed(x1));
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      // The integral of s ((1 - s) x0 + s x1) over s from 0 to 1, in the coordinate that is neither i nor j.
      const double expected = i == j ? 0.0 : x0[3 - i - j] / 6 + x1[3 - i - j] / 3;
      EXPECT_NEAR(lane(mean.slope[i][j], 0), expected, 1e-14) << i << ' ' << j;
    }
}

// Before a plane, a round goes the share c of the way that is left, where c is the cosine of the angle of incidence:
// six rounds go 1 - (1 - c)^6 of it. The formula holds for directions away from the plane too, c < 0.
TEST(ObstacleStepTest, BeforeAPlaneIsAGeometricSeries) {
  const Plane plane(tilt, 0.5);
  const Point x{1.0, 2.0, 3.0}, along{0.8, 0.0, -0.6};
  ASSERT_NEAR(dot(tilt, along), 0, 1e-14);
  const double least = 0.25, room = gap(plane, x) - least;
  for (double c : {1.0, 0.9, 0.5, 0.1, -0.3}) {
    const double s = std::sqrt(1 - c * c);
    PackPoint d{};
    for (std::size_t i = 0; i < Pack::size(); ++i)  // lanes differ in the length of the direction
      for (std::size_t k = 0; k < 3; ++k)
        d[k][i] = std::pow(4.0, static_cast<double>(i)) * (s * along[k] - c * tilt[k]);
    const Pack step = plane.admissible_step(packed(x), d, least);
    for (std::size_t i = 0; i < Pack::size(); ++i) {
      const double length = std::pow(4.0, static_cast<double>(i));
      EXPECT_NEAR(lane(step, i), std::min(1.0, room / (c * length) * (1 - std::pow(1 - c, 6))), 1e-13) << c << ' ' << i;
    }
  }
}

// The gap to a ball is convex along a line. Therefore no round passes the bound. Each round advances at least as far as
// before the plane that is tangent where the line arrives.
TEST(ObstacleStepTest, BeforeABallNearlyReachesTheBound) {
  const double radius = 1, least = 0.2, distance = 3, length = 5;
  const Ball ball(radius);
  for (double angle : {0.0, 0.1, 0.2, 0.3, 0.4}) {
    const Point x{distance, 0, 0}, d{-length * std::cos(angle), length * std::sin(angle), 0};
    const double half_chord = std::sqrt((radius + least) * (radius + least) - std::pow(distance * std::sin(angle), 2));
    const double exact = (distance * std::cos(angle) - half_chord) / length;
    const double cosine = half_chord / (radius + least);
    const double step = ball.admissible_step(packed(x), packed(d), least)[0];
    EXPECT_LE(step, exact * (1 + 1e-14)) << angle;
    EXPECT_GE(step, exact * (1 - std::pow(1 - cosine, 6)) * (1 - 1e-14)) << angle;
    EXPECT_GE(gap(ball, sum(x, step, d)), least - 1e-14) << angle;
  }
}

TEST(ObstacleStepTest, ShortAndRecedingStepsAreWhole) {
  const Ball ball(1);
  const Point x{3, 0, 0};
  for (const Point& d : {Point{0, 0, 0}, Point{-1.7, 0, 0}, Point{0, 1.7, 0}, Point{5, 0, 0}})
    EXPECT_EQ(ball.admissible_step(packed(x), packed(d), 0.25)[0], 1.0);
}

TEST(FlatWallTest, IsTheHalfSpace) {
  HalfSpace wall;
  wall.point = {0.3, -0.2, 0.1};
  wall.normal = tilt;
  const auto obstacle = flat_wall(wall);
  ASSERT_NE(obstacle->half_space(), nullptr);
  EXPECT_EQ(obstacle->half_space()->point, wall.point);
  EXPECT_EQ(obstacle->half_space()->normal, wall.normal);
  EXPECT_NEAR(gap(*obstacle, sum(sum(wall.point, 0.75, tilt), 2.0, {0.8, 0.0, -0.6})), 0.75, 1e-14);
  EXPECT_EQ(Ball(1).half_space(), nullptr);
}

}  // namespace
}  // namespace ixos
