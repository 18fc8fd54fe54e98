/// Nodes that Ixos adds to a mesh.
#pragma once
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos {

/// Adds a node at the mesh's end and returns its number; `derivative_of` as in Mesh.
int add_node(Mesh& mesh, const std::vector<double>& x, int derivative_of);

/// The nodes that lie between given corners, in quadratic cells also between given middles.
struct Between {
  std::vector<int> corners;
  std::vector<int> nodes;
};

/// Adds the nodes in between to each node set that holds all of their corners.
void complete_node_sets(Mesh& mesh, const std::vector<Between>& added);

}  // namespace ixos
