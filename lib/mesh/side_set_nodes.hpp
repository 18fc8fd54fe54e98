/// Nodes of side sets, and node sets that have just these.
#pragma once
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos {

/// Returns the nodes of a set's sides.
std::set<int> nodes_of(const Mesh& mesh, const SideSet& set);

/// The numbers of a node set and of a side set.
using SetPairs = std::vector<std::pair<std::size_t, std::size_t>>;

/// Returns the node sets that have the nodes of the side set of their name, and that side set.
SetPairs sets_of_sides(const Mesh& mesh);

/// Gives these node sets the nodes that their side sets have now.
void renew_sets_of_sides(Mesh& mesh, const SetPairs& pairs);

}  // namespace ixos
