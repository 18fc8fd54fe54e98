#include "interaction/spline_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "support/derivative.hpp"

namespace ixos {
namespace {

/// A surface of 7 x 5 random heights.
SplineSurface<2> surface(bool periodic) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> height(-1, 1);
  std::vector<double> heights(35);
  for (double& h : heights) h = height(random);
  return SplineSurface<2>({SplineAxis(7, 0.5, periodic), SplineAxis(5, 0.8, periodic)}, heights);
}

TEST(SplineSurfaceTest, PassesThroughTheHeights) {
  std::vector<double> heights(35);
  for (std::size_t k = 0; k < 35; ++k) heights[k] = std::sin(static_cast<double>(k * k));
  for (const bool periodic : {false, true}) {
    const SplineSurface<2> spline({SplineAxis(7, 0.5, periodic), SplineAxis(5, 0.8, periodic)}, heights);
    for (std::size_t j = 0; j < 5; ++j)
      for (std::size_t i = 0; i < 7; ++i) {
        const double x = -1.5 + 0.5 * static_cast<double>(i), y = -1.6 + 0.8 * static_cast<double>(j);
        EXPECT_NEAR(spline.at({Pack(x), Pack(y)}).value[0], heights[i + 7 * j], 1e-14);
      }
  }
}

TEST(SplineSurfaceTest, SlopesAndBendsAreDerivativesAndBounded) {
  for (const bool periodic : {false, true}) {
    const SplineSurface<2> spline = surface(periodic);
    double steepest = 0, deepest = 0, sharpest = 0;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> inside(-1.5, 1.5);
    for (int k = 0; k < 2000; ++k) {
      const double x = inside(random), y = inside(random);
      const Height<2> h = spline.at({Pack(x), Pack(y)});
      const auto at = [&](double s, double t) { return spline.at({Pack(x + s), Pack(y + t)}); };
      if (k < 50) {
        for (std::size_t i = 0; i < 2; ++i) {
          const auto along = [&](double s) { return i == 0 ? at(s, 0) : at(0, s); };
          EXPECT_NEAR(test::derivative([&](double s) { return double(along(s).value[0]); }, 1e-4),
                      double(h.slope[i][0]), 1e-6);
          for (std::size_t j = 0; j < 2; ++j)
            EXPECT_NEAR(test::derivative([&](double s) { return double(along(s).slope[j][0]); }, 1e-4),
                        double(h.bend[j][i][0]), 1e-2);
        }
      }
      const double a = h.bend[0][0][0], b = h.bend[1][1][0], c = h.bend[0][1][0];
      const double mean = (a + b) / 2, radius = std::hypot((a - b) / 2, c);
      steepest = std::max(steepest, std::hypot(double(h.slope[0][0]), double(h.slope[1][0])));
      deepest = std::max(deepest, mean + radius);
      sharpest = std::max(sharpest, std::max(mean + radius, radius - mean));
    }
    EXPECT_LE(steepest, spline.steepest());
    EXPECT_LE(deepest, spline.deepest());
    EXPECT_LE(sharpest, spline.sharpest());
    EXPECT_GE(steepest, 0.3 * spline.steepest()) << "the bound is no good";
    EXPECT_GE(sharpest, 0.3 * spline.sharpest()) << "the bound is no good";
  }
}

TEST(SplineSurfaceTest, LanesAreApart) {
  const SplineSurface<2> spline = surface(true);
  GraphPoint<2> place;
  for (std::size_t l = 0; l < Pack::size(); ++l) {
    place[0][l] = 0.37 * static_cast<double>(l) - 2;
    place[1][l] = 0.9 * static_cast<double>(l) - 3;
  }
  const Height<2> all = spline.at(place);
  for (std::size_t l = 0; l < Pack::size(); ++l)
    EXPECT_EQ(double(all.value[l]), double(spline.at({Pack(double(place[0][l])), Pack(double(place[1][l]))}).value[0]));
}

TEST(SplineSurfaceTest, TheEdgeIsTheNearestOfFour) {
  EXPECT_NEAR(surface(false).to_edge({Pack(1.2), Pack(0.0)})[0], 0.3, 1e-15);
  EXPECT_NEAR(surface(false).to_edge({Pack(0.0), Pack(-1.7)})[0], -0.1, 1e-15);
  EXPECT_EQ(surface(true).to_edge({Pack(9.0), Pack(0.0)})[0], std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace ixos
