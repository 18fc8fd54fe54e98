/// Functions of which the means of interaction laws over a range of gaps consist. All keep their digits as the range
/// shrinks.
#pragma once
#include <cmath>

#include "base/pack.hpp"

namespace ixos {

/// Returns f(x), for a pack lane by lane.
template <class Function>
double lanewise(double x, const Function& f) {
  return f(x);
}
template <class Function>
Pack lanewise(const Pack& x, const Function& f) {
  return Pack([&](auto i) { return f(static_cast<double>(x[i])); });
}
/// Returns f(x, y), likewise.
template <class Function>
double lanewise(double x, double y, const Function& f) {
  return f(x, y);
}
template <class Function>
Pack lanewise(const Pack& x, const Pack& y, const Function& f) {
  return Pack([&](auto i) { return f(static_cast<double>(x[i]), static_cast<double>(y[i])); });
}

/// Returns the mean of e^t over t from 0 to x, expm1(x)/x.
inline double mean_exponential(double x) { return x == 0 ? 1 : std::expm1(x) / x; }

/// Returns int_0^1 xi^k e^(-xi x) dxi: for k = 1 [1 - (1 + x) e^-x]/x^2, for k = 2 [2 - (2 + 2 x + x^2) e^-x]/x^3.
double exponential_moment_1(double x);
double exponential_moment_2(double x);

/// Returns Ein(x) = int_0^x (1 - e^-t)/t dt (Abramowitz and Stegun 1964, 5.1.40).
double entire_exponential_integral(double x);

/// Returns int_0^1 (1 + xi x)^-(p + 1) dxi for x > -1 and p >= 0: [1 - (1 + x)^-p]/(p x), for p = 0 ln(1 + x)/x.
double mean_power(double p, double x);

/// Returns int_0^1 xi (1 + xi x)^-(p + 2) dxi, which is minus the derivative of mean_power() in x over p + 1.
double power_moment(double p, double x);

/// Returns the potential of a mean traction, -int_r0^r1 mean(r0, r) dr, for 0 < r0, r1, by 24 Gauss points in ln r.
/// `mean` takes and returns numbers. For sums of powers of r the error is rounding if r1/r0 is between 1e-3 and 1e3.
template <class Mean>
double mean_potential_by_quadrature(double r0, double r1, const Mean& mean);

namespace detail {
struct LogarithmicPoint {
  double place, weight;
};
constexpr int logarithmic_points = 24;
/// Returns the Gauss points on [0, 1].
const LogarithmicPoint* logarithmic_rule();
}  // namespace detail

template <class Mean>
double mean_potential_by_quadrature(double r0, double r1, const Mean& mean) {
  const double way = std::log1p((r1 - r0) / r0);
  double sum = 0;
  for (int i = 0; i < detail::logarithmic_points; ++i) {
    const auto [place, weight] = detail::logarithmic_rule()[i];
    const double r = r0 * std::exp(place * way);
    sum += weight * r * mean(r0, r);
  }
  return -way * sum;
}

}  // namespace ixos
