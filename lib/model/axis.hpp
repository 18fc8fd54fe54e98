/// The axis of bodies of revolution.
#pragma once
#include "mesh/local_mesh.hpp"
#include "term/support/constraints.hpp"

namespace ixos {

/// Holds the radial displacement of the nodes on the axis of an axisymmetric mesh; changes nothing for other meshes. A
/// material point of the axis stays on it.
void hold_axis(const LocalMesh& mesh, Constraints& constraints);

}  // namespace ixos
