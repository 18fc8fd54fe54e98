// Tables over time, with each interpolation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <vector>

#include "histories/time_function.hpp"
#include "support/refusal.hpp"
#include "support/time_functions.hpp"

namespace ixos {
namespace {

using test::expect_contains;
using test::expect_continuous;
using test::expect_derivatives;
using test::expect_value;
using test::refusal;
using Function = std::shared_ptr<const TimeFunction>;
using Interpolation = TableInterpolation;
using Numbers = std::vector<double>;

const Numbers uneven = {-1, 0, 0.3, 2, 2.5, 4};
const std::vector<Interpolation> all = {Interpolation::Monotone, Interpolation::Unlimited, Interpolation::Linear,
                                        Interpolation::Step};

/// Times at very different distances, and values that rise, fall and rest.
struct RandomTable {
  explicit RandomTable(unsigned seed) {
    std::mt19937 random(seed);
    const auto number = [&random] { return std::uniform_real_distribution<double>(-1, 1)(random); };
    const double spread = seed % 2 == 0 ? 0.1 : 3;
    times = {number()};
    values = {number()};
    for (unsigned i = 1; i < 2 + seed % 7; ++i) {
      times.push_back(times.back() + std::pow(10, spread * number()));
      values.push_back(values.back() + (number() > 0.5 ? 0 : number() * std::pow(10, spread * number())));
    }
  }
  double size() const {
    double largest = 0;
    for (double value : values) largest = std::max(largest, std::abs(value));
    return largest;
  }
  Numbers times, values;
};

/// Calls visit(time, interval) at 41 times of each interval, its ends among them.
void for_times(const Numbers& times, const std::function<void(double, std::size_t)>& visit) {
  for (std::size_t i = 0; i + 1 < times.size(); ++i)
    for (int k = 0; k <= 40; ++k) visit(std::min(times[i] + k * (times[i + 1] - times[i]) / 40, times[i + 1]), i);
}

Numbers mapped(const Numbers& x, double factor, bool reversed = false) {
  Numbers result;
  for (double value : x) result.push_back(factor * value);
  if (reversed) std::reverse(result.begin(), result.end());
  return result;
}

TEST(TimeTableSerialTest, RestsAndHoldsExactly) {
  const Function f = interpolated({0, 1, 1.1, 4}, {0, 0, -0.01, -0.01});
  for (double t : {0.0, 0.3, 0.77, 0.999}) expect_value(*f, t, 0, 0, 0);
  for (double t : {1.0, 1.02, 1.05, 1.09, 1.1}) {
    const double x = (t - 1) / 0.1;
    EXPECT_NEAR(f->at(t).value, -0.01 * x * x * x * (10 - 15 * x + 6 * x * x), 1e-15);
  }
  for (double t : {1.11, 2.0, 3.7, 4.0}) {
    EXPECT_EQ(f->at(t).value, -0.01);
    EXPECT_EQ(f->at(t).rate, 0);
    EXPECT_EQ(f->at(t).acceleration, 0);
  }
}

TEST(TimeTableSerialTest, NoValueLeavesTheRangeOfItsNeighbours) {
  for (unsigned seed = 0; seed < 400; ++seed) {
    const RandomTable table(seed);
    const Function f = interpolated(table.times, table.values);
    const double roundoff = 1e-13 * table.size();
    for_times(table.times, [&](double t, std::size_t i) {
      const double a = table.values[i], b = table.values[i + 1], value = f->at(t).value;
      ASSERT_GE(value, std::min(a, b) - roundoff) << "table " << seed << ", t = " << t;
      ASSERT_LE(value, std::max(a, b) + roundoff) << "table " << seed << ", t = " << t;
    });
  }
}

TEST(TimeTableSerialTest, SplinesPassThroughTheirPointsAndAreTwiceContinuouslyDifferentiable) {
  for (const Interpolation interpolation : {Interpolation::Monotone, Interpolation::Unlimited})
    for (unsigned seed = 0; seed < 60; seed += 2) {
      const RandomTable table(seed);
      const Function f = interpolated(table.times, table.values, interpolation);
      EXPECT_EQ(f->first_time(), table.times.front());
      EXPECT_EQ(f->last_time(), table.times.back());
      EXPECT_TRUE(f->jumps().times.empty());
      for (std::size_t i = 0; i < table.times.size(); ++i) {
        const TimeValue here = f->at(table.times[i]);
        EXPECT_NEAR(here.value, table.values[i], 1e-12);
        if (i == 0) continue;
        const TimeValue before = f->at(std::nextafter(table.times[i], table.times[0]));
        EXPECT_NEAR(before.value, here.value, 1e-12);
        EXPECT_NEAR(before.rate, here.rate, 1e-11);
        EXPECT_NEAR(before.acceleration, here.acceleration, 1e-10);
      }
      EXPECT_EQ(refusal([&] { check_over(*f, f->first_time(), f->last_time(), true); }), "");
    }
}

TEST(TimeTableSerialTest, UnlimitedHasTheDerivativesOfParabolas) {
  const Numbers values = {1, -2, 0.5, 3, 3, -1};
  const Function f = interpolated(uneven, values, Interpolation::Unlimited);
  EXPECT_EQ(f->ramp_end(), -std::numeric_limits<double>::infinity());
  for (std::size_t i = 1; i + 1 < uneven.size(); ++i) {
    expect_continuous(*f, uneven[i], true);
    // Of the parabola through the three points: its mean slopes on both sides, and how they change.
    const double h0 = uneven[i] - uneven[i - 1], h1 = uneven[i + 1] - uneven[i];
    const double d0 = (values[i] - values[i - 1]) / h0, d1 = (values[i + 1] - values[i]) / h1;
    EXPECT_NEAR(f->at(uneven[i]).rate, (d0 * h1 + d1 * h0) / (h0 + h1), 1e-12);
    EXPECT_NEAR(f->at(uneven[i]).acceleration, 2 * (d1 - d0) / (h0 + h1), 1e-11);
  }
}

TEST(TimeTableSerialTest, DerivativesAreThoseOfTheValue) {
  for (const Interpolation interpolation : all)
    expect_derivatives(*interpolated({0, 1, 2, 4}, {0, 1, -1, 0.5}, interpolation), {0.2, 0.9, 1.5, 3.1});
}

TEST(TimeTableSerialTest, UnlimitedIsExactForAParabola) {
  Numbers values;
  for (double t : uneven) values.push_back(2 - 3 * t + 0.5 * t * t);
  const Function f = interpolated(uneven, values, Interpolation::Unlimited);
  for (double t : {-1.0, -0.4, 0.0, 0.1, 1.3, 2.0, 2.2, 3.9, 4.0}) {
    EXPECT_NEAR(f->at(t).value, 2 - 3 * t + 0.5 * t * t, 1e-13);
    EXPECT_NEAR(f->at(t).rate, -3 + t, 1e-12);
    EXPECT_NEAR(f->at(t).acceleration, 1, 1e-11);
  }
}

TEST(TimeTableSerialTest, TwoPointsMakeALine) {
  for (const Interpolation interpolation : {Interpolation::Monotone, Interpolation::Unlimited, Interpolation::Linear}) {
    const Function f = interpolated({1, 3}, {2, 8}, interpolation);
    for (double t : {1.0, 1.5, 3.0}) expect_value(*f, t, 2 + 3 * (t - 1), 3, 0);
    EXPECT_TRUE(f->jumps().times.empty());
  }
}

/// Returns the largest error of a table of f at n + 1 times of [-1, 1], uneven ones.
double error(const std::function<double(double)>& f, int n, Interpolation interpolation) {
  Numbers times, values;
  for (int k = 0; k <= n; ++k) {
    const double x = -1 + 2.0 * k / n;
    times.push_back(x + 0.3 / M_PI * std::sin(M_PI * x));
    values.push_back(f(times.back()));
  }
  const Function table = interpolated(times, values, interpolation);
  double largest = 0;
  for_times(times, [&](double t, std::size_t) { largest = std::max(largest, std::abs(table->at(t).value - f(t))); });
  return largest;
}

TEST(TimeTableSerialTest, SmoothMonotoneDataNeedNoLimitAndConvergeWithThirdOrder) {
  const std::vector<std::function<double(double)>> functions = {[](double t) { return std::exp(t); },
                                                                [](double t) { return -std::tanh(2 * t) - 0.3 * t; }};
  for (const auto& f : functions) {
    for (int n : {40, 80}) EXPECT_EQ(error(f, n, Interpolation::Monotone), error(f, n, Interpolation::Unlimited));
    EXPECT_GT(error(f, 80, Interpolation::Monotone) / error(f, 160, Interpolation::Monotone), 7);
  }
}

TEST(TimeTableSerialTest, AtExtremaTheErrorIsOfSecondOrder) {
  // A knot within 2 h of an extremum has a value within 2 (omega h)^2 of it.
  const double omega = 2 * M_PI;
  for (double phase : {0.0, 0.3, 1.1})
    for (int n : {32, 64, 128, 256}) {
      const double h = 1.3 * 2 / n;
      EXPECT_LT(error([&](double t) { return std::sin(omega * t + phase); }, n, Interpolation::Monotone),
                2 * omega * omega * h * h);
    }
}

TEST(TimeTableSerialTest, TheCurveFollowsItsTableBackwardsBelowAndEnlarged) {
  for (const Interpolation interpolation : {Interpolation::Monotone, Interpolation::Unlimited})
    for (unsigned seed = 0; seed < 100; ++seed) {
      const RandomTable table(seed);
      const Function f = interpolated(table.times, table.values, interpolation);
      const Function back = interpolated(mapped(table.times, -1, true), mapped(table.values, 1, true), interpolation);
      const Function below = interpolated(table.times, mapped(table.values, -1), interpolation);
      // Powers of two change no rounding.
      const Function large = interpolated(mapped(table.times, 8), mapped(table.values, 0.25), interpolation);
      double size = table.size();
      for_times(table.times, [&](double t, std::size_t) { size = std::max(size, std::abs(f->at(t).value)); });
      for_times(table.times, [&](double t, std::size_t) {
        const double value = f->at(t).value;
        ASSERT_NEAR(back->at(-t).value, value, 1e-10 * size) << "table " << seed;
        ASSERT_EQ(below->at(t).value, -value) << "table " << seed;
        ASSERT_EQ(large->at(8 * t).value, 0.25 * value) << "table " << seed;
      });
    }
}

TEST(TimeTableSerialTest, LinearFollowsStraightLines) {
  const Function f = interpolated({0, 1, 3, 4, 5}, {2, 5, 5, 3, 1}, Interpolation::Linear);
  expect_value(*f, 0, 2, 3, 0);
  expect_value(*f, 0.25, 2.75, 3, 0);
  expect_value(*f, 1, 5, 0, 0);
  EXPECT_EQ(f->at(2.3).value, 5);
  expect_value(*f, 3.5, 4, -2, 0);
  expect_value(*f, 5, 1, -2, 0);
  EXPECT_EQ(f->jumps().times, (Numbers{1, 3})) << "no jump at 4, which is on a line";
  EXPECT_FALSE(f->jumps().of_value);
  Numbers tenths, values;
  for (int k = 0; k <= 10; ++k) {
    tenths.push_back(0.1 * k);
    values.push_back(0.7 * tenths.back());
  }
  EXPECT_TRUE(interpolated(tenths, values, Interpolation::Linear)->jumps().times.empty());
}

TEST(TimeTableSerialTest, StepHoldsEachValueUntilTheNextTime) {
  const Function f = interpolated({0, 1, 3, 4}, {2, 5, 5, 3}, Interpolation::Step);
  for (double t : {0.0, 0.5, 0.999}) expect_value(*f, t, 2, 0, 0);
  for (double t : {1.0, 2.0, 3.0, 3.999}) expect_value(*f, t, 5, 0, 0);
  expect_value(*f, 4, 3, 0, 0);
  EXPECT_EQ(f->jumps().times, (Numbers{1, 4}));
  EXPECT_TRUE(f->jumps().of_value);
  // A sum of steps misses the time 1 by roundoff.
  double sum = 0;
  for (int k = 0; k < 10; ++k) sum += 0.1;
  ASSERT_LT(sum, 1);
  EXPECT_EQ(f->at(sum).value, 5);
  // Times nearer than the slack stay apart.
  const Function close = interpolated({0, 1e-12, 1}, {1, 2, 3}, Interpolation::Step);
  EXPECT_EQ(close->at(0).value, 1);
  EXPECT_EQ(close->at(1e-12).value, 2);
}

TEST(TimeTableSerialTest, LinearAndStepDriveStaticMotionsOnly) {
  const auto message = [](Interpolation interpolation, double from, double to) {
    const Function f = interpolated({0, 1, 2, 3, 4, 5, 6, 7, 8}, {0, 0, 1, 0, 1, 0, 1, 0, 2}, interpolation);
    EXPECT_EQ(refusal([&] { check_over(*f, from, to, false); }), "");
    EXPECT_EQ(refusal([&] { check_static_over(*f, from, to); }), "");
    return refusal([&] { check_over(*f, from, to, true); });
  };
  EXPECT_EQ(message(Interpolation::Monotone, 0, 8), "");
  EXPECT_EQ(message(Interpolation::Unlimited, 0, 8), "");
  EXPECT_EQ(message(Interpolation::Linear, 0, 2.5),
            "Interpolation Linear cannot drive a motion of a dynamic scheme: its rate jumps at the times 1, 2, where "
            "its acceleration is not defined; choose Interpolation Monotone, or the scheme Static");
  expect_contains(message(Interpolation::Linear, 0, 8), "at the times 1, 2, 3, 4, 5 and 2 more, where");
  expect_contains(message(Interpolation::Step, 1, 2),
                  "Interpolation Step cannot drive a motion of a dynamic scheme: its value jumps at the time 2, where "
                  "its rate is not defined");
  // Nothing jumps between two times.
  EXPECT_EQ(message(Interpolation::Linear, 1, 1.9), "");
  EXPECT_EQ(message(Interpolation::Step, 2, 2.9), "");
}

TEST(TimeTableSerialTest, IsNotANumberOutside) {
  for (const Interpolation interpolation : all) {
    const Function f = interpolated({0, 1, 3}, {1, 2, 5}, interpolation);
    for (double time : {-1e-6, 3 + 1e-6, 1e300, static_cast<double>(NAN)}) {
      EXPECT_TRUE(std::isnan(f->at(time).value));
      EXPECT_TRUE(std::isnan(f->at(time).rate));
      EXPECT_TRUE(std::isnan(f->at(time).acceleration));
    }
    // Roundoff in a run's last time is not outside.
    EXPECT_NEAR(f->at(std::nextafter(3.0, 4.0)).value, 5, 1e-13);
    EXPECT_NEAR(f->at(std::nextafter(0.0, -1.0)).value, 1, 1e-13);
  }
}

TEST(TimeTableSerialTest, BadTablesAreRefused) {
  for (const Interpolation interpolation : all) {
    const auto message = [interpolation](const Numbers& times, const Numbers& values) {
      return refusal([&] { interpolated(times, values, interpolation); });
    };
    expect_contains(message({}, {}), "0 times");
    expect_contains(message({1}, {1}), "at least 2");
    expect_contains(message({0, 1, 2}, {1, 2}), "3 times and 2 values");
    expect_contains(message({0, 1, 1}, {1, 2, 3}), "increase, but 1 follows 1");
    expect_contains(message({0, 2, 1}, {1, 2, 3}), "entry 3");
    expect_contains(message({0, NAN, 2}, {1, 2, 3}), "finite");
    expect_contains(message({0, 1, INFINITY}, {1, 2, 3}), "finite");
    expect_contains(message({0, 1, 2}, {1, NAN, 3}), "entry 2");
  }
}

}  // namespace
}  // namespace ixos
