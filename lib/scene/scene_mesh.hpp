/// The mesh that a scene asks for.
#pragma once
#include <Teuchos_ParameterList.hpp>

#include "mesh/mesh.hpp"

namespace ixos {

/// From a validated "Mesh" list. Throws InputError with the list path.
Mesh scene_mesh(const Teuchos::ParameterList& list);

}  // namespace ixos
