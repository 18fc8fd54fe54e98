// Columns of two models: numbers that agree by coincidence, jumps that come later, noise on a plateau.
#include "study/common/column_history.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace ixos {
namespace {

/// Returns the column of a function, with rows at 0, dt, ..., end.
ColumnHistory column(double dt, double end, double decided, const std::function<double(double)>& value) {
  ColumnHistory result;
  for (int n = 0; n * dt <= end * (1 + 1e-12); ++n) {
    result.times.push_back(n * dt);
    result.values.push_back(value(n * dt));
  }
  result.decided = decided;
  return result;
}

double ramp(double t) { return t; }

TEST(ColumnHistoryTest, OneTimeAtWhichTwoColumnsAgreeIsNoAgreement) {
  // Equal at 10, and 2 of 10 apart at 5.
  const auto bent = [](double t) { return t + 0.08 * t * (10 - t); };
  const ColumnHistory own = column(0.5, 10, 10, ramp), other = column(0.5, 10, 10, bent);
  ASSERT_EQ(own.values.back(), other.values.back());
  EXPECT_NEAR(column_difference(own, other), 0.2, 1e-14);
  EXPECT_EQ(column_difference(own, own), 0);
}

TEST(ColumnHistoryTest, WhatFollowsTheDecidingTimeDoesNotCount) {
  const auto late = [](double t) { return t <= 6 ? t : 50; };
  EXPECT_EQ(column_difference(column(0.5, 10, 6, ramp), column(0.5, 10, 6, late)), 0);
  EXPECT_EQ(column_difference(column(0.5, 10, 6, ramp), column(0.5, 7, 6, ramp)), 0) << "a run that failed at 7";
  EXPECT_GT(column_difference(column(0.5, 10, 7, ramp), column(0.5, 10, 7, late)), 1);
}

// The scale is the largest value of the own column up to the deciding time.
TEST(ColumnHistoryTest, DifferencesCountBesideTheLargestValue) {
  const auto shifted = [](double t) { return t + 0.1; };
  EXPECT_NEAR(column_difference(column(0.5, 10, 4, ramp), column(0.5, 10, 4, shifted)), 0.025, 1e-14);
  const ColumnHistory large = scaled(column(0.5, 10, 4, ramp), 1e6);
  EXPECT_NEAR(column_difference(large, scaled(column(0.5, 10, 4, shifted), 1e6)), 0.025, 1e-14);
}

TEST(ColumnHistoryTest, RowsAtOtherTimesAreInterpolated) {
  EXPECT_NEAR(column_difference(column(0.5, 10, 10, ramp), column(0.03125, 10, 10, ramp)), 0, 1e-14);
  EXPECT_NEAR(column_difference(column(0.03125, 10, 10, ramp), column(0.5, 10, 10, ramp)), 0, 1e-14);
}

// The force snaps to 0 after its peak, a twentieth later with the other model.
TEST(ColumnHistoryTest, AJumpThatComesALittleLaterCountsAsItsShift) {
  const auto snap = [](double at) { return [at](double t) { return t <= at ? std::min(t, 4.0) : 0.0; }; };
  const ColumnHistory own = column(0.125, 10, 4.75, snap(4.75)), other = column(0.125, 10, 5, snap(5));
  EXPECT_NEAR(column_difference(own, other), 0.05, 1e-12);
  EXPECT_NEAR(column_difference(other, own), 0.05, 1e-12);
  EXPECT_NEAR(column_difference(own, column(0.125, 10, 9.5, snap(9.5))), 0.5, 1e-12) << "twice as late";
}

TEST(ColumnHistoryTest, ThePeakOfAPlateauMayBeAnywhere) {
  const ColumnHistory own = column(0.5, 10, 2, [](double t) { return t == 2 ? 1.001 : 1; });
  const ColumnHistory other = column(0.5, 10, 9, [](double t) { return t == 9 ? 1.001 : 1; });
  EXPECT_NEAR(column_difference(own, other), 0.001 / 1.001, 1e-12);
}

TEST(ColumnHistoryTest, WhatCannotBeComparedIsUnknown) {
  const ColumnHistory own = column(0.5, 10, 10, ramp);
  EXPECT_TRUE(std::isinf(column_difference(own, column(0.5, 6, 10, ramp)))) << "ends before";
  EXPECT_TRUE(std::isinf(column_difference(own, {})));
  EXPECT_TRUE(std::isinf(column_difference({}, own)));
  const auto zero = [](double) { return 0.0; };
  EXPECT_TRUE(std::isinf(column_difference(column(0.5, 10, 10, zero), own)));
  EXPECT_EQ(column_difference(column(0.5, 10, 10, zero), column(0.5, 10, 10, zero)), 0);
  ColumnHistory broken = own;
  broken.values[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isinf(column_difference(own, broken)));
}

}  // namespace
}  // namespace ixos
