/// One-dimensional quadrature.
#pragma once
#include <vector>

namespace ixos {

struct Quadrature {
  std::vector<double> points;
  std::vector<double> weights;
};

/// Gauss-Legendre rule with n points on [-1, 1], exact for polynomials of degree 2n - 1. The roots of the Legendre
/// polynomial by Newton's method from the asymptotic guess (Abramowitz and Stegun 1964, 25.4.29). Ascending points.
/// Throws InputError unless 1 <= n <= 64.
Quadrature gauss_legendre(int n);

/// The same rule on [0, 1].
Quadrature gauss_legendre_unit(int n);

}  // namespace ixos
