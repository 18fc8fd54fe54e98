/// Loads and initial velocities of the rigid bodies of a scene.
#pragma once
#include <vector>

#include "model/model.hpp"
#include "parameters/scene_node.hpp"
#include "scene/read/histories.hpp"

namespace ixos {

/// Adds the loads on the bodies of the list "Rigid Bodies", their springs and dashpots, and what histories move, to the
/// model. Throws InputError with the list path, on all ranks alike.
void add_rigid_body_loads(const SceneNode& bodies, const Histories& histories, Model& model);

/// Sets the bodies' numbers in the initial velocities, a local array. Throws InputError with the list path.
void set_rigid_body_velocities(const SceneNode& bodies, const Model& model, std::vector<double>& velocities);

}  // namespace ixos
