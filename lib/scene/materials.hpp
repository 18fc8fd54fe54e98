/// Materials of a scene.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <vector>

#include "model/model.hpp"

namespace ixos {

/// Returns the element formulation of one material's list.
Formulation formulation(const Teuchos::ParameterList& material);

/// Returns the materials of the validated list "Materials".
std::vector<Material> materials(const Teuchos::ParameterList& list);

}  // namespace ixos
