/// Traits of element types as types of cells.
#pragma once
#include <array>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <vector>

namespace ixos {

/// The body on which an element's coordinates live.
enum class ReferenceShape {
  Triangle,       ///< xi, eta >= 0, xi + eta <= 1
  Quadrilateral,  ///< [-1, 1]^2
  Hexahedron      ///< [-1, 1]^3
};

/// Returns whether a point is in the reference shape, or beyond it by no more than `slack`. False for NaN.
template <ReferenceShape shape, std::size_t D>
bool is_inside(const std::array<double, D>& xi, double slack) {
  static_assert(shape == ReferenceShape::Triangle || shape == ReferenceShape::Quadrilateral ||
                shape == ReferenceShape::Hexahedron);
  if constexpr (shape == ReferenceShape::Triangle)
    return xi[0] >= -slack && xi[1] >= -slack && xi[0] + xi[1] <= 1 + slack;
  for (double coordinate : xi)
    if (!(coordinate >= -1 - slack && coordinate <= 1 + slack)) return false;
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

/// The traits that most elements share. The specialisation of CellTraits for an element type derives from it and has
/// - `shape`;
/// - `Corners`, the linear element of its corners, and `Plain`, that of the same order without an enriched side;
/// - `Sides`, a SideElements, and side_nodes().
struct CommonCellTraits {
  static constexpr int order = 1;                 ///< without the enriched side: 1 or 2
  static constexpr int contact_side = -1;         ///< the enriched side; -1: none
  static constexpr std::string_view contact{};    ///< name of the enriched side's contact element, such as "Q1C2"
  static constexpr int pieces = 1;                ///< into which a picture cuts it along each direction of that side
  static constexpr bool constant_strain = false;  ///< J is constant: Mean Dilatation changes nothing
  static constexpr bool hermite = false;          ///< whether that side's other nodes are derivatives
  static constexpr std::string_view exodus{};     ///< name of the topology in Exodus files; empty: never written
  static constexpr int gmsh = 0;                  ///< number of the type in gmsh's files; 0: never read
};

template <class Element>
struct CellTraits;

}  // namespace ixos
