/// Checks that a scene's settings suit its time integration scheme.
#pragma once
#include <vector>

#include "model/model.hpp"
#include "scene/interactions.hpp"
#include "time/step_control.hpp"
#include "time/table.hpp"

namespace ixos {

/// Throws InputError, with the list path, if the validated scene asks for something that its scheme, as set, does not
/// offer: an adaptive control, an elastic law or an element formulation; or for an adaptive control by gaps if its laws
/// do not bound the gaps.
void check_compatibility(const SceneNode& scene, const std::vector<Material>& materials,
                         const std::vector<SceneInteraction>& interactions, const AdaptiveOptions& adaptive,
                         const Table& table);

/// Throws InputError, with the list path, if an interaction of the model has a cutoff and the scheme takes an exact
/// mean that must have a potential: a law with a cutoff has none (see CutOff).
void check_cutoffs(const std::vector<SceneInteraction>& interactions, const Model& model, const Table& table);

}  // namespace ixos
