/// The partition of a mesh among the ranks.
#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos {

/// Returns the owning rank of each node: METIS on the nodal graph, balanced by nodes or, if given, by their `work`. One
/// rank owns all when `ranks` is 1. A mesh of fewer nodes than ranks leaves ranks empty. The result is the same on
/// every rank that calls the function.
std::vector<int> partition_nodes(const Mesh& mesh, int ranks, const std::vector<int>& work = {});

/// Returns the work of each node for partition_nodes(): its share of the residual's cells and of the sides of the sets
/// `contact`, after the kernels' measured times, and `solve` units for its part in the linear solve. A hexahedron is 24
/// units.
std::vector<int> node_work(const Mesh& mesh, const std::vector<std::string>& contact, int solve);

}  // namespace ixos
