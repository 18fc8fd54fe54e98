/// Planes of symmetry for which a scene has no condition.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "mesh/cut_planes.hpp"
#include "parameters/scene_node.hpp"

namespace ixos {

/// Returns the first of the cut_planes() of a surface that is within 6 degrees of the obstacle's normal, which has
/// length 1, and on which the scene does not act: no displacement along the axis, grip, load or interaction takes half
/// of the plane's nodes. `scene` is complete; sets that the mesh does not have count for nothing. A plane of two nodes
/// is none.
std::optional<CutPlane> open_cut(const SceneNode& scene, const Mesh& mesh, const SideSet& surface,
                                 const std::vector<int>& parts, const std::array<double, 3>& normal);

}  // namespace ixos
