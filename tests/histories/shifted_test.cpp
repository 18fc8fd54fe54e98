#include "histories/shifted.hpp"

#include <gtest/gtest.h>

namespace ixos {
namespace {

TEST(ShiftedTest, ValuesAndTimesMove) {
  const auto own = sine(0.5, 2, 0.25, 0.3);
  const auto moved = shifted(own, 3, -7);
  for (const double t : {-1.0, 0.0, 2.5, 10.0}) {
    EXPECT_DOUBLE_EQ(moved->at(t + 3).value, own->at(t).value - 7);
    EXPECT_DOUBLE_EQ(moved->at(t + 3).rate, own->at(t).rate);
    EXPECT_DOUBLE_EQ(moved->at(t + 3).acceleration, own->at(t).acceleration);
  }
}

TEST(ShiftedTest, SpansRampsAndJumpsMove) {
  const auto table = shifted(interpolated({1, 2, 4}, {0, 1, 3}, TableInterpolation::Step), 10, 1);
  EXPECT_EQ(table->first_time(), 11);
  EXPECT_EQ(table->last_time(), 14);
  EXPECT_EQ(shifted(value_ramp(1, 2, 3, RampShape::Linear), 10, 1)->ramp_end(), 15);
  const std::vector<double> before = interpolated({1, 2, 4}, {0, 1, 3}, TableInterpolation::Step)->jumps().times;
  const std::vector<double> after = table->jumps().times;
  ASSERT_EQ(after.size(), before.size());
  ASSERT_FALSE(after.empty());
  for (std::size_t k = 0; k < after.size(); ++k) EXPECT_EQ(after[k], before[k] + 10);
}

}  // namespace
}  // namespace ixos
