#include "interaction/spline_axis.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/derivative.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

/// The spline through samples of an axis.
class Spline {
 public:
  Spline(const SplineAxis& axis, const std::vector<double>& values)
      : axis_(axis), coefficients_(axis.coefficients_of(values)) {}
  double value(double x) const { return sum(axis_.at(x).value, x); }
  double slope(double x) const { return axis_.per_distance() * sum(axis_.at(x).slope, x); }
  double bend(double x) const { return std::pow(axis_.per_distance(), 2) * sum(axis_.at(x).bend, x); }
  std::size_t coefficients() const { return coefficients_.size(); }

 private:
  double sum(const std::array<Pack, 4>& weights, double x) const {
    const auto first = static_cast<std::size_t>(double(axis_.at(x).piece[0]));
    double result = 0;
    for (std::size_t k = 0; k < 4; ++k) result += weights[k][0] * coefficients_[first + k];
    return result;
  }
  SplineAxis axis_;
  std::vector<double> coefficients_;
};

std::vector<double> samples(std::size_t count) {
  std::vector<double> result;
  for (std::size_t k = 0; k < count; ++k) result.push_back(std::sin(1.3 * static_cast<double>(k * k)));
  return result;
}

class SplineAxisTest : public testing::TestWithParam<bool> {};

TEST_P(SplineAxisTest, PassesThroughTheSamples) {
  for (std::size_t count : {4U, 5U, 20U}) {
    const SplineAxis axis(count, 0.5, GetParam());
    const std::vector<double> values = samples(count);
    const Spline spline(axis, values);
    EXPECT_EQ(spline.coefficients(), axis.coefficients());
    const double start = -0.25 * static_cast<double>(count - 1);
    for (std::size_t k = 0; k < count; ++k)
      EXPECT_NEAR(spline.value(start + 0.5 * static_cast<double>(k)), values[k], 1e-14);
  }
}

TEST_P(SplineAxisTest, SlopeAndBendAreDerivativesAndContinuous) {
  const Spline spline(SplineAxis(12, 0.5, GetParam()), samples(12));
  for (double x : {-4.1, -2.6, -1.1, 0.1, 0.9, 2.6, 3.3, 11.0}) {
    EXPECT_NEAR(test::derivative([&](double s) { return spline.value(x + s); }), spline.slope(x), 1e-9);
    EXPECT_NEAR(test::derivative([&](double s) { return spline.slope(x + s); }), spline.bend(x), 1e-8);
  }
  for (double knot : {-2.75, -2.25, 0.25, 2.25, 2.75}) {
    EXPECT_NEAR(spline.slope(knot - 1e-12), spline.slope(knot + 1e-12), 1e-9);
    EXPECT_NEAR(spline.bend(knot - 1e-12), spline.bend(knot + 1e-12), 1e-8);
  }
}

INSTANTIATE_TEST_SUITE_P(Ends, SplineAxisTest, testing::Bool());

TEST(SplineAxisEndsTest, ANaturalSplineGoesOnStraight) {
  const SplineAxis axis(6, 2, false);
  const Spline spline(axis, samples(6));
  EXPECT_NEAR(spline.bend(-5), 0, 1e-14);
  EXPECT_NEAR(spline.value(8), spline.value(5) + 3 * spline.slope(5), 1e-14);
  EXPECT_EQ(axis.to_end(4.0)[0], 1);
  EXPECT_EQ(axis.to_end(-5.5)[0], -0.5);
}

TEST(SplineAxisEndsTest, APeriodicSplineRepeats) {
  const Spline spline(SplineAxis(6, 2, true), samples(6));
  for (double x : {-5.3, 0.4, 5.7}) {
    EXPECT_NEAR(spline.value(x), spline.value(x + 12), 1e-14);
    EXPECT_NEAR(spline.bend(x), spline.bend(x - 36), 1e-13);
  }
}

// Halving the distances divides the error by 16.
TEST(SplineAxisEndsTest, AWaveIsInterpolatedWithOrderFour) {
  const auto error = [](std::size_t count) {
    const double distance = 2 * M_PI / static_cast<double>(count);
    std::vector<double> values;
    for (std::size_t k = 0; k < count; ++k)
      values.push_back(std::cos(distance * (static_cast<double>(k) - 0.5 * static_cast<double>(count - 1))));
    const Spline spline(SplineAxis(count, distance, true), values);
    double largest = 0;
    for (double x = -3; x < 3; x += 0.01) largest = std::max(largest, std::abs(spline.value(x) - std::cos(x)));
    return largest;
  };
  EXPECT_NEAR(std::log2(error(16) / error(32)), 4, 0.1);
}

TEST(SplineAxisEndsTest, TooFewSamplesAreRefused) {
  test::expect_contains(test::refusal([] { SplineAxis(3, 1, false); }), "at least 4 samples");
  test::expect_contains(test::refusal([] { SplineAxis(4, 0, false); }), "must be positive");
}

TEST(SplineAxisEndsTest, WhatIsNoNumberStaysInTheTable) {
  for (const bool periodic : {false, true}) {
    const SplineAxis axis(6, 2, periodic);
    const double piece = axis.at(std::nan("")).piece[0];
    EXPECT_TRUE(piece >= 0 && piece < static_cast<double>(axis.pieces()));
  }
}

}  // namespace
}  // namespace ixos
