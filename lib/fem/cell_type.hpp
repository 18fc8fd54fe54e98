/// The types of cells: their nodes and sides.
#pragma once
#include <cstddef>
#include <vector>

namespace ixos {

/// Quad4Cq, Quad4CH, Hex8Cq and Hex8CH are quadrilaterals and hexahedra with an enriched contact side (see
/// fem/contact_elements.hpp and fem/contact_hexahedra.hpp): nodes as of Quad4 or Hex8, then the other nodes of that
/// side. Quad9 and Hex27 are of second order in each direction (see fem/quadratic_elements.hpp); Quad9C4 and Hex27C4
/// are such cells with a contact side of fourth order (see fem/quadratic_contact_elements.hpp). The corners come first
/// in every type. fem/cells.def is the list, cell_info() has all that is known of a type.
enum class CellType {
#define IXOS_CELL(Element) Element,
#include "fem/cells.def"
};

int nodes_per_cell(CellType type);
int sides_per_cell(CellType type);
/// Returns the linear type of the cell's corners, such as Quad4 or Hex8.
CellType corner_type(CellType type);
/// Returns the type of the same order without an enriched side, such as Quad4, Hex8, Quad9 or Hex27. Its nodes are the
/// first ones of the cell's.
CellType plain_type(CellType type);
/// Returns whether the cell is of second order, in each direction, but for an enriched side: true for Quad9, Hex27,
/// Quad9C4 and Hex27C4.
bool is_quadratic(CellType type);
/// Returns whether one side of the cell is richer than the others.
bool is_enriched(CellType type);
/// Returns the enriched side: side 0 of quadrilaterals, side 4 (the bottom) of hexahedra; -1 for other cells.
int contact_side(CellType type);
/// Returns whether the other nodes of the contact side are derivatives: true for Quad4CH and Hex8CH.
bool is_hermite(CellType type);

/// Returns the position of node `a` of a cell in a table of cells x nodes per cell.
inline std::size_t cell_entry(int cell, int nodes_per_cell, int a = 0) {
  return static_cast<std::size_t>(cell) * static_cast<std::size_t>(nodes_per_cell) + static_cast<std::size_t>(a);
}

/// Returns the local node numbers of side `side` (from 0), in the order of the Exodus standard: seen from outside,
/// counter-clockwise. Two nodes for a quadrilateral, four for a hexahedron; an enriched side adds its other nodes, a
/// quadratic one the middles of its edges and its own middle. The sides of an enriched hexahedron that share an edge
/// with its contact side begin with that edge.
const std::vector<int>& side_nodes(CellType type, int side);

}  // namespace ixos
