/// Faults of a mesh that the format of its file does not show.
#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos {

/// Throws InputError, with both numbers (from 1, over all blocks), if two cells have the same nodes.
void refuse_repeated_cells(const Mesh& mesh);

/// Throws InputError if the set is empty.
void require_sides(const SideSet& set);

/// Throws InputError if the set has a side that two cells share: nothing outside the body can act there.
void require_outer_sides(const Mesh& mesh, const SideSet& set);

/// Throws InputError if the set is empty.
void require_nodes(const NodeSet& set);

/// Returns a warning if nodes stand at one place (within 1e-9 of the mesh's size) without being one node: the body is
/// not connected there. Gives their number and the place of the first. Empty if there are none.
std::string coincident_nodes(const Mesh& mesh);

/// Returns a warning for each part of the mesh, but for the largest one that is held, that shares no side with the rest and either
/// shares some nodes with it (a hinge) or is not held; at most 5. `held` has a flag for each node: a displacement is
/// prescribed there, or an interaction acts.
std::vector<std::string> loose_parts(const Mesh& mesh, const std::vector<bool>& held);

}  // namespace ixos
