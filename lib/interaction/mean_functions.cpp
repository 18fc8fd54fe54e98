#include "interaction/mean_functions.hpp"

#include <array>

#include "fem/quadrature.hpp"

namespace ixos {
namespace {

/// Returns sum_j (-x)^j/(j! (j + 1 + k)), the Taylor series of int_0^1 xi^k e^(-xi x) dxi.
double exponential_series(int k, double x) {
  double term = 1, sum = 0;
  for (int j = 0; j < 20; ++j) {
    sum += term / (j + 1 + k);
    term *= -x / (j + 1);
  }
  return sum;
}

}  // namespace

double exponential_moment_1(double x) {
  if (std::abs(x) > 0.5) return (1 - (1 + x) * std::exp(-x)) / (x * x);
  return exponential_series(1, x);
}

double exponential_moment_2(double x) {
  if (std::abs(x) > 1) return (2 - (2 + 2 * x + x * x) * std::exp(-x)) / (x * x * x);
  return exponential_series(2, x);
}

double entire_exponential_integral(double x) {
  constexpr double euler = 0.577215664901532861;
  // Up to -100 the series has enough terms; beyond, Ei(-x) is the integral but for a logarithm.
  if (x > 2 || x < -100) return -std::expint(-x) + std::log(std::abs(x)) + euler;
  double term = 1, sum = 0;
  for (int k = 1; k < 200; ++k) {
    term *= -x / k;
    sum -= term / k;
  }
  return sum;
}

double mean_power(double p, double x) {
  if (x == 0) return 1;
  const double l = std::log1p(x);
  return p == 0 ? l / x : -std::expm1(-p * l) / (p * x);
}

double power_moment(double p, double x) {
  if (std::abs((p + 2) * x) > 0.25) return (mean_power(p, x) - std::pow(1 + x, -(p + 1))) / ((p + 1) * x);
  // The binomial series: the formula loses the digits that (p + 2) x lacks.
  double term = 1, sum = 0.5;
  for (int k = 1; k < 40 && std::abs(term) > 1e-18; ++k) {
    term *= -x * (p + 1 + k) / k;
    sum += term / (k + 2);
  }
  return sum;
}

namespace detail {

const LogarithmicPoint* logarithmic_rule() {
  static const auto points = [] {
    const Quadrature gauss = gauss_legendre_unit(logarithmic_points);
    std::array<LogarithmicPoint, logarithmic_points> result{};
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = {gauss.points[i], gauss.weights[i]};
    return result;
  }();
  return points.data();
}

}  // namespace detail
}  // namespace ixos
