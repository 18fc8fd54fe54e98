#include "run/jump_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/snapshot.hpp"

namespace ixos {
namespace {

/// Balance and work of a spring of stiffness 2 that is pulled by steps of 0.1: the trapezoid rule is exact.
void pull(JumpWatch& watch, int from, int to, double lost = 0) {
  for (int row = from; row <= to; ++row) watch.row(row, -lost, 0.01 * row * row, 1);
}

TEST(JumpWatchTest, ABalanceThatStaysHasNoJump) {
  JumpWatch watch;
  pull(watch, 0, 10);
  EXPECT_EQ(watch.jumps().largest.released, 0);
}

TEST(JumpWatchTest, ReleasedEnergyIsAJumpIfItIsHalfOfTheWork) {
  JumpWatch watch;
  pull(watch, 0, 4);
  pull(watch, 5, 9, 0.3);  // the work of this row is 0.09
  EXPECT_NEAR(watch.jumps().largest.released, 0.3, 1e-15);
  EXPECT_EQ(watch.jumps().largest.from, 4);
  EXPECT_EQ(watch.jumps().largest.to, 5);
  JumpWatch smooth;
  pull(smooth, 0, 4);
  pull(smooth, 5, 9, 0.04);
  EXPECT_EQ(smooth.jumps().largest.released, 0) << "an error of the trapezoid rule";
}

TEST(JumpWatchTest, CountsAllJumpsAndSumsWhatTheyRelease) {
  JumpWatch watch;
  pull(watch, 0, 4);
  EXPECT_NEAR(watch.row(5, -0.3, 0.25, 1).released, 0.3, 1e-15);
  EXPECT_EQ(watch.row(6, -0.3, 0.36, 1).released, 0);
  EXPECT_NEAR(watch.row(7, -0.5, 0.49, 1).released, 0.2, 1e-15);
  watch.row(8, -0.5005, 0.49, 1);  // less than a thousandth of the largest energy
  EXPECT_EQ(watch.jumps().count, 2);
  EXPECT_NEAR(watch.jumps().released, 0.5, 1e-15);
  EXPECT_EQ(watch.jumps().largest.to, 5);
  JumpWatch other;
  pull(other, 0, 4);
  other.go_on_from(watch.jumps());
  EXPECT_EQ(other.jumps().count, 2);
  EXPECT_EQ(other.row(5, 0, 0.25, 1).released, 0);
}

TEST(JumpWatchTest, RowsWithoutEnergiesAndEnergyThatIsGainedAreNone) {
  JumpWatch watch;
  for (int row = 0; row < 5; ++row) watch.row(row, std::nan(""), 0, std::nan(""));
  EXPECT_EQ(watch.jumps().largest.released, 0);
  JumpWatch gains;
  pull(gains, 0, 4, 0.5);
  pull(gains, 5, 9, 0);
  EXPECT_EQ(gains.jumps().largest.released, 0);
}

TEST(JumpWatchTest, ARestoredOneGoesOn) {
  JumpWatch watch;
  pull(watch, 0, 4);
  Snapshot snapshot([&](Record& record) { watch.transfer(record); });
  snapshot.save();
  for (int round = 0; round < 2; ++round) {
    pull(watch, 5, 6, 0.3);
    EXPECT_NEAR(watch.jumps().largest.released, 0.3, 1e-15) << "no jump back from the row after the snapshot";
    EXPECT_EQ(watch.jumps().largest.from, 4);
    EXPECT_EQ(watch.jumps().count, 1);
    snapshot.restore();
    EXPECT_EQ(watch.jumps().count, 0);
    EXPECT_EQ(watch.jumps().largest.released, 0);
  }
}

}  // namespace
}  // namespace ixos
