/// Linear and angular momentum of the parts of a body that goes to another mesh.
#pragma once
#include <vector>

#include "mesh/mesh.hpp"
#include "model/model.hpp"
#include "state/state.hpp"

namespace ixos {

/// Adds rigid motions to the velocities v of a model, so that each connected part that is free has the linear and
/// angular momentum that it had in a state of a model on another mesh; of a body of revolution the momentum along its
/// axis. u and v: local arrays. The nodes of parts have the same least numbers in both whole meshes. Collective.
void restore_momenta(const Model& before, const Mesh& mesh_before, const State& state, const Model& after,
                     const Mesh& mesh, const std::vector<double>& u, std::vector<double>& v);

}  // namespace ixos
