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

TEST(RatioTest, FactorsOfManyDigitsAreRoundedOnce) {
  // Expected values: fractions.Fraction of Python, whose float() is rounded correctly.
  const Ratio prime(18446744073709551557U), length(7254709287789268, -24), stress(2345678, 3);
  EXPECT_EQ((stress * length.power(3)).nearest(), 8.9562959646971e-16);
  EXPECT_EQ((stress * length.power(3) * Ratio(123456789, -17)).nearest(), 1.1057155411351613e-24);
  EXPECT_EQ((Ratio(1) / length.power(9)).nearest(), 1.7964696070535528e+73);
  EXPECT_EQ((prime.power(9) * Ratio(1, -150) / Ratio(7).power(3)).nearest(), 7.210798876766896e+20);
  EXPECT_EQ((prime * stress / prime).nearest(), 2345678000);
}

TEST(RatioTest, WhatNoDoubleHoldsIsRefused) {
  EXPECT_THROW(Ratio(1, 309).nearest(), InputError);
  EXPECT_THROW(Ratio(1, -308).nearest(), InputError) << "not normal";
  EXPECT_NO_THROW(Ratio(1, 308).nearest());
  EXPECT_EQ((Ratio(5, 999999999) / Ratio(7, 999998999) * Ratio(1, -1000)).nearest(), 5.0 / 7);
  EXPECT_THROW(Ratio(1, 999999999).nearest(), InputError) << "without a number of so many digits";
  EXPECT_THROW(Ratio(18446744073709551557U).power(-100000000).nearest(), InputError);
}

}  // namespace
}  // namespace ixos
