#include "interaction/graph_obstacle.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include <limits>
#include <string>
#include <tuple>

#include "interaction/catalogue.hpp"
#include "interaction/obstacle_fixture.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

using test::Point;

constexpr double period = 8, k = 2 * M_PI / period;

std::shared_ptr<const Obstacle> waves(std::size_t dimension, double amplitude, double second = 0,
                                      const char* measure = "Distance") {
  return make_obstacle("Sine Wall", dimension,
                       {{"Amplitude", amplitude},
                        {"Period", period},
                        {"Second Amplitude", second},
                        {"Second Period", 5.0},
                        {"Gap", measure}});
}

/// Returns the least distance from the curve A cos(k a): the best of many places, improved by Newton's method on the
/// square of the distance.
double distance(double amplitude, double x, double z) {
  const auto square = [&](double a) { return std::pow(a - x, 2) + std::pow(amplitude * std::cos(k * a) - z, 2); };
  double best = x;
  for (int i = -8000; i <= 8000; ++i)
    if (square(x + i * 1e-3) < square(best)) best = x + i * 1e-3;
  for (int round = 0; round < 20; ++round) {
    const double h = amplitude * std::cos(k * best), p = -amplitude * k * std::sin(k * best), bend = -k * k * h;
    best -= (best - x + (h - z) * p) / (1 + p * p + (h - z) * bend);
  }
  return std::sqrt(square(best));
}

// Slopes up to 5, beyond the reach, too: the projection of a point is in the half wave of the point.
TEST(GraphObstacleTest, TheGapToOneWaveIsTheDistanceEverywhere) {
  for (double slope : {0.1, 0.39, 1.0, 2.0, 5.0}) {
    const double amplitude = slope / k;
    const auto wall = waves(2, amplitude);
    test::RandomPoints points({-10, -amplitude, 0}, {10, amplitude + 4, 0});
    for (int i = 0; i < 100; ++i) {
      const Point x = points();
      const double sign = x[1] > amplitude * std::cos(k * x[0]) ? 1 : -1;
      EXPECT_NEAR(test::gap(*wall, x), sign * distance(amplitude, x[0], x[1]), 1e-10)
          << slope << " at " << x[0] << ' ' << x[1];
    }
  }
}

TEST(GraphObstacleTest, AboveCrestAndTroughTheGapIsTheHeight) {
  const auto wall = waves(2, 0.5);
  for (double height : {1e-9, 0.01, 0.5, 3.0}) {
    EXPECT_NEAR(test::gap(*wall, {0, 0.5 + height, 0}), height, 1e-15);
    EXPECT_NEAR(test::gap(*wall, {period / 2, -0.5 + height, 0}), height, 2e-15);
  }
  // kappa = A k^2 at a crest, -A k^2 at a trough.
  const double kappa = 0.5 * k * k, g = 0.3;
  EXPECT_NEAR(wall->at(test::packed({0, 0.5 + g, 0})).bend[0][0][0], kappa / (1 + kappa * g), 1e-14);
  EXPECT_NEAR(wall->at(test::packed({period / 2, g - 0.5, 0})).bend[0][0][0], -kappa / (1 - kappa * g), 1e-14);
}

TEST(GraphObstacleTest, TheReachIsTheRadiusOfTheTrough) {
  EXPECT_NEAR(waves(2, 0.5)->reach(), 1 / (0.5 * k * k), 1e-15);
  EXPECT_EQ(waves(2, 0.5, 0, "Vertical")->reach(), std::numeric_limits<double>::infinity());
  // The second derivatives are finite at that height.
  const ObstacleGap found = waves(2, 0.5)->at(test::packed({period / 2, 1 / (0.5 * k * k) - 0.5, 0}));
  EXPECT_TRUE(std::isfinite(found.bend[0][0][0]));
}

/// Returns the least distance from a surface of two waves within the reach: the best of many places, improved by
/// coordinate steps of falling size.
double distance(double first, double second, const Point& x) {
  const double across = 2 * M_PI / 5;
  const auto square = [&](double a, double b) {
    const double h = first * std::cos(k * a) + second * std::cos(across * b);
    return std::pow(a - x[0], 2) + std::pow(b - x[1], 2) + std::pow(h - x[2], 2);
  };
  double a = x[0], b = x[1];
  for (int i = -60; i <= 60; ++i)
    for (int j = -60; j <= 60; ++j)
      if (square(x[0] + 0.05 * i, x[1] + 0.05 * j) < square(a, b)) {
        a = x[0] + 0.05 * i;
        b = x[1] + 0.05 * j;
      }
  for (double step = 0.05; step > 1e-9;) {
    double best_a = a, best_b = b;
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        if (square(a + step * i, b + step * j) < square(best_a, best_b)) {
          best_a = a + step * i;
          best_b = b + step * j;
        }
    if (best_a == a && best_b == b) step /= 2;
    a = best_a;
    b = best_b;
  }
  return std::sqrt(square(a, b));
}

