/// Pyramids, between hexahedra and tetrahedra.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "fem/cells/triangles.hpp"
#include "fem/pyramid_functions.hpp"
#include "fem/quadratic_elements.hpp"

namespace ixos {

/// Members of all pyramids: |xi|, |eta| <= 1 - zeta, zeta >= 0.
struct PyramidBase {
  static constexpr int dimension = 3;
  static constexpr std::array<std::array<double, 3>, 5> corners{
      {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1}}};
  /// Returns pyramid_rule(), with one point more along zeta than the number, for the functions are no polynomials.
  static QuadratureRule<3> rule(int along) { return pyramid_rule(along + 1); }
};

/// The linear pyramid: the functions 1, xi, eta, zeta and xi eta/(1 - zeta). Node order of Exodus PYRAMID5.
struct Pyr5 : PyramidBase, NodesBetweenCorners<Pyr5> {
  static constexpr int nodes = 5;
  static constexpr std::size_t most_points = 8;

  static void evaluate(const std::array<double, 3>& xi, std::array<double, 5>& value,
                       std::array<std::array<double, 3>, 5>& gradient) {
    const auto [x, y, z] = xi;
    const double s = 1 - z, p = s == 0 ? 0 : x / s, q = s == 0 ? 0 : y / s;
    for (std::size_t c = 0; c < 4; ++c) {
      const double i = corners[c][0], j = corners[c][1];
      value[c] = (s + i * x + j * y + i * j * p * y) / 4;
      gradient[c] = {(i + i * j * q) / 4, (j + i * j * p) / 4, (-1 + i * j * p * q) / 4};
    }
    value[4] = z;
    gradient[4] = {0, 0, 1};
  }
  static std::vector<NodeCorners> node_corners() { return {{0}, {1}, {2}, {3}, {4}}; }

  static QuadratureRule<3> own_rule(bool /*high*/) { return pyramid_rule(2); }
  static QuadratureRule<3> mass_rule() { return pyramid_rule(3); }
};

/// A pyramid whose functions are combinations of the first PyramidFunctions. `Own` lists node_corners().
template <class Own, int Nodes>
struct RationalPyramid : PyramidBase, NodesBetweenCorners<Own> {
  static constexpr int nodes = Nodes;

  static void evaluate(const std::array<double, 3>& xi, std::array<double, Nodes>& value,
                       std::array<std::array<double, 3>, Nodes>& gradient) {
    static const auto coefficients = [] {
      std::array<std::array<double, 3>, Nodes> places;
      for (std::size_t a = 0; a < places.size(); ++a) places[a] = Own::place(a);
      return pyramid_coefficients(places);
    }();
    const PyramidFunctions functions(xi);
    for (std::size_t a = 0; a < value.size(); ++a) {
      value[a] = 0;
      gradient[a] = {};
      for (std::size_t k = 0; k < value.size(); ++k) {
        value[a] += coefficients[a][k] * functions.value[k];
        for (std::size_t d = 0; d < 3; ++d) gradient[a][d] += coefficients[a][k] * functions.gradient[k][d];
      }
    }
  }
};

/// The quadratic pyramid. Node order of Exodus PYRAMID14: corners, edges of the base, of the sides, middle of the base.
struct Pyr14 : RationalPyramid<Pyr14, 14> {
  static constexpr std::size_t most_points = 27;
  static std::vector<NodeCorners> node_corners() {
    return {{0}, {1}, {2}, {3}, {4}, {0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}, {0, 1, 2, 3}};
  }
  static QuadratureRule<3> own_rule(bool /*high*/) { return pyramid_rule(3); }
  static QuadratureRule<3> mass_rule() { return pyramid_rule(5); }
};

/// The quadratic pyramid with bubbles. Node order of Pyr14, then the centres of the triangles in the order of the
/// sides, then a node inside, at a fifth of the height.
struct Pyr19 : RationalPyramid<Pyr19, 19> {
  static constexpr std::size_t most_points = 64;
  static std::vector<NodeCorners> node_corners() {
    std::vector<NodeCorners> all = Pyr14::node_corners();
    all.insert(all.end(), {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 4, 3}, {0, 1, 2, 3, 4}});
    return all;
  }
  static QuadratureRule<3> own_rule(bool /*high*/) { return pyramid_rule(4); }
  static QuadratureRule<3> mass_rule() { return pyramid_rule(6); }
};

struct PyramidTraits : CommonCellTraits {
  static constexpr ReferenceShape shape = ReferenceShape::Pyramid;
  using Corners = Pyr5;
  /// In Exodus order: the triangles, then the base.
  static SideNodes side_corners() { return {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 4, 3}, {0, 3, 2, 1}}; }
};

template <>
struct CellTraits<Pyr5> : SimplexTraits<Pyr5, PyramidTraits> {
  using Sides = SideElements<Tri3, Tri3, Tri3, Tri3, Quad4>;
  static constexpr std::string_view exodus = "PYRAMID5";
  static constexpr int gmsh = 7;
};

template <>
struct CellTraits<Pyr14> : SimplexTraits<Pyr14, PyramidTraits> {
  using Sides = SideElements<Tri6, Tri6, Tri6, Tri6, Quad9>;
  static constexpr std::string_view exodus = "PYRAMID14";
  static constexpr int gmsh = 14;
};

template <>
struct CellTraits<Pyr19> : SimplexTraits<Pyr19, PyramidTraits> {
  using Drawn = Pyr14;
  using Sides = SideElements<Tri7, Tri7, Tri7, Tri7, Quad9>;
  static constexpr bool bubbles = true;
};

}  // namespace ixos
