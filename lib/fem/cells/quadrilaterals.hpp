/// Quadrilaterals as types of cells.
#pragma once
#include "fem/cell_traits.hpp"
#include "fem/contact_elements.hpp"
#include "fem/quadratic_contact_elements.hpp"
#include "fem/quadratic_elements.hpp"
#include "fem/reference_elements.hpp"

namespace ixos {

struct QuadrilateralTraits : CommonCellTraits {
  static constexpr ReferenceShape shape = ReferenceShape::Quadrilateral;
  using Corners = Quad4;
};

template <>
struct CellTraits<Quad4> : QuadrilateralTraits {
  using Plain = Quad4;
  using Sides = SideElements<Line2, Line2, Line2, Line2>;
  static constexpr std::string_view exodus = "QUAD4";
  static constexpr int gmsh = 3;
  static SideNodes side_nodes() { return {{0, 1}, {1, 2}, {2, 3}, {3, 0}}; }
};

template <>
struct CellTraits<Quad9> : QuadrilateralTraits {
  using Plain = Quad9;
  using Sides = SideElements<LagrangeEdge<2>, LagrangeEdge<2>, LagrangeEdge<2>, LagrangeEdge<2>>;
  static constexpr int order = 2;
  static constexpr std::string_view exodus = "QUAD9";
  static constexpr int gmsh = 10;
  static SideNodes side_nodes() { return {{0, 1, 4}, {1, 2, 5}, {2, 3, 6}, {3, 0, 7}}; }
};

/// A linear quadrilateral whose first side is that edge.
template <class Edge>
struct ContactQuadTraits : QuadrilateralTraits {
  using Plain = Quad4;
  using Sides = SideElements<Edge, Line2, Line2, Line2>;
  static constexpr int contact_side = 0;
  static SideNodes side_nodes() {
    SideNodes sides = CellTraits<Quad4>::side_nodes();
    for (int node = 4; node < Edge::nodes + 2; ++node) sides[0].push_back(node);
    return sides;
  }
};
template <>
struct CellTraits<Quad4C2> : ContactQuadTraits<LagrangeEdge<2>> {
  static constexpr std::string_view contact = "Q1C2";
  static constexpr int pieces = 2;
};
template <>
struct CellTraits<Quad4C3> : ContactQuadTraits<LagrangeEdge<3>> {
  static constexpr std::string_view contact = "Q1C3";
  static constexpr int pieces = 3;
};
template <>
struct CellTraits<Quad4C4> : ContactQuadTraits<LagrangeEdge<4>> {
  static constexpr std::string_view contact = "Q1C4";
  static constexpr int pieces = 4;
};
template <>
struct CellTraits<Quad4CH> : ContactQuadTraits<HermiteEdge> {
  static constexpr std::string_view contact = "Q1CH";
  static constexpr int pieces = 4;
  static constexpr bool hermite = true;
};

template <>
struct CellTraits<Quad9C4> : QuadrilateralTraits {
  using Plain = Quad9;
  using Sides = SideElements<LagrangeEdge<4>, LagrangeEdge<2>, LagrangeEdge<2>, LagrangeEdge<2>>;
  static constexpr int order = 2;
  static constexpr int contact_side = 0;
  static constexpr std::string_view contact = "Q2C4";
  static constexpr int pieces = 2;
  static SideNodes side_nodes() { return {{0, 1, 9, 4, 10}, {1, 2, 5}, {2, 3, 6}, {3, 0, 7}}; }
};

}  // namespace ixos
