/// Corners of finer quadratic cells in the middle of edges and faces of coarser ones.
#pragma once
#include <map>
#include <vector>

#include "discretization/dof_space.hpp"
#include "mesh/local_mesh.hpp"

namespace ixos {

/// Returns the local nodes that linear displacements of the coarser cells move by the mean of others, its corners
/// there: by node, those corners, which hang nowhere themselves. Corners whose coarser edge or face has hanging corners
/// are left out. The ties of the quadratic cells' nodes tell which they are. `corner`: by local node, whether it is one
/// of a local cell. The ranks agree. Throws std::logic_error if a rank lacks the nodes of one. Collective.
std::map<int, std::vector<int>> hanging_corners(const LocalMesh& mesh, const DofSpace& space,
                                                const std::vector<char>& corner);

}  // namespace ixos
