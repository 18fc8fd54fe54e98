#include "interaction/mean_functions.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/quadrature.hpp"

namespace ixos {
namespace {

/// The integral of f over [0, 1] by 8 times 20 Gauss points.
template <class Function>
double integral(const Function& f) {
  static const Quadrature gauss = gauss_legendre_unit(20);
  double sum = 0;
  for (int part = 0; part < 8; ++part)
    for (std::size_t q = 0; q < gauss.points.size(); ++q) sum += gauss.weights[q] / 8 * f((part + gauss.points[q]) / 8);
  return sum;
}

// Both sides of each formula's switch to a series, and sizes at which a difference would lose all digits.
constexpr double arguments[] = {-30,   -3,  -1.01, -0.99, -0.51, -0.49, -1e-3, -1e-9, 0,
                                1e-12, 0.1, 0.49,  0.51,  0.99,  1.01,  3,     40};

TEST(MeanFunctionsTest, ExponentialMomentsAreIntegrals) {
  for (double x : arguments) {
    const auto moment = [x](int k) { return integral([&](double t) { return std::pow(t, k) * std::exp(-x * t); }); };
    EXPECT_NEAR(mean_exponential(-x), moment(0), 1e-14 * moment(0)) << x;
    EXPECT_NEAR(exponential_moment_1(x), moment(1), 1e-14 * moment(1)) << x;
    EXPECT_NEAR(exponential_moment_2(x), moment(2), 4e-14 * moment(2)) << x;
    const double ein = integral([&](double t) { return x * (t * x == 0 ? 1 : -std::expm1(-t * x) / (t * x)); });
    EXPECT_NEAR(entire_exponential_integral(x), ein, 1e-14 * std::abs(ein)) << x;
  }
}

// python3 -c "from mpmath import *; mp.dps = 40; print([log(x) + euler - ei(x) for x in (100, 120)])"
TEST(MeanFunctionsTest, TheExponentialIntegralGoesOnBeyondItsSeries) {
  EXPECT_NEAR(entire_exponential_integral(-100) / -2.715552744853879822e41, 1, 1e-13);
  EXPECT_NEAR(entire_exponential_integral(-120) / -1.096029062158031070e50, 1, 1e-13);
}

TEST(MeanFunctionsTest, PowerMomentsAreIntegrals) {
  for (double p : {0.0, 0.3, 2.0, 8.0, 11.5})
    for (double x : {-0.8, -0.3, -0.1, -0.024, -1e-6, 0.0, 1e-14, 0.02, 0.026, 0.12, 0.13, 0.5, 3.0}) {
      const auto mean = integral([&](double t) { return std::pow(1 + t * x, -(p + 1)); });
      const auto moment = integral([&](double t) { return t * std::pow(1 + t * x, -(p + 2)); });
      EXPECT_NEAR(mean_power(p, x), mean, 2e-14 * mean) << p << ' ' << x;
      EXPECT_NEAR(power_moment(p, x), moment, 2e-14 * moment) << p << ' ' << x;
    }
}

TEST(MeanFunctionsTest, QuadratureInTheLogarithmFindsThePotential) {
  // The mean of r^-3 over gaps from a to b is (a + b)/(2 a^2 b^2), whose integral over b is known.
  const auto mean = [](double a, double b) { return (a + b) / (2 * a * a * b * b); };
  for (double a : {0.01, 0.3, 5.0})
    for (double b : {0.02, 0.3, 0.3000001, 4.0, 7.0}) {
      const double l = std::log1p((b - a) / a), exact = -(l - std::expm1(-l)) / (2 * a * a);
      EXPECT_NEAR(mean_potential_by_quadrature(a, b, mean), exact, 1e-13 * std::abs(exact)) << a << ' ' << b;
    }
}

TEST(MeanFunctionsTest, PacksAreTakenLaneByLane) {
  const Pack x([](auto i) { return 1.0 + static_cast<double>(static_cast<std::size_t>(i)); });
  const Pack square = lanewise(x, [](double t) { return t * t; });
  const Pack difference = lanewise(x, square, [](double t, double s) { return s - t; });
  for (std::size_t i = 0; i < Pack::size(); ++i) {
    EXPECT_EQ(square[i], x[i] * x[i]);
    EXPECT_EQ(difference[i], x[i] * x[i] - x[i]);
  }
  EXPECT_EQ(lanewise(3.0, [](double t) { return t + 1; }), 4);
}

}  // namespace
}  // namespace ixos
