/// Checks that a scene's settings suit its time integration scheme.
#pragma once
#include <vector>

#include "scene/read/interactions.hpp"
#include "time/step_control.hpp"
#include "time/table.hpp"

namespace ixos {

/// Throws InputError, with the list path, if the validated scene asks for something that its scheme, as set, does not
/// offer: an adaptive control, an elastic law or an element formulation; or for an adaptive control by gaps if its laws
/// do not bound the gaps.
void check_compatibility(const SceneNode& scene, const std::vector<Material>& materials,
                         const std::vector<SceneInteraction>& interactions, const AdaptiveOptions& adaptive,
                         const Table& table);

}  // namespace ixos
