/// A mesh as a generator or a file gives it: whole, in memory, numbered from zero.
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace ixos {

enum class CellType { Quad4, Hex8 };

int nodes_per_cell(CellType type);
int sides_per_cell(CellType type);

/// Where node `a` of a cell stands in a table of cells x nodes per cell.
inline std::size_t cell_entry(int cell, int nodes_per_cell, int a = 0) {
  return static_cast<std::size_t>(cell) * static_cast<std::size_t>(nodes_per_cell) + static_cast<std::size_t>(a);
}

/// The local node numbers of side `side` (from 0), in the order of the Exodus standard: seen from outside, counter-
/// clockwise. Two nodes for a quadrilateral, four for a hexahedron.
const std::vector<int>& side_nodes(CellType type, int side);

/// Cells of one type and one material.
struct ElementBlock {
  std::string name;
  CellType type = CellType::Quad4;
  std::vector<int> nodes;  ///< cells x nodes per cell, row by row, in Exodus order
  int cells() const { return static_cast<int>(nodes.size()) / nodes_per_cell(type); }
};

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

struct Mesh {
  int dimension = 2;
  std::vector<double> coordinates;  ///< nodes x dimension, row by row [L0]
  std::vector<ElementBlock> blocks;
  std::vector<SideSet> side_sets;
  std::vector<NodeSet> node_sets;

  int nodes() const { return static_cast<int>(coordinates.size()) / dimension; }
  int cells() const;
};

}  // namespace ixos
