/// The cells of a distributed mesh that a rank assembles.
#pragma once
#include <cstddef>
#include <vector>

#include "base/tpetra.hpp"
#include "mesh/distributed_mesh.hpp"
#include "mesh/node_directory.hpp"

namespace ixos {

/// A cell on its way to the ranks that own its nodes.
struct SentCell {
  int block;
  int number;         ///< of the block, over all ranks
  std::size_t first;  ///< place of its first node's id in TouchingCells::nodes
};

/// A side of a set on its way.
struct SentSide {
  int set;
  int block;
  int cell;  ///< its number, see SentCell
  int side;
};

/// Cells in the order of block and number; sides in the order of set, block, cell and side.
struct TouchingCells {
  std::vector<SentCell> cells;
  std::vector<long long> nodes;  ///< ids of the cells' nodes, by SentCell::first
  std::vector<SentSide> sides;
  std::vector<int> global_cells;  ///< by block

  const long long* nodes_of(const SentCell& cell) const { return nodes.data() + cell.first; }
};

/// Returns the cells of all ranks that touch a node which this rank owns, and their sides in side sets. Throws
/// InputError, on all ranks, if a cell has a node that no rank owns, or if two cells have the same corners. Collective.
TouchingCells touching_cells(const DistributedMesh& mesh, const NodeDirectory& directory, const Comm& comm);

}  // namespace ixos
