/// Prisms.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "fem/cells/triangles.hpp"
#include "fem/quadratic_elements.hpp"

namespace ixos {

/// The product of a triangle and a line, xi, eta >= 0, xi + eta <= 1, -1 <= zeta <= 1. `Own` lists for each node that
/// of the triangle and that of the line: factors().
template <class Own, class Triangle, class Line, int Nodes>
struct PrismBase : NodesBetweenCorners<Own> {
  static constexpr int dimension = 3;
  static constexpr int nodes = Nodes;
  static constexpr std::array<std::array<double, 3>, 6> corners{
      {{0, 0, -1}, {1, 0, -1}, {0, 1, -1}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}};

  static void evaluate(const std::array<double, 3>& xi, std::array<double, Nodes>& value,
                       std::array<std::array<double, 3>, Nodes>& gradient) {
    std::array<double, Triangle::nodes> in_plane;
    std::array<std::array<double, 2>, Triangle::nodes> slope;
    std::array<double, Line::nodes> along;
    std::array<std::array<double, 1>, Line::nodes> rise;
    Triangle::evaluate({xi[0], xi[1]}, in_plane, slope);
    Line::evaluate({xi[2]}, along, rise);
    for (std::size_t a = 0; a < value.size(); ++a) {
      const auto [t, k] = Own::factors[a];
      value[a] = in_plane[t] * along[k];
      gradient[a] = {slope[t][0] * along[k], slope[t][1] * along[k], in_plane[t] * rise[k][0]};
    }
  }

  /// A node stands between the corners of its triangle's node, at the bottom, at the top, or at both.
  static std::vector<NodeCorners> node_corners() {
    const std::vector<NodeCorners> triangle = Triangle::node_corners();
    std::vector<NodeCorners> result;
    for (const auto& [t, k] : Own::factors) {
      NodeCorners own;
      for (const int corner : triangle[t])
        if (k != 1) own.push_back(corner);
      for (const int corner : triangle[t])
        if (k != 0) own.push_back(corner + 3);
      result.push_back(own);
    }
    return result;
  }

  /// Returns a rule of triangle_rule() and as many points along zeta.
  static QuadratureRule<3> rule(int along) { return prism_rule(triangle_rule(along), along); }
};

using NodeFactors = std::array<std::size_t, 2>;

/// The linear prism. Node order of Exodus WEDGE6.
struct Prism6 : PrismBase<Prism6, Tri3, Line2, 6> {
  static constexpr std::array<NodeFactors, 6> factors{{{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}}};
  static constexpr std::size_t most_points = 6;
  static QuadratureRule<3> own_rule(bool /*high*/) { return prism_rule(three_point_rule(), 2); }
  static QuadratureRule<3> mass_rule() { return prism_rule(triangle_rule(2), 3); }
};

/// The product of Tri6 and the quadratic line. Node order of Exodus WEDGE18: corners, edges of the bottom, along zeta,
/// of the top, middles of the quadrilaterals.
struct Prism18 : PrismBase<Prism18, Tri6, LagrangeEdge<2>, 18> {
  static constexpr std::array<NodeFactors, 18> factors{{{0, 0},
                                                        {1, 0},
                                                        {2, 0},
                                                        {0, 1},
                                                        {1, 1},
                                                        {2, 1},
                                                        {3, 0},
                                                        {4, 0},
                                                        {5, 0},
                                                        {0, 2},
                                                        {1, 2},
                                                        {2, 2},
                                                        {3, 1},
                                                        {4, 1},
                                                        {5, 1},
                                                        {3, 2},
                                                        {4, 2},
                                                        {5, 2}}};
  static constexpr std::size_t most_points = 18;
  static QuadratureRule<3> own_rule(bool /*high*/) { return prism_rule(triangle_rule(2), 3); }
  static QuadratureRule<3> mass_rule() { return prism_rule(triangle_rule(5), 5); }
};

/// The product of Tri7 and the quadratic line. Node order of Prism18, then the centres of bottom, top and cell.
struct Prism21 : PrismBase<Prism21, Tri7, LagrangeEdge<2>, 21> {
  static constexpr std::array<NodeFactors, 21> factors = [] {
    std::array<NodeFactors, 21> all{};
    for (std::size_t a = 0; a < 18; ++a) all[a] = Prism18::factors[a];
    for (std::size_t k = 0; k < 3; ++k) all[18 + k] = {6, k};
    return all;
  }();
  static constexpr std::size_t most_points = 21;
  static QuadratureRule<3> own_rule(bool /*high*/) { return prism_rule(triangle_rule(3), 3); }
  static QuadratureRule<3> mass_rule() { return prism_rule(triangle_rule(6), 5); }
  /// Returns the products of Tri7's weights and Simpson's: those of the lumped mass.
  static std::array<double, 21> nodal_weights() {
    const std::array<double, 7> triangle = Tri7::nodal_weights();
    std::array<double, 21> weights;
    for (std::size_t a = 0; a < 21; ++a)
      weights[a] = triangle[factors[a][0]] * (factors[a][1] == 2 ? 4.0 / 3 : 1.0 / 3);
    return weights;
  }
};

struct PrismTraits : CommonCellTraits {
  static constexpr ReferenceShape shape = ReferenceShape::Prism;
  using Corners = Prism6;
  /// In Exodus order: three quadrilaterals, the bottom, the top.
  static SideNodes side_corners() { return {{0, 1, 4, 3}, {1, 2, 5, 4}, {0, 3, 5, 2}, {0, 2, 1}, {3, 4, 5}}; }
};

template <>
struct CellTraits<Prism6> : SimplexTraits<Prism6, PrismTraits> {
  using Sides = SideElements<Quad4, Quad4, Quad4, Tri3, Tri3>;
  static constexpr std::string_view exodus = "WEDGE6";
  static constexpr int gmsh = 6;
};

template <>
struct CellTraits<Prism18> : SimplexTraits<Prism18, PrismTraits> {
  using Sides = SideElements<Quad9, Quad9, Quad9, Tri6, Tri6>;
  static constexpr std::string_view exodus = "WEDGE18";
  static constexpr int gmsh = 13;
};

template <>
struct CellTraits<Prism21> : SimplexTraits<Prism21, PrismTraits> {
  using Drawn = Prism18;
  using Sides = SideElements<Quad9, Quad9, Quad9, Tri7, Tri7>;
  static constexpr bool bubbles = true;
};

}  // namespace ixos
