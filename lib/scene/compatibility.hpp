/// Checks that a scene's settings suit its time integration scheme.
#pragma once
#include <vector>

#include "scene/interactions.hpp"
#include "time/step_control.hpp"
#include "time/table.hpp"

namespace ixos {

/// Throws InputError, with the list path, if the validated scene asks for something that its scheme, as set, does not
/// offer: an adaptive control, a cutoff, an elastic law or an element formulation.
void check_compatibility(const SceneNode& scene, const std::vector<Material>& materials,
                         const std::vector<SceneInteraction>& interactions, const AdaptiveOptions& adaptive,
                         const Table& table);

}  // namespace ixos
