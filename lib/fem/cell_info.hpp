/// All that is known of a type of cell, from its element type.
#pragma once
#include <string_view>
#include <vector>

#include "fem/cell_traits.hpp"
#include "fem/cell_type.hpp"

namespace ixos {

/// See CommonCellTraits.
struct CellInfo {
  CellType type;
  std::string_view name;  ///< of the element type
  ReferenceShape shape;
  int dimension, nodes, order;
  CellType corners, plain;  ///< see corner_type(), plain_type()
  CellType drawn;           ///< as which files have it: the type of its first nodes
  bool bubbles;
  std::vector<NodeCorners> node_corners;  ///< by node of a cell without an enriched side; else empty
  SideNodes sides;
  int contact_side;
  std::string_view contact;
  int pieces;
  bool hermite, constant_strain;
  std::string_view exodus;
  int gmsh;
};

/// Throws std::out_of_range for a number that is no type.
const CellInfo& cell_info(CellType type);
/// Returns those of all types, in the order of CellType.
const std::vector<CellInfo>& cell_infos();

/// Return the first type for which the condition holds, null if there is none.
template <class Condition>
const CellInfo* find_cell(const Condition& condition) {
  for (const CellInfo& info : cell_infos())
    if (condition(info)) return &info;
  return nullptr;
}
/// Returns the quadrilateral or hexahedron of an order, 1 or 2, without an enriched side: Quad4, Hex8, Quad9 or Hex27.
CellType cube_type(int dimension, int order = 1);
/// Returns the type without an enriched side that has this number of nodes, which is one; null if there is none.
const CellInfo* cell_with(int dimension, int nodes);
/// Returns whether a type is a quadrilateral or a hexahedron, with or without an enriched side.
bool is_cube(CellType type);
/// Returns the type of second order on the corners of a cell without an enriched side: with `bubbles` Tri7, Tet15,
/// Prism21 or Pyr19 in place of Tri6, Tet10, Prism18 or Pyr14.
CellType raised_type(CellType type, bool bubbles);

}  // namespace ixos
