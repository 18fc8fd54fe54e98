#include "run/jump_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/snapshot.hpp"

namespace ixos {
namespace {

/// Balance and work of a spring of stiffness 2 that is pulled by steps of 0.1: the trapezoid rule is exact.
void pull(JumpWatch& watch, int from, int to, double lost = 0) {
  for (int row = from; row <= to; ++row) watch.row(row, -lost, 0.01 * row * row);
}

TEST(JumpWatchTest, ABalanceThatStaysHasNoJump) {
  JumpWatch watch;
  pull(watch, 0, 10);
  EXPECT_EQ(watch.largest().released, 0);
}

TEST(JumpWatchTest, ReleasedEnergyIsAJumpIfItIsHalfOfTheWork) {
  JumpWatch watch;
  pull(watch, 0, 4);
  pull(watch, 5, 9, 0.3);  // the work of this row is 0.09
  EXPECT_NEAR(watch.largest().released, 0.3, 1e-15);
  EXPECT_EQ(watch.largest().from, 4);
  EXPECT_EQ(watch.largest().to, 5);
  JumpWatch smooth;
  pull(smooth, 0, 4);
  pull(smooth, 5, 9, 0.04);
  EXPECT_EQ(smooth.largest().released, 0) << "an error of the trapezoid rule";
}

TEST(JumpWatchTest, RowsWithoutEnergiesAndEnergyThatIsGainedAreNone) {
  JumpWatch watch;
  for (int row = 0; row < 5; ++row) watch.row(row, std::nan(""), 0);
  EXPECT_EQ(watch.largest().released, 0);
  JumpWatch gains;
  pull(gains, 0, 4, 0.5);
  pull(gains, 5, 9, 0);
  EXPECT_EQ(gains.largest().released, 0);
}

TEST(JumpWatchTest, ARestoredOneGoesOn) {
  JumpWatch watch;
  pull(watch, 0, 4);
  Snapshot snapshot([&](Record& record) { watch.transfer(record); });
  snapshot.save();
  for (int round = 0; round < 2; ++round) {
    pull(watch, 5, 6, 0.3);
    EXPECT_NEAR(watch.largest().released, 0.3, 1e-15) << "no jump back from the row after the snapshot";
    EXPECT_EQ(watch.largest().from, 4);
    snapshot.restore();
    EXPECT_EQ(watch.largest().released, 0);
  }
}

}  // namespace
}  // namespace ixos
