/// Which rank owns what of a mesh.
#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos {

/// Which rank owns each node: METIS on the nodal graph, balanced by nodes or, where given, by their `work`. One rank
/// owns all when `ranks` is 1. A mesh of fewer nodes than ranks leaves ranks empty. The same on every rank that asks.
std::vector<int> partition_nodes(const Mesh& mesh, int ranks, const std::vector<int>& work = {});

/// The work of each node for partition_nodes(): its share of the residual's cells and of the sides of the sets
/// `contact`, after the kernels' measured times, and `solve` units for its part in the linear solve. A hexahedron is
/// 24 units.
std::vector<int> node_work(const Mesh& mesh, const std::vector<std::string>& contact, int solve);

}  // namespace ixos
