#include "fem/quadrature.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "base/error.hpp"

namespace ixos {
namespace {

/// Legendre polynomial P_n(x) and its derivative, by the three-term recurrence.
std::pair<double, double> legendre(int n, double x) {
  double before = 1.0;
  double value = x;
  for (int k = 2; k <= n; ++k) before = std::exchange(value, ((2 * k - 1) * x * value - (k - 1) * before) / k);
  return {value, n * (x * value - before) / (x * x - 1)};
}

}  // namespace

Quadrature gauss_legendre(int n) {
  if (n < 1 || n > 64) throw InputError(fmt::format("{} quadrature points: must lie between 1 and 64", n));
  if (n == 1) return {{0.0}, {2.0}};
  Quadrature rule;
  for (int i = n; i >= 1; --i) {
    double x = std::cos(M_PI * (i - 0.25) / (n + 0.5));
    for (int iteration = 0; iteration < 20; ++iteration) {
      const auto [value, slope] = legendre(n, x);
      const double step = value / slope;
      x -= step;
      if (std::abs(step) < 1e-16) break;
    }
    if (2 * i == n + 1) x = 0.0;
    const double slope = legendre(n, x).second;
    rule.points.push_back(x);
    rule.weights.push_back(2 / ((1 - x * x) * slope * slope));
  }
  return rule;
}

Quadrature gauss_legendre_unit(int n) {
  Quadrature rule = gauss_legendre(n);
  for (double& x : rule.points) x = (1 + x) / 2;
  for (double& w : rule.weights) w /= 2;
  return rule;
}

}  // namespace ixos