TEST(GraphObstacleTest, TheGapToTwoWavesIsTheDistanceWithinTheReach) {
  for (double size : {0.3, 1.0}) {
    const auto wall = waves(3, size, 0.7 * size);
    test::RandomPoints points({-10, -10, -1.7 * size}, {10, 10, 1.7 * size + 1});
    int counted = 0;
    for (int i = 0; i < 200; ++i) {
      const Point x = points();
      const double gap = test::gap(*wall, x);
      if (gap < 0) continue;
      const double expected = distance(size, 0.7 * size, x);
      if (expected > 0.95 * wall->reach()) continue;
      ++counted;
      EXPECT_NEAR(gap, expected, 1e-9) << size << " at " << x[0] << ' ' << x[1] << ' ' << x[2];
    }
    EXPECT_GT(counted, 20);
  }
}

TEST(GraphObstacleTest, NormalAndBendAreDerivativesOnBothSides) {
  test::RandomPoints points({-10, -10, -1}, {10, 10, 1});
  for (const auto& [dimension, second, measure] :
       {std::tuple{2U, 0.0, "Distance"}, {3U, 0.0, "Distance"}, {3U, 0.3, "Distance"}, {3U, 0.3, "Vertical"}}) {
    const auto wall = waves(dimension, 0.4, second, measure);
    for (int i = 0; i < 100; ++i) {
      Point x = points();
      if (dimension == 2) x = {x[0], x[2], 0};
      // Near the reach the second derivatives change faster than the differences resolve.
      if (std::abs(test::gap(*wall, x)) < 0.6 / (0.4 * k * k + second * 1.6))
        test::expect_derivatives(*wall, x, dimension, 2e-8);
    }
  }
}

TEST(GraphObstacleTest, MeansMeasureTheChangeOfTheGap) {
  test::RandomPoints points({-10, -10, 0.3}, {10, 10, 1.5});
  for (const char* measure : {"Distance", "Vertical"}) {
    const auto wall = waves(3, 0.15, 0.1, measure);
    for (int i = 0; i < 100; ++i) {
      const Point x0 = points(), x1 = points();
      test::expect_mean(*wall, x0, x1);
      test::expect_mean(*wall, x0, test::sum(x0, 0.01, test::sum(x1, -1, x0)));
    }
  }
}

TEST(GraphObstacleTest, BoundsHoldBeforeSteepWallsToo) {
  for (const char* measure : {"Distance", "Vertical"})
    for (double slope : {0.3, 1.0, 5.0}) {
      const double amplitude = slope / k;
      const auto plane = waves(2, amplitude, 0, measure), space = waves(3, amplitude, amplitude / 3, measure);
      const bool vertical = std::string(measure) == "Vertical";
      test::RandomPoints points({-10, -10, -amplitude}, {10, 10, amplitude + 2});
      for (int i = 0; i < 60; ++i) {
        const Point x0 = points(), x1 = points();
        const Point y0{x0[0], x0[2], 0}, y1{x1[0], x1[2], 0};
        // The vertical gap changes by up to w times the length.
        const double loss = (vertical ? 1 + 1.5 * slope : 1.0) / 8;
        if (test::gap(*plane, y0) > 0.1)
          test::expect_bounds(*plane, y0, y1, 0.05, slope < 1 ? loss : 20.0, slope < 2 ? 0.5 : 0.9);
        if (test::gap(*space, x0) > 0.1) test::expect_bounds(*space, x0, x1, 0.05, 20.0, slope < 2 ? 0.5 : 0.9);
      }
    }
}

TEST(GraphObstacleTest, ATurnedAndMovedWallIsTheSameWall) {
  const double c = 0.8, s = 0.6;
  const auto wall = waves(2, 0.4);
  const auto turned = make_obstacle(
      "Sine Wall", 2, {{"Amplitude", 0.4}, {"Period", period}, {"Point", {1.0, -2.0}}, {"Normal", {s, c}}});
  for (double x : {0.3, 1.7, 3.9})
    for (double z : {0.6, 1.2}) {
      const ObstacleGap a = wall->at(test::packed({x, z, 0}));
      const ObstacleGap b = turned->at(test::packed({1 + c * x + s * z, -2 - s * x + c * z, 0}));
      EXPECT_NEAR(a.gap[0], b.gap[0], 1e-14);
      EXPECT_NEAR(c * a.normal[0][0] + s * a.normal[1][0], b.normal[0][0], 1e-14);
    }
  // In three dimensions the direction is that of the wave.
  const auto across =
      make_obstacle("Sine Wall", 3, {{"Amplitude", 0.4}, {"Period", period}, {"Direction", {0.0, 2.0, 1.0}}});
  EXPECT_NEAR(test::gap(*across, {5, 1.3, 0.9}), test::gap(*wall, {1.3, 0.9, 0}), 1e-14);
}

TEST(GraphObstacleTest, WhatHasNoMeaningIsRefused) {
  const auto refused = [](std::size_t dimension, const Setting& more, const std::string& words) {
    const Settings settings{{"Amplitude", 0.4}, {"Period", period}, more};
    test::expect_contains(test::refusal([&] { make_obstacle("Sine Wall", dimension, settings); }), words);
  };
  refused(2, {"Second Amplitude", 0.1}, "Second Amplitude: must be 0 in two dimensions");
  refused(2, {"Direction", {1.0, 0.0}}, "Direction: not allowed in two dimensions");
  refused(3, {"Direction", {0.0, 0.0, 1.0}}, "Direction: is parallel to the normal");
  refused(3, {"Normal", {0.0, 0.0, 0.0}}, "Normal is zero: it must point out of the wall");
}

}  // namespace
}  // namespace ixos
