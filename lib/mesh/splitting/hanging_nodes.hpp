/// Nodes of fine cells on the edges and faces of coarse ones.
#pragma once
#include <array>
#include <vector>

#include "mesh/splitting/cell_tree.hpp"
#include "mesh/tie.hpp"

namespace ixos {

/// The ties that make the displacements of a tree's leaves continuous.
struct HangingNodes {
  std::vector<Tie> ties;  ///< masters may be tied themselves
  /// Edges of coarse leaves whose middle is a corner of fine ones: both ends and the middle.
  std::vector<std::array<int, 3>> edges;
};

/// Finds the hanging nodes of cells of that order, 1 or 2. A node in the middle of a coarse edge or face takes the mean
/// of its corners, a node of quadratic cells at quarters the quadratic function there. For order 2 the leaves' middles
/// must all be in the tree.
HangingNodes find_hanging_nodes(CellTree& tree, int order);

}  // namespace ixos
