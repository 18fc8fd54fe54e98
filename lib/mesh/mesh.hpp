/// A mesh as a generator or a file provides it: whole, in memory, numbered from zero.
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "fem/cell_type.hpp"
#include "fem/enriched_cell.hpp"
#include "mesh/tie.hpp"

namespace ixos {

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
  /// Bit k: edge k of the cells' contact sides, from its k-th corner to the next, is kept as it is: evaluate_tied().
  /// Its inner nodes do not exist; one of its ends stands in their places among the cells' nodes.
  unsigned tied = 0;
  /// Empty, or per cell: the number that the mesh's file gives it. Messages name it beside the number in the block.
  std::vector<long long> file_numbers{};
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

/// Blocks of one name are one body part; enrich() splits them by cell type and by tied edges.
struct Mesh {
  int dimension = 2;
  /// Whether a mesh of two dimensions is the meridian plane of a body of revolution: x >= 0 is the radius, y runs along
  /// the axis. Otherwise it is a body in plane strain.
  bool axisymmetric = false;
  std::vector<double> coordinates;  ///< nodes x dimension, row by row [L0]
  /// Empty, or per node: -1 for a point of the body; otherwise this node stands for a derivative along the boundary at
  /// that node, scaled by half a length: its "coordinates" are those of dX/ds, its displacement that of du/ds; or, with
  /// two such factors, for the mixed derivative along a surface's two directions.
  std::vector<int> derivative_of;
  std::vector<ElementBlock> blocks;
  std::vector<SideSet> side_sets;
  std::vector<NodeSet> node_sets;
  std::vector<Tie> ties;  ///< masters may be tied themselves, see resolved_ties()
  /// Edges of cells with a corner of finer ones in the middle, as both ends and the middle; and sides inside the mesh
  /// that one cell alone has, because its neighbours' are finer or coarser: see refine().
  std::vector<std::array<int, 3>> hanging_edges;
  std::vector<Side> hanging_sides;
  /// Nodes of sides that are tied to others, and nodes of these others. enrich() leaves edges between two of them as
  /// they are: both sides must have the same field along them.
  std::vector<int> nodes_of_tied_sides;

  std::vector<std::string> notes;  ///< what a file holds beside the mesh and Ixos left out, in sentences for the user

  int linear_nodes = -1;  ///< number of nodes before raise_order() appended some; -1: none were added
  int plain_nodes = -1;   ///< number of nodes before enrich() appended some; -1: none were added

  int nodes() const { return static_cast<int>(coordinates.size()) / dimension; }
  /// Returns the dimension of the body: 3 if it is one of revolution.
  int body_dimension() const { return axisymmetric ? 3 : dimension; }
  int cells() const;
  bool is_derivative(int node) const {
    return !derivative_of.empty() && derivative_of[static_cast<std::size_t>(node)] >= 0;
  }
};

}  // namespace ixos
