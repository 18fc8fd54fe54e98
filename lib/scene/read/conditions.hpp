/// Boundary conditions and loads of a scene.
#pragma once
#include "model/model.hpp"
#include "scene/read/histories.hpp"
#include "scene/read/interactions.hpp"

namespace ixos {

/// Adds the conditions of the list "Boundary Conditions" to the model. Throws InputError with the list path, on all
/// ranks alike. Collective.
void add_conditions(const SceneNode& conditions, const Histories& histories, Model& model);

/// Throws InputError if the program gives a history that no condition, grip and interaction of the scene names.
void refuse_unused_histories(const SceneNode& scene, const std::vector<SceneInteraction>& interactions,
                             const Histories& histories);

}  // namespace ixos
