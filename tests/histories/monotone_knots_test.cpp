// The limiter, on knots with any rates and accelerations.
#include "histories/monotone_knots.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>

#include "histories/quintic.hpp"

namespace ixos {
namespace {

using Knots = std::vector<TimeValue>;

Knots limited(const std::vector<double>& times, Knots knots) {
  make_monotone(times, knots);
  return knots;
}

void expect_knot(const TimeValue& knot, double rate, double acceleration) {
  EXPECT_NEAR(knot.rate, rate, 1e-14);
  EXPECT_NEAR(knot.acceleration, acceleration, 1e-13);
}

/// Knots at uneven times, some of equal values, with derivatives of all sizes that have nothing to do with the values.
Knots any_knots(std::mt19937& random, std::vector<double>& times) {
  const auto number = [&random] { return std::uniform_real_distribution<double>(-1, 1)(random); };
  times = {0};
  Knots knots;
  for (std::size_t i = 0; i < 8; ++i) {
    const double size = std::pow(10, 3 * number());
    knots.push_back({std::round(2 * number()) * std::abs(number()), size * number(), size * size * number()});
    if (i > 0) times.push_back(times.back() + std::pow(10, 2 * number()));
    if (i > 0 && number() > 0.5) knots[i].value = knots[i - 1].value;
  }
  return knots;
}

TEST(MonotoneKnotsSerialTest, IntervalsAreMonotoneWhateverTheDerivativesWere) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<double> times;
    const Knots before = any_knots(random, times), knots = limited(times, before);
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      const double length = times[i + 1] - times[i], slope = (knots[i + 1].value - knots[i].value) / length;
      ASSERT_EQ(knots[i].value, before[i].value);
      for (int k = 0; k <= 50; ++k) {
        const TimeValue at = quintic(knots[i], knots[i + 1], length, k * length / 50);
        ASSERT_GE(slope > 0 ? at.rate : -at.rate, -1e-11 * std::abs(slope)) << "trial " << trial << ", interval " << i;
        if (slope == 0) {
          ASSERT_EQ(at.value, knots[i].value);
          ASSERT_EQ(at.acceleration, 0);
        }
      }
    }
  }
}

TEST(MonotoneKnotsSerialTest, LimitedKnotsAreLimitedNoFurther) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<double> times;
    const Knots once = limited(times, any_knots(random, times));
    const Knots twice = limited(times, once);
    for (std::size_t i = 0; i < once.size(); ++i) {
      ASSERT_NEAR(twice[i].rate, once[i].rate, 1e-12 * std::abs(once[i].rate));
      // The total that rates leave to accelerations is a difference of numbers of the size of slopes over lengths.
      double size = 0;
      for (const std::size_t k : {std::max<std::size_t>(i, 1) - 1, std::min(i, once.size() - 2)}) {
        const double length = times[k + 1] - times[k];
        size = std::max(size, std::abs(once[k + 1].value - once[k].value) / (length * length));
      }
      ASSERT_NEAR(twice[i].acceleration, once[i].acceleration, 1e-12 * size);
    }
  }
}

TEST(MonotoneKnotsSerialTest, MonotoneParabolasStayAsTheyAre) {
  const std::vector<double> times{0, 1, 3, 3.5, 20};
  for (const double sign : {1.0, -1.0})
    for (const double start : {0.0, 0.3}) {
      Knots knots;
      for (double t : times) knots.push_back({sign * (start + t) * (start + t), sign * 2 * (start + t), sign * 2});
      const Knots same = limited(times, knots);
      for (std::size_t i = 0; i < times.size(); ++i) {
        EXPECT_EQ(same[i].rate, knots[i].rate);
        EXPECT_EQ(same[i].acceleration, knots[i].acceleration);
      }
    }
}

TEST(MonotoneKnotsSerialTest, EndsShareWhatAnIntervalAllows) {
  const std::vector<double> times{0, 2};
  // h (d0 + d1) <= 5/2 D: with h = 2 and D = 4, the rates have 5 together.
  Knots knots = limited(times, {{0, 9, 0}, {4, 8, 0}});
  expect_knot(knots[0], 2.5, 0);
  expect_knot(knots[1], 2.5, 0);
  knots = limited(times, {{0, 9, 0}, {4, 1, 0}});
  expect_knot(knots[0], 4, 0);
  expect_knot(knots[1], 1, 0);
  knots = limited(times, {{0, -9, 0}, {4, 3, 0}});
  expect_knot(knots[0], 0, 0);
  expect_knot(knots[1], 3, 0);
  // h^2 (s0 - s1) <= 20 D - 8 h (d0 + d1) = 48 if d0 = 2 and d1 = 0.
  knots = limited(times, {{0, 2, 30}, {4, 0, -30}});
  expect_knot(knots[0], 2, 6);
  expect_knot(knots[1], 0, -6);
  knots = limited(times, {{0, 2, 30}, {4, 0, -2}});
  expect_knot(knots[0], 2, 10);
  expect_knot(knots[1], 0, -2);
  // s0 >= -4 d0/h and s1 <= 4 d1/h.
  knots = limited(times, {{0, 2, -30}, {4, 0.5, 30}});
  expect_knot(knots[0], 2, -4);
  expect_knot(knots[1], 0.5, 1);
}

TEST(MonotoneKnotsSerialTest, AnExtremumHasNoRateButACurvature) {
  const Knots knots = limited({0, 1, 3}, {{0, 1, -2}, {1, 0.3, -2}, {-3, -4, -2}});
  expect_knot(knots[1], 0, -2);
  const Knots wrong = limited({0, 1, 3}, {{0, 1, 0}, {1, 0.3, 2}, {-3, -4, 0}});
  expect_knot(wrong[1], 0, 0);
}

}  // namespace
}  // namespace ixos
