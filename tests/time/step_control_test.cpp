// Steps, cuts and regrowth.
#include "time/step_control.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ixos {
namespace {

TEST(StepControlTest, UncutStepsEndAtTheFinalTime) {
  const StepControl control({1.0, 2.05, 0.1, 0, 0});
  double time = 1;
  int steps = 0;
  while (!control.done(time) && steps < 100) {
    time += control.next(time);
    ++steps;
  }
  EXPECT_EQ(steps, 11);
  EXPECT_NEAR(time, 2.05, 1e-12);
}

TEST(StepControlTest, AStepLongerThanTheRunIsCutToIt) {
  const StepControl control({0, 2, 2e8, 0, 0});
  ASSERT_FALSE(control.done(0));
  EXPECT_EQ(control.next(0), 2);
  EXPECT_TRUE(control.done(2));
}

TEST(StepControlTest, NoStepIsLostAtLateTimes) {
  const StepControl control({1e9, 1e9 + 0.003, 0.001, 0, 0});  // times there are 1e-7 apart
  double time = 1e9;
  int steps = 0;
  for (; !control.done(time) && steps < 100; ++steps) time += control.next(time);
  EXPECT_EQ(steps, 3);
}

TEST(StepControlTest, ACutStepIsHalvedGrowsAgainAndHitsTheGrid) {
  StepControl control({0, 10, 1.0, 3, 0});
  double time = 2;
  ASSERT_TRUE(control.cut(control.next(time)));
  EXPECT_EQ(control.next(time), 0.5);
  ASSERT_TRUE(control.cut(control.next(time)));
  EXPECT_EQ(control.next(time), 0.25);
  std::vector<double> times;
  while (time < 5) {
    time += control.next(time);
    control.succeeded();
    times.push_back(time);
  }
  EXPECT_EQ(times, (std::vector<double>{2.25, 2.75, 3.0, 4.0, 5.0}));
}

TEST(StepControlTest, CutsEndWhereTheyMust) {
  StepControl number({0, 10, 1.0, 2, 0});
  EXPECT_TRUE(number.cut(1.0));
  EXPECT_TRUE(number.cut(0.5));
  EXPECT_FALSE(number.cut(0.25));
  StepControl least({0, 10, 1.0, 50, 0.2});
  EXPECT_TRUE(least.cut(1.0));
  EXPECT_TRUE(least.cut(0.5));
  EXPECT_FALSE(least.cut(0.25));
  StepControl none({0, 10, 1.0, 0, 0});
  EXPECT_FALSE(none.cut(1.0));
}

StepControlOptions adaptive(double tolerance, double gap_ratio) {
  StepControlOptions options{0, 10, 0.01, 0, 0};
  options.adaptive.on = true;
  options.adaptive.tolerance = tolerance;
  options.adaptive.gap_ratio = gap_ratio;
  return options;
}

TEST(StepControlTest, AdaptiveStepsSettleWhereTheErrorIsTheTolerance) {
  // error = 5 dt^3, and from t = 5 on a thousand times that: steps 0.0585 and 0.00585 have the tolerance 1e-3.
  StepControl control(adaptive(1e-3, 0));
  double time = 0;
  int rejected = 0;
  std::vector<double> early, late;
  while (!control.done(time)) {
    const double dt = control.next(time);
    const double error = (time < 5 ? 5 : 5000) * dt * dt * dt;
    if (!control.accepts(dt, {error, 1})) {
      ++rejected;
      continue;
    }
    EXPECT_LE(error, 1e-3);
    time += dt;
    (time < 5 ? early : late).push_back(dt);
  }
  EXPECT_NEAR(time, 10, 1e-9);
  EXPECT_LT(rejected, 4);
  EXPECT_GT(early[early.size() / 2], 0.8 * 0.0585);
  EXPECT_GT(late[late.size() / 2], 0.8 * 0.00585);
}

TEST(StepControlTest, TheGapRatioLimitsAStepToo) {
  // A gap that shrinks as exp(-3 t): over dt its ratio is exp(3 dt), 1.5 at dt = 0.135.
  StepControl control(adaptive(0, 1.5));
  double time = 0, longest = 0;
  while (time < 8) {
    const double dt = control.next(time);
    const double ratio = std::exp(3 * dt);
    if (!control.accepts(dt, {0, ratio})) continue;
    EXPECT_LE(ratio, 1.5);
    longest = std::max(longest, dt);
    time += dt;
  }
  EXPECT_GT(longest, 0.85 * 0.135);
  EXPECT_EQ(time_points(1.3), 5);
  EXPECT_EQ(time_points(1.9), 8);
  EXPECT_EQ(time_points(4), 16);
}

TEST(StepControlTest, OutputTimesAreHitAndDoNotSlowTheSteps) {
  StepControlOptions options = adaptive(1e-3, 0);
  options.output_intervals = {0.25, 0.4};
  StepControl control(options);
  double time = 0;
  std::vector<double> times, steps;
  while (!control.done(time)) {
    const double dt = control.next(time);
    ASSERT_GT(dt, 1e-4);
    if (!control.accepts(dt, {5 * dt * dt * dt, 1})) continue;
    times.push_back(time += dt);
    steps.push_back(dt);
  }
  const auto hit = [&](double wanted) {
    return std::any_of(times.begin(), times.end(), [&](double t) { return std::abs(t - wanted) < 1e-9; });
  };
  for (int k = 1; k <= 40; ++k) EXPECT_TRUE(hit(0.25 * k)) << k;
  for (int k = 1; k <= 25; ++k) EXPECT_TRUE(hit(0.4 * k)) << k;
  // The tolerance allows 0.0585: without times to hit, 171 steps.
  EXPECT_LT(times.size(), 320U);
  StepControlOptions fixed{0, 10, 0.1, 0, 0};
  fixed.output_intervals = {0.25};
  const StepControl grid(fixed);
  EXPECT_NEAR(grid.next(0.2), 0.05, 1e-12);
  EXPECT_NEAR(grid.next(0.25), 0.05, 1e-12);
  EXPECT_NEAR(grid.next(0.3), 0.1, 1e-12);
}

TEST(StepControlTest, StableStepsDivideTheWantedOneEvenly) {
  const StepControl control({0, 10, 1.0, 0, 0});
  EXPECT_NEAR(control.next(0, [](double) { return 0.3; }), 0.25, 1e-15);
  EXPECT_EQ(control.next(0, [](double wanted) { return wanted; }), 1.0);
  // However short stable steps are, times are hit.
  StepControlOptions options{0, 3, 1.0, 0, 0};
  options.output_intervals = {0.7};
  const StepControl fine(options);
  double time = 0;
  std::vector<double> hits;
  while (!fine.done(time)) {
    time += fine.next(time, [](double wanted) { return std::min(wanted, 4e-4); });
    for (double wanted : {0.7, 1.0, 1.4, 2.0, 2.1, 2.8, 3.0})
      if (std::abs(time - wanted) < 1e-10) hits.push_back(wanted);
  }
  EXPECT_EQ(hits, (std::vector<double>{0.7, 1.0, 1.4, 2.0, 2.1, 2.8, 3.0}));
}

TEST(StepControlTest, AStepThatWouldBeTooShortIsSaidToBe) {
  StepControlOptions options = adaptive(1e-3, 0);
  options.minimum_step = 0.001;
  StepControl control(options);
  std::string why;
  EXPECT_FALSE(control.exhausted(why));
  EXPECT_FALSE(control.accepts(control.next(0), {1e9, 1}));
  EXPECT_FALSE(control.accepts(control.next(0), {1e9, 1}));
  EXPECT_TRUE(control.exhausted(why));
  EXPECT_NE(why.find("the shortest one allowed is 0.001 T0"), std::string::npos) << why;
}

}  // namespace
}  // namespace ixos
