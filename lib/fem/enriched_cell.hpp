/// Factors and ties of the nodes of enriched cells. `Block` is a block of a mesh: it has `type`, `derivative_scale` and
/// `tied`, see ElementBlock.
#pragma once
#include <cstddef>
#include <vector>

#include "fem/cell_type.hpp"

namespace ixos {

/// Returns the factor of the shape function of node `a` in the cell: 1, or its entry in `derivative_scale`.
template <class Block>
double node_scale(const Block& block, int cell, int a) {
  const int corners = nodes_per_cell(corner_type(block.type));
  if (block.derivative_scale.empty() || a < corners) return 1.0;
  return block.derivative_scale[cell_entry(cell, nodes_per_cell(block.type) - corners, a - corners)];
}

/// Returns the factor of node `a` of a side in the side's own element. The edge that a hexahedron's side 2 or 3 shares
/// with the contact side runs against that side's coordinate, and so does the derivative along it.
template <class Block>
double side_node_scale(const Block& block, int cell, int side, std::size_t a) {
  const int node = side_nodes(block.type, side)[a];
  const double scale = node_scale(block, cell, node);
  return block.type == CellType::Hex8CH && node >= 8 && (side == 2 || side == 3) ? -scale : scale;
}

/// Returns the tied edges of a side of the block's cells, as its own element counts them.
template <class Block>
unsigned side_ties(const Block& block, int side) {
  if (block.tied == 0 || side > contact_side(block.type)) return 0;
  // The sides 0 to 3 share the edges 3 to 0 of the bottom, which is seen from outside.
  return side == contact_side(block.type) ? block.tied : block.tied >> (3 - side) & 1U;
}

}  // namespace ixos
