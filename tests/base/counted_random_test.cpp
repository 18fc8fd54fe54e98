#include "base/counted_random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace ixos {
namespace {

constexpr int count = 100000;

TEST(CountedRandomTest, NumbersAreEvenlySpreadAndIndependent) {
  double sum = 0, squares = 0, products = 0, last = 0;
  for (int k = 0; k < count; ++k) {
    const double x = counted_random(7, static_cast<std::uint64_t>(k), 3);
    ASSERT_GE(x, 0);
    ASSERT_LT(x, 1);
    sum += x;
    squares += x * x;
    products += x * last;
    last = x;
  }
  // Five deviations of the means.
  EXPECT_NEAR(sum / count, 0.5, 5 * std::sqrt(1.0 / 12 / count));
  EXPECT_NEAR(squares / count, 1.0 / 3, 5 * std::sqrt(4.0 / 45 / count));
  EXPECT_NEAR(products / count, 0.25, 5 * std::sqrt(7.0 / 144 / count));
}

TEST(CountedRandomTest, NormalNumbersHaveTheirMoments) {
  double sum = 0, squares = 0, fourth = 0;
  for (int k = 0; k < count; ++k) {
    const double x = counted_normal(7, 2, static_cast<std::uint64_t>(k));
    sum += x;
    squares += x * x;
    fourth += x * x * x * x;
  }
  EXPECT_NEAR(sum / count, 0, 5 / std::sqrt(count));
  EXPECT_NEAR(squares / count, 1, 5 * std::sqrt(2.0 / count));
  EXPECT_NEAR(fourth / count, 3, 5 * std::sqrt(96.0 / count));
}

TEST(CountedRandomTest, EachArgumentMakesOtherNumbers) {
  std::set<double> all;
  for (std::uint64_t seed = 0; seed < 10; ++seed)
    for (std::uint64_t owner = 0; owner < 10; ++owner)
      for (std::uint64_t number = 0; number < 10; ++number) all.insert(counted_random(seed, owner, number));
  EXPECT_EQ(all.size(), 1000U);
}

}  // namespace
}  // namespace ixos
