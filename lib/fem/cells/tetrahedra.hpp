/// Tetrahedra.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "fem/cells/triangles.hpp"

namespace ixos {

/// Members of all tetrahedra: the coordinates xi, eta, zeta >= 0, xi + eta + zeta <= 1, and the barycentric ones.
struct TetrahedronBase {
  static constexpr int dimension = 3;
  static constexpr std::array<std::array<double, 3>, 4> corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  static constexpr std::array<std::array<double, 3>, 4> slope{{{-1, -1, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  static std::array<double, 4> barycentric(const std::array<double, 3>& xi) {
    return {1 - xi[0] - xi[1] - xi[2], xi[0], xi[1], xi[2]};
  }
  /// Returns tetrahedron_rule().
  static QuadratureRule<3> rule(int along) { return tetrahedron_rule(along); }
};

/// The linear tetrahedron. Node order of Exodus TETRA4. Its strain is constant, so it locks in bending and if it is
/// nearly incompressible.
struct Tet4 : TetrahedronBase, NodesBetweenCorners<Tet4> {
  static constexpr int nodes = 4;
  static constexpr std::size_t most_points = 1;

  static void evaluate(const std::array<double, 3>& xi, std::array<double, 4>& value,
                       std::array<std::array<double, 3>, 4>& gradient) {
    value = barycentric(xi);
    gradient = slope;
  }
  static std::vector<NodeCorners> node_corners() { return {{0}, {1}, {2}, {3}}; }

  static QuadratureRule<3> own_rule(bool /*high*/) { return tetrahedron_rule(1); }
  static QuadratureRule<3> mass_rule() { return tetrahedron_rule(2); }
};

/// The quadratic tetrahedron: N_i = l_i (2 l_i - 1), N_ij = 4 l_i l_j. Node order of Exodus TETRA10.
struct Tet10 : TetrahedronBase, NodesBetweenCorners<Tet10> {
  static constexpr int nodes = 10;
  static constexpr std::size_t most_points = 8;
  static constexpr std::array<std::array<std::size_t, 2>, 6> edges{{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}}};

  static void evaluate(const std::array<double, 3>& xi, std::array<double, 10>& value,
                       std::array<std::array<double, 3>, 10>& gradient) {
    const std::array<double, 4> l = barycentric(xi);
    for (std::size_t i = 0; i < 4; ++i) {
      value[i] = l[i] * (2 * l[i] - 1);
      for (std::size_t d = 0; d < 3; ++d) gradient[i][d] = (4 * l[i] - 1) * slope[i][d];
    }
    for (std::size_t e = 0; e < 6; ++e) {
      const auto [a, b] = edges[e];
      value[4 + e] = 4 * l[a] * l[b];
      for (std::size_t d = 0; d < 3; ++d) gradient[4 + e][d] = 4 * (l[a] * slope[b][d] + l[b] * slope[a][d]);
    }
  }
  static std::vector<NodeCorners> node_corners() {
    return {{0}, {1}, {2}, {3}, {0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}};
  }

  /// Four points have full rank; on curved cells they fail the patch test, and eight pass it.
  static QuadratureRule<3> own_rule(bool high) { return high ? tetrahedron_rule(2) : four_point_rule(); }
  static QuadratureRule<3> mass_rule() { return tetrahedron_rule(4); }
};

/// The quadratic tetrahedron with cubic bubbles of its faces, 27 l_i l_j l_k (1 - 4 l_m), and the quartic one of the
/// cell, B = 256 l_0 l_1 l_2 l_3 (Geevers, Mulder and van der Vegt 2018, SIAM J. Sci. Comput. 40, have its nodal rule).
/// Node order of Tet10, then the centres of the faces in the order of the sides, then that of the cell.
struct Tet15 : TetrahedronBase, NodesBetweenCorners<Tet15> {
  static constexpr int nodes = 15;
  static constexpr std::size_t most_points = 14;
  /// The corners of the faces, and the one that is not there.
  static constexpr std::array<std::array<std::size_t, 4>, 4> faces{
      {{0, 1, 3, 2}, {1, 2, 3, 0}, {0, 3, 2, 1}, {0, 2, 1, 3}}};

  static void evaluate(const std::array<double, 3>& xi, std::array<double, 15>& value,
                       std::array<std::array<double, 3>, 15>& gradient) {
    std::array<double, 10> plain;
    std::array<std::array<double, 3>, 10> plain_gradient;
    Tet10::evaluate(xi, plain, plain_gradient);
    const std::array<double, 4> l = barycentric(xi);
    for (std::size_t f = 0; f < 4; ++f) {
      const auto [i, j, k, m] = faces[f];
      const double b = 27 * l[i] * l[j] * l[k], rest = 1 - 4 * l[m];
      value[10 + f] = b * rest;
      for (std::size_t d = 0; d < 3; ++d)
        gradient[10 + f][d] =
            27 * (slope[i][d] * l[j] * l[k] + l[i] * slope[j][d] * l[k] + l[i] * l[j] * slope[k][d]) * rest -
            4 * b * slope[m][d];
    }
    value[14] = 256 * l[0] * l[1] * l[2] * l[3];
    for (std::size_t d = 0; d < 3; ++d)
      gradient[14][d] = 256 * ((slope[0][d] * l[1] + l[0] * slope[1][d]) * l[2] * l[3] +
                               l[0] * l[1] * (slope[2][d] * l[3] + l[2] * slope[3][d]));
    const auto add = [&](std::size_t a, double share, std::size_t bubble) {
      value[a] += share * value[bubble];
      for (std::size_t d = 0; d < 3; ++d) gradient[a][d] += share * gradient[bubble][d];
    };
    for (std::size_t a = 0; a < 10; ++a) {
      value[a] = plain[a];
      gradient[a] = plain_gradient[a];
      for (std::size_t f = 0; f < 4; ++f) {
        const std::size_t missing = faces[f][3];
        const bool touches =
            a < 4 ? a != missing : Tet10::edges[a - 4][0] != missing && Tet10::edges[a - 4][1] != missing;
        if (touches) add(a, a < 4 ? 1.0 / 9 : -4.0 / 9, 10 + f);
      }
      add(a, a < 4 ? 1.0 / 8 : -1.0 / 4, 14);
    }
  }
  static std::vector<NodeCorners> node_corners() {
    std::vector<NodeCorners> all = Tet10::node_corners();
    all.insert(all.end(), {{0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 2, 1}, {0, 1, 2, 3}});
    return all;
  }

  /// Fourteen points; with eight there are three modes without energy.
  static QuadratureRule<3> own_rule(bool /*high*/) { return tetrahedron_rule(3); }
  static QuadratureRule<3> mass_rule() { return tetrahedron_rule(6); }
  /// Returns the weights of a rule at the nodes, exact for polynomials of degree 3: those of the lumped mass.
  static std::array<double, 15> nodal_weights() {
    std::array<double, 15> weights;
    for (std::size_t a = 0; a < 15; ++a)
      weights[a] = (a < 4 ? 17.0 / 840 : a < 10 ? 4.0 / 105 : a < 14 ? 27.0 / 280 : 32.0 / 105) / 6;
    return weights;
  }
};

struct TetrahedronTraits : CommonCellTraits {
  static constexpr ReferenceShape shape = ReferenceShape::Tetrahedron;
  using Corners = Tet4;
  static SideNodes side_corners() { return {{0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 2, 1}}; }
};

template <>
struct CellTraits<Tet4> : SimplexTraits<Tet4, TetrahedronTraits> {
  using Sides = SideElements<Tri3, Tri3, Tri3, Tri3>;
  static constexpr bool constant_strain = true;
  static constexpr std::string_view exodus = "TETRA4";
  static constexpr int gmsh = 4;
};

template <>
struct CellTraits<Tet10> : SimplexTraits<Tet10, TetrahedronTraits> {
  using Sides = SideElements<Tri6, Tri6, Tri6, Tri6>;
  static constexpr std::string_view exodus = "TETRA10";
  static constexpr int gmsh = 11;
};

template <>
struct CellTraits<Tet15> : SimplexTraits<Tet15, TetrahedronTraits> {
  using Drawn = Tet10;
  using Sides = SideElements<Tri7, Tri7, Tri7, Tri7>;
  static constexpr bool bubbles = true;
};

}  // namespace ixos
