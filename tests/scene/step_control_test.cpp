// Steps, cuts and regrowth.
#include "scene/step_control.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace ixos
