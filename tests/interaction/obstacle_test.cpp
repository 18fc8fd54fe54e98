#include "interaction/obstacle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "interaction/obstacle_fixture.hpp"

namespace ixos {
namespace {

using test::dot;
using test::gap;
using test::packed;
using test::Point;
using test::sum;

/// The obstacles of this file say where they are, and no more: the rest is Obstacle's own.
class Plane final : public Obstacle {
 public:
  Plane(const Point& normal, double offset) : normal_(normal), offset_(offset) {}
  ObstacleGap at(const PackPoint& x) const override {
    ObstacleGap found;
    found.gap = x[0] * normal_[0] + x[1] * normal_[1] + x[2] * normal_[2] - offset_;
    found.normal = packed(normal_);
    return found;
  }

 private:
  Point normal_;
  double offset_;
};

/// A ball about the origin.
class Ball final : public Obstacle {
 public:
  explicit Ball(double radius) : radius_(radius) {}
  ObstacleGap at(const PackPoint& x) const override {
    const Pack distance = std::experimental::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    ObstacleGap found;
    found.gap = distance - radius_;
    for (std::size_t i = 0; i < 3; ++i) found.normal[i] = x[i] / distance;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        found.bend[i][j] = ((i == j ? 1.0 : 0.0) - found.normal[i] * found.normal[j]) / distance;
    return found;
  }

