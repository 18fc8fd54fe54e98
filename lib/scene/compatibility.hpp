/// Checks that a scene's settings suit its time integration scheme.
#pragma once
#include <Teuchos_ParameterList.hpp>

#include "scene/step_control.hpp"
#include "time/table.hpp"

namespace ixos {

/// Throws InputError, with the list path, if the validated scene asks for something that its scheme, as set, does not
/// offer: an adaptive control, a cutoff or an element formulation.
void check_compatibility(const Teuchos::ParameterList& scene, const AdaptiveOptions& adaptive, const Table& table);

}  // namespace ixos
