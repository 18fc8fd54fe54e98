// Bernstein polynomials.
#include "geometry/bernstein.hpp"

#include <gtest/gtest.h>

namespace ixos {
namespace {

/// (1 - t)^3 = 1 - 3 t + 3 t^2 - t^3 and 3 t^2 (1 - t) are Bernstein polynomials of degree 3; the sum of all is 1.
TEST(BernsteinTest, CoefficientsOfBernsteinPolynomialsAreUnitVectors) {
  constexpr auto shares = bernstein_shares<3>();
  const auto convert = [&](const std::array<double, 4>& powers) {
    std::array<double, 4> result{};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k < 4; ++k) result[i] += shares[i][k] * powers[k];
    return result;
  };
  const auto expect = [](const std::array<double, 4>& a, const std::array<double, 4>& b) {
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(a[i], b[i], 1e-15);
  };
  expect(convert({1, -3, 3, -1}), {1, 0, 0, 0});
  expect(convert({0, 0, 3, -3}), {0, 0, 1, 0});
  expect(convert({1, 0, 0, 0}), {1, 1, 1, 1});
  EXPECT_EQ(binomial(6, 2), 15);
}

}  // namespace
}  // namespace ixos
