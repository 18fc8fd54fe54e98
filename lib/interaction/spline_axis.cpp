#include "interaction/spline_axis.hpp"

#include "base/error.hpp"

namespace ixos {
namespace {

/// Solves x_{k-1} + 4 x_k + x_{k+1} = 6 b_k for k = 0, ..., n-1 with x_{-1} = x_n = 0 by elimination.
std::vector<double> solved(const std::vector<double>& b) {
  const std::size_t n = b.size();
  std::vector<double> factor(n), x(n);
  for (std::size_t k = 0; k < n; ++k) {
    const double divisor = 4 - (k > 0 ? factor[k - 1] : 0);
    factor[k] = 1 / divisor;
    x[k] = (6 * b[k] - (k > 0 ? x[k - 1] : 0)) / divisor;
  }
  for (std::size_t k = n - 1; k-- > 0;) x[k] -= factor[k] * x[k + 1];
  return x;
}

/// Solves the same with x_{-1} = x_{n-1} and x_n = x_0: the last unknown by itself (Sherman and Morrison 1950).
std::vector<double> solved_periodic(const std::vector<double>& b) {
  const std::size_t n = b.size() - 1;
  const std::vector<double> inner(b.begin(), b.end() - 1);
  std::vector<double> border(n, 0.0);
  border.front() = border.back() = -1.0 / 6;
  std::vector<double> x = solved(inner);
  const std::vector<double> y = solved(border);  // what x changes by with the last unknown
  const double last = (6 * b.back() - x.front() - x.back()) / (4 + y.front() + y.back());
  for (std::size_t k = 0; k < n; ++k) x[k] += last * y[k];
  x.push_back(last);
  return x;
}

}  // namespace

SplineAxis::SplineAxis(std::size_t samples, double distance, bool periodic)
    : samples_(samples),
      distance_(distance),
      scale_(1 / distance),
      start_(-0.5 * distance * static_cast<double>(samples - 1)),
      periodic_(periodic) {
  if (samples < 4) throw InputError("a spline needs at least 4 samples in a row");
  if (!(distance > 0)) throw InputError("the distance of two samples must be positive");
}

std::vector<double> SplineAxis::coefficients_of(const std::vector<double>& values) const {
  const std::size_t n = values.size();
  std::vector<double> c;
  if (periodic_) {
    const std::vector<double> x = solved_periodic(values);
    c.push_back(x.back());
    c.insert(c.end(), x.begin(), x.end());
    c.push_back(x[0]);
    c.push_back(x[1]);
    return c;
  }
  // No bend at the ends: there the coefficient is the sample itself.
  std::vector<double> inner(values.begin() + 1, values.end() - 1);
  inner.front() -= values.front() / 6;
  inner.back() -= values.back() / 6;
  const std::vector<double> x = solved(inner);
  c.push_back(2 * values[0] - x.front());
  c.push_back(values[0]);
  c.insert(c.end(), x.begin(), x.end());
  c.push_back(values[n - 1]);
  c.push_back(2 * values[n - 1] - x.back());
  return c;
}

}  // namespace ixos
