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
/// Returns that one with this number of nodes; null if there is none.
const CellInfo* cube_with(int dimension, int nodes);

}  // namespace ixos
