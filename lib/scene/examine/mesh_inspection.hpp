/// Checks that a mesh has what its scene uses.
#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "parameters/scene_node.hpp"

namespace ixos {

/// Throws InputError, with the list path, if an interaction or a traction acts on no side or on a side inside the body,
/// or a displacement or a point force on no node. Returns warnings about a mesh that was read from a file: coincident
/// nodes, loose parts. `scene` is complete; names of sets that the mesh does not have are left to who looks them up.
std::vector<std::string> inspect_mesh(const SceneNode& scene, const Mesh& mesh);

}  // namespace ixos
