/// A mesh that a program has distributed over its ranks.
#pragma once
#include <string>
#include <vector>

#include "base/tpetra.hpp"
#include "mesh/local_mesh.hpp"

namespace ixos {

/// This rank's cells of one material: quadrilaterals in two dimensions, hexahedra in three.
struct DistributedBlock {
  std::string name;
  std::vector<long long> nodes;  ///< cells x nodes per cell, ids of nodes of any rank, row by row, in Exodus order
};

struct DistributedNodeSet {
  std::string name;
  std::vector<long long> nodes;  ///< ids of nodes of any rank
};

/// The share of one rank in a mesh: the nodes that it owns, and some cells. An id is any number from 0 on; ids need not
/// be consecutive, nor in order. One rank owns a node, and one rank has a cell, usually the owner of one of its nodes.
/// No ghosts are given. All ranks list the same blocks and sets in the same order, with no cells or nodes where they
/// have none. With a Tpetra map of the nodes, `nodes` is a copy of its getNodeElementList().
struct DistributedMesh {
  int dimension = 2;
  /// Order of all cells, equal on all ranks. 1: linear ones, of 4 nodes, in three dimensions 8; 2: quadratic ones, of 9
  /// or 27. The ranks own and number the nodes in the middle of edges, faces and cells as any others.
  int order = 1;
  bool axisymmetric = false;        ///< see Mesh; equal on all ranks
  std::vector<long long> nodes;     ///< ids of the nodes that this rank owns
  std::vector<double> coordinates;  ///< of these nodes, nodes x dimension, row by row [L0]
  std::vector<DistributedBlock> blocks;
  std::vector<SideSet> side_sets;  ///< sides of this rank's cells: index of the block, of the cell here, of the side
  /// A node belongs to a set if any rank lists it there. It may be listed several times, and belongs to the set once.
  std::vector<DistributedNodeSet> node_sets;
};

/// Returns this rank's part of the mesh. The ranks own what they own in `mesh`: its k-th node is the k-th local node.
/// Cells that touch a node of another rank are sent there, and the ghosts' ids and coordinates are fetched. The
/// original_ids follow the order of the ids, so that they do not depend on the distribution; original_cells follow the
/// order of ranks. Throws InputError, on all ranks, with the block, set or node and what is allowed: unless the arrays
/// fit each other as check_arrays() demands, every id belongs to a node of some rank, no two nodes have one id, no two
/// cells have the same corners, quadratic cells share the middles of the edges and faces that they share, and no cell
/// is inverted. Collective.
LocalMesh local_part(const DistributedMesh& mesh, const Comm& comm);

/// Returns the type of the mesh's cells.
CellType cell_type(const DistributedMesh& mesh);

}  // namespace ixos
