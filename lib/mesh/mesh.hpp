/// A mesh as a generator or a file provides it: whole, in memory, numbered from zero.
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace ixos {

/// Quad4Cq, Quad4CH, Hex8Cq and Hex8CH are quadrilaterals and hexahedra with an enriched contact side (see
/// fem/contact_elements.hpp and fem/contact_hexahedra.hpp): nodes as of Quad4 or Hex8, then the other nodes of that
/// side.
enum class CellType { Quad4, Hex8, Quad4C2, Quad4C3, Quad4C4, Quad4CH, Hex8C2, Hex8C3, Hex8C4, Hex8CH };

int nodes_per_cell(CellType type);
int sides_per_cell(CellType type);
/// Returns the type of the cell without its enrichment: Quad4 or Hex8.
CellType plain_type(CellType type);
/// Returns the enriched side: side 0 of quadrilaterals, side 4 (the bottom) of hexahedra; -1 for plain cells.
int contact_side(CellType type);
/// Returns whether the other nodes of the contact side are derivatives: true for Quad4CH and Hex8CH.
bool is_hermite(CellType type);

/// Returns the position of node `a` of a cell in a table of cells x nodes per cell.
inline std::size_t cell_entry(int cell, int nodes_per_cell, int a = 0) {
  return static_cast<std::size_t>(cell) * static_cast<std::size_t>(nodes_per_cell) + static_cast<std::size_t>(a);
}

/// Returns the local node numbers of side `side` (from 0), in the order of the Exodus standard: seen from outside,
/// counter-clockwise. Two nodes for a quadrilateral, four for a hexahedron; an enriched side adds its other nodes. The
/// sides of an enriched hexahedron that share an edge with its contact side begin with that edge.
const std::vector<int>& side_nodes(CellType type, int side);

/// Cells of one type and one material.
struct ElementBlock {
  std::string name;
  CellType type = CellType::Quad4;
  std::vector<int> nodes;  ///< cells x nodes per cell, row by row, in Exodus order
  /// Hermite cells only, cells x their 2 or 12 derivative nodes: the factor of each node's shape function, the side's
  /// length over the length that scales the node's derivative. On a face it is negative if its direction is the
  /// opposite; for the mixed derivative it is a product.
  std::vector<double> derivative_scale{};
  int points = 0;  ///< Gauss points along an enriched side; 0: the element's own
  /// Bit k: edge k of the cells' contact sides, from its k-th corner to the next, is kept straight: evaluate_tied().
  /// Its inner nodes do not exist; one of its ends stands in their places among the cells' nodes.
  unsigned tied = 0;
  int cells() const { return static_cast<int>(nodes.size()) / nodes_per_cell(type); }
};

/// Returns the factor of the shape function of node `a` in the cell: 1, or its entry in `derivative_scale`. `Block` is
/// an ElementBlock or a LocalBlock.
template <class Block>
double node_scale(const Block& block, int cell, int a) {
  const int corners = nodes_per_cell(plain_type(block.type));
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

/// Returns the tied edges of a side of the block's cells, as its own element counts them. `Block` as above.
template <class Block>
unsigned side_ties(const Block& block, int side) {
  if (block.tied == 0 || side > contact_side(block.type)) return 0;
  // The sides 0 to 3 share the edges 3 to 0 of the bottom, which is seen from outside.
  return side == contact_side(block.type) ? block.tied : block.tied >> (3 - side) & 1U;
}

struct Side {
  int block;  ///< index of the block
  int cell;   ///< index within the block
  int side;   ///< index of the side within the cell, from 0
};

struct SideSet {
  std::string name;
  std::vector<Side> sides;
};

struct NodeSet {
  std::string name;
  std::vector<int> nodes;
};

/// Blocks of one name are one body part; enrich() splits them by cell type and by tied edges.
struct Mesh {
  int dimension = 2;
  std::vector<double> coordinates;  ///< nodes x dimension, row by row [L0]
  /// Empty, or per node: -1 for a point of the body; otherwise this node stands for a derivative along the boundary at
  /// that node, scaled by half a length: its "coordinates" are those of dX/ds, its displacement that of du/ds; or, with
  /// two such factors, for the mixed derivative along a surface's two directions.
  std::vector<int> derivative_of;
  std::vector<ElementBlock> blocks;
  std::vector<SideSet> side_sets;
  std::vector<NodeSet> node_sets;

  int plain_nodes = -1;  ///< number of nodes before enrich() appended some; -1: none were added

  int nodes() const { return static_cast<int>(coordinates.size()) / dimension; }
  int cells() const;
  bool is_derivative(int node) const {
    return !derivative_of.empty() && derivative_of[static_cast<std::size_t>(node)] >= 0;
  }
};

}  // namespace ixos
