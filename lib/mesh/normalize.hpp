/// Meshes of files, brought into the form that Ixos computes with.
#pragma once
#include "mesh/mesh.hpp"

namespace ixos {

/// Removes the nodes that no cell has, from node sets too, and leaves a note of their number if there are any. Returns
/// the old number of each node.
std::vector<int> drop_unused_nodes(Mesh& mesh);

/// Turns a mesh of Quad4 or Quad9 cells with three coordinates into one of two dimensions. Throws InputError, with the
/// place of a node, if the mesh does not lie in the plane z = 0 (to 1e-9 of its size).
void flatten(Mesh& mesh);

}  // namespace ixos
