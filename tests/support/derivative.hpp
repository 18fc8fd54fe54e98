/// Derivatives from finite differences.
#pragma once

namespace ixos::test {

/// Returns the derivative of f at 0 by Richardson's extrapolation of three central differences. `step` is the smallest
/// step. With steps of about 1e-3 of the argument's scale the error is about 1e-10.
template <class Function>
double derivative(const Function& f, double step = 5e-4) {
  const auto central = [&](double h) { return (f(h) - f(-h)) / (2 * h); };
  const double a = central(4 * step), b = central(2 * step), c = central(step);
  const double ab = (4 * b - a) / 3, bc = (4 * c - b) / 3;
  return (16 * bc - ab) / 15;
}

}  // namespace ixos::test
