/// One-dimensional quadrature.
#pragma once
#include <vector>

namespace ixos {

struct Quadrature {
  std::vector<double> points;
  std::vector<double> weights;
};

/// Returns the Gauss-Legendre rule with n points on [-1, 1], exact for polynomials of degree 2n - 1, points ascending.
/// Finds the roots of the Legendre polynomial by Newton's method from the asymptotic guess (Abramowitz and Stegun 1964,
/// 25.4.29). Throws InputError unless 1 <= n <= 64.
Quadrature gauss_legendre(int n);

/// Returns that rule mapped to [0, 1].
Quadrature gauss_legendre_unit(int n);

}  // namespace ixos
