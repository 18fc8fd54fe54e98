/// Checks that the obstacles of every shape must pass.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>

#include "interaction/obstacle.hpp"
#include "support/derivative.hpp"

namespace ixos::test {

using Point = std::array<double, 3>;

inline PackPoint packed(const Point& x) { return {x[0], x[1], x[2]}; }
inline Point sum(const Point& x, double factor, const Point& y) {
  return {x[0] + factor * y[0], x[1] + factor * y[1], x[2] + factor * y[2]};
}
inline double dot(const Point& x, const Point& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }
inline double gap(const Obstacle& obstacle, const Point& x) { return obstacle.at(packed(x)).gap[0]; }

/// Random points in a box, of which the third coordinate is 0 in two dimensions.
class RandomPoints {
 public:
  RandomPoints(const Point& lower, const Point& upper) : lower_(lower), upper_(upper) {}
  Point operator()() {
    Point x;
    for (std::size_t i = 0; i < 3; ++i) x[i] = std::uniform_real_distribution<double>(lower_[i], upper_[i])(random_);
    return x;
  }

 private:
  std::mt19937 random_{7};
  Point lower_, upper_;
};

/// Compares normal and bend at x with differences of the gap and of the normal. Steps are of size `step`.
inline void expect_derivatives(const Obstacle& obstacle, const Point& x, std::size_t dimension, double tolerance,
                               double step = 5e-4) {
  const ObstacleGap found = obstacle.at(packed(x));
  for (std::size_t i = 0; i < dimension; ++i) {
    Point e{};
    e[i] = 1;
    const auto normal_at = [&](double s, std::size_t j) {
      return double(obstacle.at(packed(sum(x, s, e))).normal[j][0]);
    };
    EXPECT_NEAR(derivative([&](double s) { return gap(obstacle, sum(x, s, e)); }, step), double(found.normal[i][0]),
                tolerance)
        << "at " << x[0] << ' ' << x[1] << ' ' << x[2];
    for (std::size_t j = 0; j < dimension; ++j) {
      EXPECT_NEAR(derivative([&](double s) { return normal_at(s, j); }, step), double(found.bend[j][i][0]),
                  10 * tolerance)
          << "at " << x[0] << ' ' << x[1] << ' ' << x[2];
      EXPECT_NEAR(found.bend[i][j][0], found.bend[j][i][0], 1e-13 * (1 + std::abs(found.bend[i][j][0])));
    }
  }
}

/// Checks that the mean normal between two points measures the change of the gap.
inline void expect_mean(const Obstacle& obstacle, const Point& x0, const Point& x1, double tolerance = 1e-13) {
  const MeanGap mean = obstacle.mean(packed(x0), packed(x1));
  const Point n{mean.normal[0][0], mean.normal[1][0], mean.normal[2][0]};
  EXPECT_NEAR(dot(n, sum(x1, -1, x0)), gap(obstacle, x1) - gap(obstacle, x0), tolerance);
}

/// Compares least_gap() and admissible_step() between two points with the gap at many points of the path. The former
/// may be less by `loss` times the length, the latter by the share `short_by`.
inline void expect_bounds(const Obstacle& obstacle, const Point& x0, const Point& x1, double least, double loss,
                          double short_by) {
  constexpr int samples = 400;
  const Point d = sum(x1, -1, x0);
  double lowest = gap(obstacle, x0), first = 1;
  for (int k = samples; k >= 0; --k) {
    const double s = static_cast<double>(k) / samples, there = gap(obstacle, sum(x0, s, d));
    lowest = std::min(lowest, there);
    if (there < least) first = s;
  }
  const double bound = obstacle.least_gap(packed(x0), packed(x1))[0];
  EXPECT_LE(bound, lowest + 1e-13);
  EXPECT_GE(bound, lowest - loss * std::sqrt(dot(d, d)) - 1e-13);
  if (gap(obstacle, x0) <= least) return;
  const double step = obstacle.admissible_step(packed(x0), packed(d), least)[0];
  EXPECT_LE(step, first + 1e-13);
  EXPECT_GE(step, (first - 1.0 / samples) * (1 - short_by));
  EXPECT_GE(gap(obstacle, sum(x0, step, d)), least - 1e-12);
}

}  // namespace ixos::test
