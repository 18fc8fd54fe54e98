// Eisenstat and Walker's choice 2: eta = 0.9 (|f_k|/|f_k-1|)^2, between 1e-8 and 1e-3.
#include "solve/newton/forcing_term.hpp"

#include <gtest/gtest.h>

namespace ixos {
namespace {

TEST(ForcingTermSerialTest, FollowsTheSquareOfWhatTheLastStepGained) {
  ForcingTerm eta;
  EXPECT_DOUBLE_EQ(eta(0, 1.0, 0), 1e-3);
  EXPECT_DOUBLE_EQ(eta(1, 1e-2, 0), 0.9 * 1e-4);
  EXPECT_DOUBLE_EQ(eta(2, 1e-5, 0), 0.9 * 1e-6);
}

TEST(ForcingTermSerialTest, StaysBetweenItsLimits) {
  ForcingTerm eta;
  eta(0, 1.0, 0);
  EXPECT_DOUBLE_EQ(eta(1, 0.9, 0), 1e-3) << "a step that gained little";
  EXPECT_DOUBLE_EQ(eta(2, 9.0, 0), 1e-3) << "a step that lost";
  EXPECT_DOUBLE_EQ(eta(3, 9e-6, 0), 1e-8) << "a step that gained much";
}

TEST(ForcingTermSerialTest, SolvesNoStepBeyondATenthOfTheBound) {
  ForcingTerm eta;
  eta(0, 1.0, 1e-9);
  EXPECT_DOUBLE_EQ(eta(1, 1e-4, 1e-9), 0.1 * 1e-9 / 1e-4);
  EXPECT_DOUBLE_EQ(eta(2, 1e-8, 1e-9), 1e-3) << "0.1 times 1e-9/1e-8 is beyond the upper limit";
}

TEST(ForcingTermSerialTest, BeginsAnewWithEverySolve) {
  ForcingTerm eta;
  eta(0, 1.0, 0);
  eta(1, 1e-6, 0);
  EXPECT_DOUBLE_EQ(eta(0, 1e-6, 0), 1e-3);
  EXPECT_DOUBLE_EQ(eta(1, 1e-7, 0), 1e-3) << "0.9 times 0.01 is beyond the upper limit";
  EXPECT_DOUBLE_EQ(eta(2, 1e-9, 0), 0.9 * 1e-4);
}

TEST(ForcingTermSerialTest, AVanishingResidualIsNoDivisor) {
  ForcingTerm eta;
  eta(0, 1.0, 0);
  EXPECT_DOUBLE_EQ(eta(1, 0.0, 1e-9), 1e-8);
  EXPECT_DOUBLE_EQ(eta(2, 1.0, 0), 1e-3);
}

}  // namespace
}  // namespace ixos
