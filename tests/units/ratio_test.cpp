#include "units/ratio.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.hpp"

namespace ixos {
namespace {

TEST(RatioTest, QuotientsAreRoundedOnce) {
  // Division of doubles is rounded correctly, and all of these integers are doubles.
  for (const std::uint64_t n : {1U, 2U, 3U, 7U, 10U, 49U, 1000U, 123456789U})
    for (const std::uint64_t d : {1U, 3U, 7U, 9U, 11U, 180U, 3600U, 987654321U})
      EXPECT_EQ((Ratio(n) / Ratio(d)).nearest(), double(n) / double(d)) << n << "/" << d;
}

TEST(RatioTest, PowersOfTenAreThoseOfTheCompiler) {
  EXPECT_EQ(Ratio(1, -9).nearest(), 1e-9);
  EXPECT_EQ(Ratio(1602176634, -28).nearest(), 1.602176634e-19);
  EXPECT_EQ((Ratio(7254709287789268, -24) / Ratio(1, -9)).nearest(), 7.254709287789268);
  EXPECT_EQ(Ratio(1, 22).power(-1).nearest(), 1e-22);
  EXPECT_EQ(Ratio(3, -7).power(4).nearest(), 81e-28);
  EXPECT_EQ(Ratio(0).nearest(), 0);
  EXPECT_EQ((Ratio(0, 5) * Ratio(3) / Ratio(7)).nearest(), 0);
}

TEST(RatioTest, NumbersHalfWayBetweenTwoDoublesAreRoundedToTheEvenOne) {
  const std::uint64_t big = (1ULL << 54U) + 2;  // half-way between 2^54 and 2^54 + 4
  EXPECT_EQ(Ratio(big).nearest(), 18014398509481984.0);
  EXPECT_EQ((Ratio(3 * big + 1) / Ratio(3)).nearest(), 18014398509481988.0);
  EXPECT_EQ((Ratio(3 * big - 1) / Ratio(3)).nearest(), 18014398509481984.0);
}

TEST(RatioTest, PiCancels) {
  const Ratio degree = Ratio::pi() / Ratio(180);
  EXPECT_EQ((Ratio(45) * degree / degree).nearest(), 45);
  EXPECT_NEAR((Ratio(45) * degree).nearest(), M_PI / 4, 2 * std::numeric_limits<double>::epsilon());
}

TEST(RatioTest, WhatNoDoubleHoldsIsRefused) {
  EXPECT_THROW(Ratio(1, 309).nearest(), InputError);
  EXPECT_THROW(Ratio(1, -308).nearest(), InputError) << "not normal";
  EXPECT_NO_THROW(Ratio(1, 308).nearest());
  const Ratio long_one(18446744073709551557U);  // a prime
  EXPECT_THROW(long_one * long_one * long_one, InputError);
}

}  // namespace
}  // namespace ixos
