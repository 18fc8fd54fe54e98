/// Quadrature on triangles, tetrahedra, prisms and pyramids. All weights are positive.
#pragma once
#include "fem/quadrature.hpp"

namespace ixos {

/// Returns a rule on the triangle xi, eta >= 0, xi + eta <= 1. `along` from 1 to 5 gives 1, 6, 7, 12 and 16 points,
/// exact for polynomials of degree 1, 4, 5, 6 and 8 (Dunavant 1985, Int. J. Numer. Methods Eng. 21); more give the
/// square of Gauss-Jacobi points with one side drawn together, of degree 2 along - 1.
/// Throws InputError unless 1 <= along <= 64.
QuadratureRule<2> triangle_rule(int along);
/// Returns that of the three points (1/6, 1/6), (2/3, 1/6) and (1/6, 2/3), exact for polynomials of degree 2.
QuadratureRule<2> three_point_rule();

/// Returns a rule on the tetrahedron xi, eta, zeta >= 0, xi + eta + zeta <= 1. `along` from 1 to 3 gives 1, 8 and 14
/// points, exact for polynomials of degree 1, 3 and 5 (14: Walkington 2000, Quadrature on simplices of arbitrary
/// dimension); more give the cube of Gauss-Jacobi points, of degree 2 along - 1.
/// Throws InputError unless 1 <= along <= 64.
QuadratureRule<3> tetrahedron_rule(int along);
/// Returns that of four points on the lines from the centre to the corners, exact for polynomials of degree 2.
QuadratureRule<3> four_point_rule();

/// Returns the product of a rule on the triangle with Gauss points along zeta, -1 <= zeta <= 1.
QuadratureRule<3> prism_rule(const QuadratureRule<2>& triangle, int along);

/// Returns along^3 points on the pyramid |xi|, |eta| <= 1 - zeta, 0 <= zeta <= 1: Gauss points in planes of constant
/// zeta, Gauss-Jacobi points along zeta. It is exact for (1 - zeta)^k times polynomials of degree 2 along - 1 of
/// xi/(1 - zeta), of eta/(1 - zeta) and of zeta. Throws InputError unless 1 <= along <= 64.
QuadratureRule<3> pyramid_rule(int along);

}  // namespace ixos
