#include "base/dense_solve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace ixos {
namespace {

using Numbers = std::vector<double>;

TEST(DenseSolveTest, EquationsOfAnyScaleAndOrder) {
  std::mt19937 random(1);
  std::uniform_real_distribution<> between(-1, 1);
  for (const std::size_t size : {1, 2, 3, 6, 12}) {
    Numbers a(size * size), exact(size), b(size, 0.0);
    for (double& value : a) value = between(random);
    for (std::size_t j = 0; j < size; ++j) exact[j] = between(random) * std::pow(10, 2.0 * static_cast<double>(j));
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < size; ++j) {
        // equations and unknowns of other units
        a[i * size + j] *= std::pow(10, 3.0 * static_cast<double>(i) - 2.0 * static_cast<double>(j));
        b[i] += a[i * size + j] * exact[j];
      }
    const Numbers x = dense_solve(a, b);
    ASSERT_EQ(x.size(), size);
    for (std::size_t i = 0; i < size; ++i) EXPECT_NEAR(x[i] / exact[i], 1, 1e-11) << size << ' ' << i;
  }
}

TEST(DenseSolveTest, PivotsMayBeZeroAtFirst) {
  EXPECT_EQ(dense_solve({0, 2, 4, 0}, {6, 8}), Numbers({2, 3}));
  EXPECT_EQ(dense_solve({0, 0, 1, 1, 0, 0, 0, 1, 0}, {1, 2, 3}), Numbers({2, 3, 1}));
}

TEST(DenseSolveTest, SingularSystemsHaveNoSolution) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(dense_solve({1, 2, 2, 4}, {1, 2}).empty());
  EXPECT_TRUE(dense_solve({1, 2, 3, 4, 5, 6, 7, 8, 9}, {1, 2, 3}).empty()) << "to rounding";
  EXPECT_TRUE(dense_solve({0, 0, 1, 1}, {1, 1}).empty()) << "an equation without entries";
  EXPECT_TRUE(dense_solve({0, 1, 0, 1}, {1, 1}).empty()) << "an unknown without entries";
  EXPECT_TRUE(dense_solve({nan, 1, 1, 1}, {1, 1}).empty());
  EXPECT_TRUE(dense_solve({}, {}).empty());
}

}  // namespace
}  // namespace ixos
