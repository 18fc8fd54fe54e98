#include "fem/quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/error.hpp"

namespace ixos {
namespace {

double power_sum(const Quadrature& rule, int power) {
  double sum = 0;
  for (std::size_t i = 0; i < rule.points.size(); ++i) sum += rule.weights[i] * std::pow(rule.points[i], power);
  return sum;
}

TEST(QuadratureTest, IsExactToDegreeTwoNMinusOne) {
  for (int n = 1; n <= 20; ++n)
    for (int k = 0; k < 2 * n; ++k)
      EXPECT_NEAR(power_sum(gauss_legendre(n), k), k % 2 == 0 ? 2.0 / (k + 1) : 0.0, 1e-13) << n << " points, x^" << k;
}

TEST(QuadratureTest, FailsAtDegreeTwoNByTheKnownRemainder) {
  // The remainder of Gauss-Legendre quadrature for x^2n: 2^(2n+1) (n!)^4/((2n+1) ((2n)!)^2).
  for (int n = 1; n <= 20; ++n) {
    double binomial = 1;  // (2n)!/(n!)^2
    for (int i = 1; i <= n; ++i) binomial *= static_cast<double>(n + i) / i;
    const double remainder = std::ldexp(1.0, 2 * n + 1) / ((2 * n + 1) * binomial * binomial);
    ASSERT_GT(remainder, 1e-12);
    EXPECT_NEAR(2.0 / (2 * n + 1) - power_sum(gauss_legendre(n), 2 * n), remainder, 1e-13) << n;
  }
}

TEST(QuadratureTest, PointsAscendAndWeightsArePositive) {
  for (int n = 1; n <= 64; ++n) {
    const Quadrature rule = gauss_legendre(n);
    ASSERT_EQ(rule.points.size(), static_cast<std::size_t>(n));
    ASSERT_EQ(rule.weights.size(), static_cast<std::size_t>(n));
    double before = -1;
    for (double x : rule.points) {
      EXPECT_GT(x, before) << n;
      before = x;
    }
    EXPECT_LT(before, 1.0) << n;
    for (double w : rule.weights) EXPECT_GT(w, 0.0) << n;
  }
}

TEST(QuadratureTest, IsSymmetric) {
  for (int n = 1; n <= 64; ++n) {
    const Quadrature rule = gauss_legendre(n);
    for (std::size_t i = 0, j = rule.points.size() - 1; i <= j && j < rule.points.size(); ++i, --j) {
      EXPECT_NEAR(rule.points[i], -rule.points[j], 1e-14) << n;
      EXPECT_NEAR(rule.weights[i], rule.weights[j], 1e-14) << n;
    }
  }
}

TEST(QuadratureTest, SixtyFourPointsAreStillExact) {
  const Quadrature rule = gauss_legendre(64);
  for (int k : {0, 2, 30, 126}) EXPECT_NEAR(power_sum(rule, k), 2.0 / (k + 1), 1e-13) << k;
}

TEST(QuadratureTest, UnitRuleIntegratesFromZeroToOne) {
  for (int n : {1, 2, 5, 16, 64}) {
    const Quadrature rule = gauss_legendre_unit(n);
    for (int k = 0; k < 2 * n; ++k) EXPECT_NEAR(power_sum(rule, k), 1.0 / (k + 1), 1e-13) << n << " points, x^" << k;
  }
}

TEST(QuadratureTest, NumbersOfPointsOutOfRangeAreRefused) {
  for (int n : {-1, 0, 65}) {
    std::string message;
    try {
      gauss_legendre(n);
    } catch (const InputError& error) {
      message = error.what();
    }
    EXPECT_EQ(message, std::to_string(n) + " quadrature points: must lie between 1 and 64");
    EXPECT_THROW(gauss_legendre_unit(n), InputError);
  }
}

}  // namespace
}  // namespace ixos
