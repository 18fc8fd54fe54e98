/// Interactions of a scene.
#pragma once
#include <Teuchos_ParameterList.hpp>

#include "model/model.hpp"

namespace ixos {

/// Adds every interaction of the validated list "Interactions" to the model. Throws InputError, with the list path, if
/// one does not fit the mesh, or its surface starts in or below the wall. Collective.
void add_interactions(const Teuchos::ParameterList& list, Model& model);

}  // namespace ixos
