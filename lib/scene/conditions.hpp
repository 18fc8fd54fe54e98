/// Boundary conditions and loads of a scene.
#pragma once
#include "model/model.hpp"
#include "scene/histories.hpp"

namespace ixos {

/// Adds the conditions of the list "Boundary Conditions" to the model. Throws InputError with the list path, on all
/// ranks alike; also if the program gives a history that no condition names. Collective.
void add_conditions(const SceneNode& conditions, const Histories& histories, Model& model);

}  // namespace ixos