 private:
  double radius_;
};

/// The "gap" x^p/p: no distance, but its mean normal has a closed form.
class Power final : public Obstacle {
 public:
  explicit Power(int p) : p_(p) {}
  ObstacleGap at(const PackPoint& x) const override {
    ObstacleGap found;
    found.normal = {power(x[0], p_ - 1), Pack(0.0), Pack(0.0)};
    found.gap = power(x[0], p_) / p_;
    found.bend[0][0] = (p_ - 1) * power(x[0], p_ - 2);
    return found;
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
  ObstacleGap at(const PackPoint& x) const override {
    ObstacleGap found;
    found.gap = x[0] * x[1] * x[2];
    found.normal = {x[1] * x[2], x[0] * x[2], x[0] * x[1]};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if (i != j) found.bend[i][j] = x[3 - i - j];
    return found;
  }
};

const Point tilt{0.48, 0.6, 0.64};

/// Returns n . (x1 - x0) with the mean normal.
double change(const Obstacle& obstacle, const Point& x0, const Point& x1) {
  const MeanGap mean = obstacle.mean(packed(x0), packed(x1));
  double result = 0;
  for (std::size_t i = 0; i < 3; ++i) result += lane(mean.normal[i], 0) * (x1[i] - x0[i]);
  return result;
}

TEST(ObstacleMeanTest, OfAPlaneIsItsNormal) {
  const Plane plane(tilt, 0.5);
  const MeanGap mean = plane.mean(packed({1.0, -2.0, 0.5}), packed({3.0, 0.7, -1.5}));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(lane(mean.normal[i], 0), tilt[i], 1e-14);
    for (std::size_t j = 0; j < 3; ++j) EXPECT_EQ(lane(mean.slope[i][j], 0), 0);
  }
}

TEST(ObstacleMeanTest, WithoutAWayIsTheNormalThere) {
  const Ball ball(1);
  const PackPoint x = packed({1.0, 2.0, -1.5});
  const ObstacleGap found = ball.at(x);
  const MeanGap mean = ball.mean(x, x);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(lane(mean.normal[i], 0), lane(found.normal[i], 0), 1e-14);
    // The second point moves the points between by half its own way in the mean.
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(lane(mean.slope[i][j], 0), lane(found.bend[i][j], 0) / 2, 1e-14);
  }
}

TEST(ObstacleMeanTest, IsExactForPolynomialsUpToDegreeSix) {
  for (int p = 2; p <= 6; ++p) {
    Pack x0 = 0.0, x1 = 0.0;  // a way of its own in each lane
    for (std::size_t i = 0; i < Pack::size(); ++i) {
      x0[i] = 0.3 + 0.05 * static_cast<double>(i);
      x1[i] = 1.2 - 0.04 * static_cast<double>(i);
    }
    const MeanGap mean = Power(p).mean({x0, Pack(0.0), Pack(0.0)}, {x1, Pack(0.0), Pack(0.0)});
    for (std::size_t i = 0; i < Pack::size(); ++i) {
      const double a = lane(x0, i), b = lane(x1, i), way = b - a;
      const double normal = (std::pow(b, p) - std::pow(a, p)) / (p * way);
      EXPECT_NEAR(lane(mean.normal[0], i), normal, 1e-13) << p << ' ' << i;
      EXPECT_NEAR(lane(mean.slope[0][0], i), (std::pow(b, p - 1) - normal) / way, 1e-12) << p << ' ' << i;
    }
  }
}

// 3 Gauss points integrate x^6 with an error of h^6/2800 over a way h.
TEST(ObstacleMeanTest, IsCorrectedWhereGaussPointsAreNotExact) {
  for (double h : {0.01, 0.1, 0.5, 1.0, 2.0}) {
    const double expected = gap(Power(7), {0.4 + h, 0, 0}) - gap(Power(7), {0.4, 0, 0});
    EXPECT_NEAR(change(Power(7), {0.4, 0, 0}, {0.4 + h, 0, 0}), expected, 1e-14 * std::pow(0.4 + h, 7));
  }
}

/// Directions without order, of length 1.
Point direction(double phase) {
  const Point d{std::sin(phase), std::sin(1.7 * phase + 1), std::cos(2.9 * phase)};
  return sum({0, 0, 0}, 1 / std::sqrt(dot(d, d)), d);
}

// The normals turn by up to two right angles on the longest ways.
TEST(ObstacleMeanTest, MeasuresTheChangeOfTheGapBeforeABallToRounding) {
  const Ball ball(1);
  for (double length : {1e-12, 1e-8, 1e-4, 1e-3, 0.01, 0.03, 0.1, 0.3, 1.0, 4.0})
    for (int k = 0; k < 40; ++k) {
      const Point x0 = sum({0, 0, 0}, 1.01 + 0.02 * k, direction(k)), x1 = sum(x0, length, direction(k + 0.5));
      EXPECT_NEAR(change(ball, x0, x1), gap(ball, x1) - gap(ball, x0), 1e-14) << length << ' ' << k;
    }
}

/// The space between two parallel planes: its gap has a kink half way.
class Slit final : public Obstacle {
 public:
  ObstacleGap at(const PackPoint& x) const override {
    const auto lower = x[1] < 0.5;
    ObstacleGap found;
    found.gap = select(lower, x[1], Pack(1.0 - x[1]));
    found.normal = {Pack(0.0), select(lower, Pack(1.0), Pack(-1.0)), Pack(0.0)};
    return found;
  }
};

TEST(ObstacleMeanTest, MeasuresTheChangeOfTheGapAcrossAKink) {
  for (double end : {0.55, 0.6, 0.7, 0.95}) {
    const Point x0{0.2, 0.3, 0.1}, x1{0.9, end, -0.4};
    EXPECT_NEAR(change(Slit(), x0, x1), gap(Slit(), x1) - gap(Slit(), x0), 1e-15) << end;
  }
}

// Differences of order 6 over steps of 1e-3 of the way.
TEST(ObstacleMeanTest, TheSlopeIsTheDerivativeInTheSecondPoint) {
  const Ball ball(1);
  for (double length : {0.001, 0.01, 0.1, 0.3, 1.0, 3.0})
    for (int k = 0; k < 20; ++k) {
      const Point x0 = sum({0, 0, 0}, 1.05 + 0.03 * k, direction(k)), way = direction(k + 0.5);
      const Point x1 = sum(x0, length, way);
      // Near the centre of the ball the normals turn faster than the differences resolve.
      const double share = std::min(std::max(-dot(x0, way) / length, 0.0), 1.0);
      const Point nearest = sum(x0, share * length, way);
      if (dot(nearest, nearest) < 0.5) continue;
      const MeanGap mean = ball.mean(packed(x0), packed(x1));
      const double h = 1e-3 * length;
      for (std::size_t j = 0; j < 3; ++j) {
        const auto normal_at = [&](int steps) {
          Point moved = x1;
          moved[j] += steps * h;
          return ball.mean(packed(x0), packed(moved)).normal;
        };
        const PackPoint a = normal_at(1), b = normal_at(-1), c = normal_at(2), d = normal_at(-2), e = normal_at(3),
                        f = normal_at(-3);
        for (std::size_t i = 0; i < 3; ++i) {
          const double difference = 45 * (lane(a[i], 0) - lane(b[i], 0)) - 9 * (lane(c[i], 0) - lane(d[i], 0)) +
                                    (lane(e[i], 0) - lane(f[i], 0));
          EXPECT_NEAR(lane(mean.slope[i][j], 0), difference / (60 * h), 1e-8 + 1e-14 / h) << length << ' ' << k;
        }
      }
    }
}

// One lane is corrected, the others are not.
TEST(ObstacleMeanTest, LanesAreCorrectedApart) {
  const Ball ball(1);
  const Point x0{1.2, 0.3, -0.2}, near = sum(x0, 1e-4, direction(1)), far = sum(x0, 2, direction(2));
  PackPoint x1 = packed(near);
  for (std::size_t i = 0; i < 3; ++i) x1[i][0] = far[i];
  const MeanGap both = ball.mean(packed(x0), x1), alone = ball.mean(packed(x0), packed(near)),
                other = ball.mean(packed(x0), packed(far));
  for (std::size_t l = 0; l < Pack::size(); ++l)
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(lane(both.normal[i], l), lane((l == 0 ? other : alone).normal[i], l));
      for (std::size_t j = 0; j < 3; ++j)
        EXPECT_EQ(lane(both.slope[i][j], l), lane((l == 0 ? other : alone).slope[i][j], l));
    }
}

