#include "run/front_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ixos {
namespace {

constexpr double pi = 3.14159265358979;

/// A strip that peels by `way` in a step, a row every `interval` steps, from a contact of 1000.
FrontSteps peeled(double zone, double way, long interval) {
  FrontWatch watch(zone, 2);
  for (long row = 0; row <= 20; ++row) watch.row(row * interval, 1000 - way * static_cast<double>(row * interval));
  return watch.front();
}

TEST(FrontWatchTest, TheWayInAStepIsComparedWithTheZone) {
  for (long interval : {1L, 4L}) {
    const FrontSteps fast = peeled(4, 5, interval), slow = peeled(4, 3, interval);
    EXPECT_EQ(fast.moving, 20);
    EXPECT_EQ(fast.fast, 20);
    EXPECT_NEAR(fast.way, 5, 1e-12);
    EXPECT_EQ(slow.moving, 20);
    EXPECT_EQ(slow.fast, 0);
  }
  EXPECT_EQ(peeled(4, 0.01, 1).moving, 0);
  EXPECT_EQ(peeled(0, 5, 1).moving, 0);
}

// The radius of a disk grows by 2 in a step: pi (a^2 - (a - 2)^2)/(2 pi a) = 2 - 2/a.
TEST(FrontWatchTest, InSpaceTheRimOfADiskMoves) {
  FrontWatch watch(1, 3);
  double way = 0;
  for (int row = 1; row <= 20; ++row) {
    const double radius = 100 + 2 * row;
    watch.row(row, pi * radius * radius);
    if (row > 1) way += (2 - 2 / radius) / 19;
  }
  EXPECT_EQ(watch.front().fast, 19);
  EXPECT_NEAR(watch.front().way, way, 1e-12);
}

TEST(FrontWatchTest, BodiesThatJumpAsAWholeHaveNoFront) {
  FrontWatch watch(1, 2);
  for (int row = 0; row < 40; ++row) watch.row(row, row % 2 == 0 ? 100.0 : 0.0);
  for (int row = 40; row < 80; ++row) watch.row(row, row % 2 == 0 ? 100.0 : 40.0);
  watch.row(80, std::nan(""));
  EXPECT_EQ(watch.front().moving, 0);
}

}  // namespace
}  // namespace ixos
