/// Linear and angular momentum of the parts of a body that goes to another mesh.
#pragma once
#include <vector>

#include "mesh/mesh.hpp"
#include "model/model.hpp"
#include "state/state.hpp"

namespace ixos {

/// Adds rigid motions to the velocities v of a model, so that each connected part has the linear and angular momentum
/// that it had in a state of a model on another mesh, as far as its supports allow such motions; of a body of
/// revolution the momentum along its axis. u and v: local arrays. A part is known by its first node, which both whole
/// meshes must have. Collective.
void restore_momenta(const Model& before, const Mesh& mesh_before, const State& state, const Model& after,
                     const Mesh& mesh, const std::vector<double>& u, std::vector<double>& v);

}  // namespace ixos
