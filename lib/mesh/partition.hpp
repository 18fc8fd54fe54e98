/// The partition of a mesh among the ranks.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos {

/// Returns the owning rank of each node: METIS on the nodal graph, balanced by nodes or, if given, by their `work`. One
/// rank owns all when `ranks` is 1. A mesh of fewer nodes than ranks leaves ranks empty. The result is the same on
/// every rank that calls the function. `facing`: pairs of nodes that should have one owner. Ranks that hold both sides
/// of a contact share its work; a rank that holds one body would do the work of all points.
std::vector<int> partition_nodes(const Mesh& mesh, int ranks, const std::vector<int>& work = {},
                                 const std::vector<std::pair<int, int>>& facing = {});

/// Returns the work of each node for partition_nodes(): its share of the residual's cells and of the sides of the sets
/// `contact`, after the kernels' measured times, and `solve` units for its part in the linear solve. A hexahedron is 24
/// units. The `facing` sides of other bodies' surfaces have the work of pairs.
std::vector<int> node_work(const Mesh& mesh, const std::vector<std::string>& contact, int solve,
                           const std::vector<Side>& facing = {});

}  // namespace ixos
