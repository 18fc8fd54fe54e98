/// Bodies that a static scene does not hold.
#pragma once
#include <string>
#include <vector>

#include "base/warning.hpp"
#include "mesh/mesh.hpp"
#include "parameters/scene_node.hpp"
#include "scene/read/interactions.hpp"

namespace ixos {

/// The name of the warnings of missing_supports().
constexpr const char* support_warning = "support";

/// Returns a warning for each body, a connected part of the mesh, that has a rigid motion which nothing holds (see
/// free_motions()), at most 5. Prescribed displacements and rigid grips hold their directions, springs those in which
/// they have a stiffness, an interaction the normals of its obstacle at the surface's nodes, with friction all
/// directions. An interaction of two bodies holds each of them along the normals of both surfaces, and leaves what both
/// can do together. Interactions count as if they acted, whatever the gap: so a motion that is found is free for
/// certain. For Static, where the tangent is then singular. `scene` is validated; `mesh` is whole, has the sets, and
/// may be enriched. `parts`: see connected_parts().
std::vector<Warning> missing_supports(const SceneNode& scene, const std::vector<SceneInteraction>& interactions,
                                      const Mesh& mesh, const std::vector<int>& parts);

}  // namespace ixos
