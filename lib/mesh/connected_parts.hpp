/// The bodies of a mesh.
#pragma once
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos {

/// Returns, by node, the number of its connected part: cells that share a node are in one part, whatever their blocks.
/// The number is that of the part's first node; a node without a cell is a part alone.
std::vector<int> connected_parts(const Mesh& mesh);

}  // namespace ixos
