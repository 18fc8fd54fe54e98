/// Faults of a mesh that the format of its file does not show.
#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos {

/// Throws InputError, with both numbers (from 1, over all blocks), if two cells have the same nodes.
void refuse_repeated_cells(const Mesh& mesh);

/// Throws InputError, with an element and its side (from 1), if a quadrilateral face of a cell has triangles of other
/// cells on its other side: their fields differ there.
void refuse_split_faces(const Mesh& mesh);

/// Throws InputError if the set is empty.
void require_sides(const SideSet& set);

/// Throws InputError if the set has a side that two cells share: nothing outside the body can act there.
void require_outer_sides(const Mesh& mesh, const SideSet& set);

/// Throws InputError if the set is empty.
void require_nodes(const NodeSet& set);

/// Returns a warning if nodes stand at one place (within 1e-9 of the mesh's size) without being one node: the body is
/// not connected there. Gives their number and the place of the first. Empty if there are none.
std::string coincident_nodes(const Mesh& mesh);

/// Returns a warning for each loose part of the mesh, at most 5. A part shares no side with the rest. It is loose if it
/// shares some nodes with the rest (a hinge) or is not held; the largest part that is held counts as the body. `held`
/// has a flag for each node: a displacement is prescribed there, or an interaction acts.
std::vector<std::string> loose_parts(const Mesh& mesh, const std::vector<bool>& held);

}  // namespace ixos