TEST(ObstacleMeanTest, ComponentsStandInTheirPlaces) {
  const Point x0{0.3, 1.1, -0.7}, x1{0.9, 0.4, 0.6};
  const Saddle saddle;
  EXPECT_NEAR(change(saddle, x0, x1), gap(saddle, x1) - gap(saddle, x0), 1e-14);
  const MeanGap mean = saddle.mean(packed(x0), packed(x1));
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      // The integral of s ((1 - s) x0 + s x1) over s from 0 to 1, in the coordinate that is neither i nor j.
      const double expected = i == j ? 0.0 : x0[3 - i - j] / 6 + x1[3 - i - j] / 3;
      EXPECT_NEAR(lane(mean.slope[i][j], 0), expected, 1e-14) << i << ' ' << j;
    }
}

TEST(ObstaclePathTest, BeforeAPlaneAnEndIsNearest) {
  const Plane plane(tilt, 0.5);
  const Point x0{1.0, 2.0, 3.0};
  for (const Point& x1 : {x0, Point{2.0, 1.0, 1.0}, Point{4.0, 2.5, 3.5}})
    EXPECT_NEAR(plane.least_gap(packed(x0), packed(x1))[0], std::min(gap(plane, x0), gap(plane, x1)), 1e-14);
}

TEST(ObstaclePathTest, BeforeABallThePathIsBounded) {
  const Ball ball(1);
  for (double height : {1.05, 1.3, 0.8})  // the last path leads through the ball
    for (double from : {-2.0, -0.7, 0.3})
      for (double to : {-1.0, 0.4, 2.5}) {
        const Point x0{from, height, 0}, x1{to, height, 0};
        double sampled = gap(ball, x0);
        for (int k = 1; k <= 1000; ++k) sampled = std::min(sampled, gap(ball, sum(x0, k / 1000.0, {to - from, 0, 0})));
        const double bound = ball.least_gap(packed(x0), packed(x1))[0];
        EXPECT_LE(bound, sampled + 1e-14) << height << ' ' << from << ' ' << to;
        EXPECT_GE(bound, sampled - std::abs(to - from) / 8) << height << ' ' << from << ' ' << to;
        EXPECT_GE(bound, (gap(ball, x0) + gap(ball, x1) - std::abs(to - from)) / 2) << "the distance is Lipschitz";
      }
}

