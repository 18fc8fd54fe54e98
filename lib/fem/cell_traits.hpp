/// Traits of element types as types of cells.
#pragma once
#include <array>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

namespace ixos {

/// The body on which an element's coordinates live.
enum class ReferenceShape {
  Triangle,       ///< xi, eta >= 0, xi + eta <= 1
  Quadrilateral,  ///< [-1, 1]^2
  Tetrahedron,    ///< xi, eta, zeta >= 0, xi + eta + zeta <= 1
  Pyramid,        ///< |xi|, |eta| <= 1 - zeta, zeta >= 0
  Prism,          ///< xi, eta >= 0, xi + eta <= 1, -1 <= zeta <= 1
  Hexahedron      ///< [-1, 1]^3
};

/// Returns whether a point is in the reference shape, or beyond it by no more than `slack`. False for NaN.
template <ReferenceShape shape, std::size_t D>
bool is_inside(const std::array<double, D>& xi, double slack) {
  const auto between = [&](double low, double x, double high) { return x >= low - slack && x <= high + slack; };
  if constexpr (shape == ReferenceShape::Triangle)
    return xi[0] >= -slack && xi[1] >= -slack && xi[0] + xi[1] <= 1 + slack;
  else if constexpr (shape == ReferenceShape::Tetrahedron)
    return xi[0] >= -slack && xi[1] >= -slack && xi[2] >= -slack && xi[0] + xi[1] + xi[2] <= 1 + slack;
  else if constexpr (shape == ReferenceShape::Prism)
    return xi[0] >= -slack && xi[1] >= -slack && xi[0] + xi[1] <= 1 + slack && between(-1, xi[2], 1);
  else if constexpr (shape == ReferenceShape::Pyramid)
    return xi[2] >= -slack && between(-(1 - xi[2]), xi[0], 1 - xi[2]) && between(-(1 - xi[2]), xi[1], 1 - xi[2]);
  for (double coordinate : xi)
    if (!between(-1, coordinate, 1)) return false;
  return true;
}

/// A type as a value.
template <class T>
struct TypeTag {
  using type = T;
};

/// The element types of the sides, in their order.
template <class... Sides>
using SideElements = std::tuple<TypeTag<Sides>...>;

/// Local node numbers of the sides, see side_nodes().
using SideNodes = std::vector<std::vector<int>>;

/// The corners of a cell in whose middle a node stands: itself, or those of an edge, a face or the cell.
using NodeCorners = std::vector<int>;

/// The traits that most elements share. The specialisation of CellTraits for an element type derives from it and has
/// - `shape`;
/// - `Corners`, the linear element of its corners, and `Plain`, that of the same order without an enriched side;
/// - `Sides`, a SideElements, and side_nodes();
/// - `Drawn`, the type as which files have it, if that is not Plain.
struct CommonCellTraits {
  static constexpr int order = 1;                 ///< without the enriched side: 1 or 2
  static constexpr int contact_side = -1;         ///< the enriched side; -1: none
  static constexpr std::string_view contact{};    ///< name of the enriched side's contact element, such as "Q1C2"
  static constexpr bool bubbles = false;          ///< quadratic, with nodes in triangles and inside, Tri7 for example
  static constexpr int pieces = 1;                ///< into which a picture cuts it along each direction of that side
  static constexpr bool constant_strain = false;  ///< J is constant: Mean Dilatation changes nothing
  static constexpr bool hermite = false;          ///< whether that side's other nodes are derivatives
  static constexpr std::string_view exodus{};     ///< name of the topology in Exodus files; empty: never written
  static constexpr int gmsh = 0;                  ///< number of the type in gmsh's files; 0: never read
};

template <class Element>
struct CellTraits;

/// Whether the element, or the section of the ring, is that of a cell type with is_quadratic().
template <class Element>
constexpr bool is_quadratic_element = CellTraits<Element>::order == 2;

/// Whether there is a formulation with mean dilatation: of order 0 for linear quadrilaterals and hexahedra, of order 1
/// for quadratic cells with enough nodes inside. The volume of linear simplices is constant in a cell; quadratic ones
/// without bubbles have fewer displacements than its pressures would need.
template <class Element>
constexpr bool has_dilatation =
    CellTraits<Element>::bubbles || CellTraits<Element>::shape == ReferenceShape::Quadrilateral ||
    CellTraits<Element>::shape == ReferenceShape::Hexahedron;

/// The type as which files have a cell: its nodes are the first ones of the cell's.
template <class Element, class = void>
struct DrawnAs {
  using type = typename CellTraits<Element>::Plain;
};
template <class Element>
struct DrawnAs<Element, std::void_t<typename CellTraits<Element>::Drawn>> {
  using type = typename CellTraits<Element>::Drawn;
};

}  // namespace ixos
