/// Triangles.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "fem/cell_traits.hpp"
#include "fem/contact_elements.hpp"
#include "fem/reference_elements.hpp"
#include "fem/simplex_nodes.hpp"
#include "fem/simplex_rules.hpp"

namespace ixos {

/// Members of all triangles: the coordinates xi, eta >= 0, xi + eta <= 1 and the barycentric {1 - xi - eta, xi, eta}.
struct TriangleBase {
  static constexpr int dimension = 2;
  static constexpr std::array<std::array<double, 2>, 3> corners{{{0, 0}, {1, 0}, {0, 1}}};
  static constexpr std::array<std::array<double, 2>, 3> slope{{{-1, -1}, {1, 0}, {0, 1}}};  ///< of the barycentric ones
  static std::array<double, 3> barycentric(const std::array<double, 2>& xi) {
    return {1 - xi[0] - xi[1], xi[0], xi[1]};
  }
  /// Returns triangle_rule().
  static QuadratureRule<2> rule(int along) { return triangle_rule(along); }
};

/// The linear triangle: the barycentric coordinates. Node order of Exodus TRI3. Its strain is constant, so it locks in
/// bending and if it is nearly incompressible.
struct Tri3 : TriangleBase, NodesBetweenCorners<Tri3> {
  static constexpr int nodes = 3;
  static constexpr std::size_t most_points = 1;

  static void evaluate(const std::array<double, 2>& xi, std::array<double, 3>& value,
                       std::array<std::array<double, 2>, 3>& gradient) {
    value = barycentric(xi);
    gradient = slope;
  }
  static std::vector<NodeCorners> node_corners() { return {{0}, {1}, {2}}; }

  /// One point integrates the constant stress exactly.
  static QuadratureRule<2> own_rule(bool /*high*/) { return triangle_rule(1); }
  static QuadratureRule<2> mass_rule() { return triangle_rule(2); }
};

/// The quadratic triangle: N_i = l_i (2 l_i - 1), N_ij = 4 l_i l_j. Node order of Exodus TRI6.
struct Tri6 : TriangleBase, NodesBetweenCorners<Tri6> {
  static constexpr int nodes = 6;
  static constexpr std::size_t most_points = 6;
  static constexpr std::array<std::array<std::size_t, 2>, 3> edges{{{0, 1}, {1, 2}, {2, 0}}};

  static void evaluate(const std::array<double, 2>& xi, std::array<double, 6>& value,
                       std::array<std::array<double, 2>, 6>& gradient) {
    const std::array<double, 3> l = barycentric(xi);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [a, b] = edges[i];
      value[i] = l[i] * (2 * l[i] - 1);
      value[3 + i] = 4 * l[a] * l[b];
      for (std::size_t d = 0; d < 2; ++d) {
        gradient[i][d] = (4 * l[i] - 1) * slope[i][d];
        gradient[3 + i][d] = 4 * (l[a] * slope[b][d] + l[b] * slope[a][d]);
      }
    }
  }
  static std::vector<NodeCorners> node_corners() { return {{0}, {1}, {2}, {0, 1}, {1, 2}, {2, 0}}; }

  /// Three points have full rank and pass the patch test, on curved cells too; on rings, whose radius is a factor of
  /// the integrand, six.
  static QuadratureRule<2> own_rule(bool high) { return high ? triangle_rule(2) : three_point_rule(); }
  static QuadratureRule<2> mass_rule() { return triangle_rule(5); }
};

/// The quadratic triangle with the cubic bubble b = 27 l_1 l_2 l_3: the functions of Tri6, less b/9 times -1 at corners
/// and 4 at edges, and b (Crouzeix and Raviart 1973). Node order of Tri6, then the centre.
struct Tri7 : TriangleBase, NodesBetweenCorners<Tri7> {
  static constexpr int nodes = 7;
  static constexpr std::size_t most_points = 7;

  static void evaluate(const std::array<double, 2>& xi, std::array<double, 7>& value,
                       std::array<std::array<double, 2>, 7>& gradient) {
    std::array<double, 6> plain;
    std::array<std::array<double, 2>, 6> plain_gradient;
    Tri6::evaluate(xi, plain, plain_gradient);
    const std::array<double, 3> l = barycentric(xi);
    value[6] = 27 * l[0] * l[1] * l[2];
    for (std::size_t d = 0; d < 2; ++d)
      gradient[6][d] = 27 * (slope[0][d] * l[1] * l[2] + l[0] * slope[1][d] * l[2] + l[0] * l[1] * slope[2][d]);
    for (std::size_t a = 0; a < 6; ++a) {
      const double share = a < 3 ? 1.0 / 9 : -4.0 / 9;
      value[a] = plain[a] + share * value[6];
      for (std::size_t d = 0; d < 2; ++d) gradient[a][d] = plain_gradient[a][d] + share * gradient[6][d];
    }
  }
  static std::vector<NodeCorners> node_corners() { return {{0}, {1}, {2}, {0, 1}, {1, 2}, {2, 0}, {0, 1, 2}}; }

  static QuadratureRule<2> own_rule(bool high) { return triangle_rule(high ? 3 : 2); }
  static QuadratureRule<2> mass_rule() { return triangle_rule(6); }
  /// Returns the weights of a rule at the nodes, exact for polynomials of degree 3: those of the lumped mass.
  static std::array<double, 7> nodal_weights() {
    return {1.0 / 40, 1.0 / 40, 1.0 / 40, 1.0 / 15, 1.0 / 15, 1.0 / 15, 9.0 / 40};
  }
};

struct TriangleTraits : CommonCellTraits {
  static constexpr ReferenceShape shape = ReferenceShape::Triangle;
  using Corners = Tri3;
  static SideNodes side_corners() { return {{0, 1}, {1, 2}, {2, 0}}; }
};

template <>
struct CellTraits<Tri3> : SimplexTraits<Tri3, TriangleTraits> {
  using Sides = SideElements<Line2, Line2, Line2>;
  static constexpr bool constant_strain = true;
  static constexpr std::string_view exodus = "TRI3";
  static constexpr int gmsh = 2;
};

struct QuadraticTriangleTraits : TriangleTraits {
  using Sides = SideElements<LagrangeEdge<2>, LagrangeEdge<2>, LagrangeEdge<2>>;
};

template <>
struct CellTraits<Tri6> : SimplexTraits<Tri6, QuadraticTriangleTraits> {
  static constexpr std::string_view exodus = "TRI6";
  static constexpr int gmsh = 9;
};

template <>
struct CellTraits<Tri7> : SimplexTraits<Tri7, QuadraticTriangleTraits> {
  using Drawn = Tri6;
  static constexpr bool bubbles = true;
};

}  // namespace ixos
