/// The linear triangle.
#pragma once
#include <array>
#include <cstddef>

#include "fem/cell_traits.hpp"
#include "fem/quadrature.hpp"
#include "fem/reference_elements.hpp"

namespace ixos {

/// N = {1 - xi - eta, xi, eta} on the triangle xi, eta >= 0, xi + eta <= 1. Node order of Exodus TRI3. Its strain is
/// constant, so it locks in bending and if it is nearly incompressible.
struct Tri3 {
  static constexpr int dimension = 2;
  static constexpr int nodes = 3;
  static constexpr int default_along = 1;  ///< one point integrates the constant stress exactly
  static constexpr int mass_along = 2;

  static void evaluate(const std::array<double, 2>& xi, std::array<double, 3>& value,
                       std::array<std::array<double, 2>, 3>& gradient) {
    value = {1 - xi[0] - xi[1], xi[0], xi[1]};
    gradient = {{{-1, -1}, {1, 0}, {0, 1}}};
  }

  /// Returns a rule exact for polynomials of degree 2 `along` - 2 at least, of degree 1 with one point.
  static QuadratureRule<2> rule(int along) { return triangle_rule(along); }
};

template <>
struct CellTraits<Tri3> : CommonCellTraits {
  static constexpr ReferenceShape shape = ReferenceShape::Triangle;
  using Corners = Tri3;
  using Plain = Tri3;
  using Sides = SideElements<Line2, Line2, Line2>;
  static constexpr bool constant_strain = true;
  static constexpr std::string_view exodus = "TRI3";
  static constexpr int gmsh = 2;
  static SideNodes side_nodes() { return {{0, 1}, {1, 2}, {2, 0}}; }
};

}  // namespace ixos