// The gap rises towards the middle of the slit.
TEST(ObstaclePathTest, InACavityAnEndIsNearest) {
  EXPECT_EQ(Slit().least_gap(packed({0.1, 0.2, 0.0}), packed({0.5, 0.9, 0.3}))[0], gap(Slit(), {0.5, 0.9, 0.3}));
}

// Before a plane, a round goes the share c of the way that is left, where c is the cosine of the angle of incidence:
// n rounds go 1 - (1 - c)^n of it, and there are as many as leave a thousandth, or 64. The formula holds for directions
// along the plane too, c = 0, and away from it, c < 0.
TEST(ObstacleStepTest, BeforeAPlaneIsAGeometricSeries) {
  const Plane plane(tilt, 0.5);
  const Point x{1.0, 2.0, 3.0}, along{0.8, 0.0, -0.6};
  ASSERT_NEAR(dot(tilt, along), 0, 1e-14);
  const double least = 0.25, room = gap(plane, x) - least;
  for (double c : {1.0, 0.9, 0.5, 0.1, 0.03, 0.0, -0.3}) {
    const double s = std::sqrt(1 - c * c);
    PackPoint d{};
    for (std::size_t i = 0; i < Pack::size(); ++i)  // lanes differ in the length of the direction
      for (std::size_t k = 0; k < 3; ++k)
        d[k][i] = std::pow(4.0, static_cast<double>(i)) * (s * along[k] - c * tilt[k]);
    const Pack step = plane.admissible_step(packed(x), d, least);
    const double series = c == 0 ? 64 : (1 - std::pow(1 - c, 64)) / c;
    for (std::size_t i = 0; i < Pack::size(); ++i) {
      const double length = std::pow(4.0, static_cast<double>(i));
      EXPECT_GE(lane(step, i), std::min(1.0, 0.999 * room / length * series) * (1 - 1e-13)) << c << ' ' << i;
      EXPECT_LE(lane(step, i), c > 0 ? std::min(1.0, room / (c * length) * (1 + 1e-13)) : 1.0) << c << ' ' << i;
    }
  }
}

// The gap to a ball is convex along a line. So it falls at least as fast as the plane that touches where the line
// arrives: where a thousandth of the gap is left, a thousandth of that over the cosine of the angle of incidence is
// left of the way.
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
    EXPECT_GE(step, exact * (1 - 1e-3 / cosine)) << angle;
    EXPECT_GE(gap(ball, sum(x, step, d)), least - 1e-14) << angle;
  }
}

/// A plane that counts how often it is asked.
class CountedPlane final : public Obstacle {
 public:
  ObstacleGap at(const PackPoint& x) const override {
    ++calls;
    return Plane({0, 1, 0}, 0).at(x);
  }
  mutable int calls = 0;
};

TEST(ObstacleStepTest, FarFromTheObstacleOneRoundIsEnough) {
  const CountedPlane plane;
  EXPECT_EQ(plane.admissible_step(packed({0, 3, 0}), packed({0.5, -1, 0}), 0.2)[0], 1.0);
  EXPECT_EQ(plane.calls, 1);
  // Straight ahead, a second one finds nothing left.
  EXPECT_NEAR(plane.admissible_step(packed({0, 3, 0}), packed({0, -4, 0}), 1)[0], 0.5, 1e-15);
  EXPECT_EQ(plane.calls, 3);
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
