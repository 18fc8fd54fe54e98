/// What does not go with a scene's time integration scheme.
#pragma once
#include <Teuchos_ParameterList.hpp>

#include "scene/step_control.hpp"
#include "time/table.hpp"

namespace ixos {

/// Throws InputError, with the list path, where the validated scene asks for what its scheme, as it is set, has not:
/// an adaptive control, a cutoff or an element formulation.
void check_compatibility(const Teuchos::ParameterList& scene, const AdaptiveOptions& adaptive, const Table& table);

}  // namespace ixos
