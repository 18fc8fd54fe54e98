/// The mesh that a scene asks for.
#pragma once
#include <Teuchos_ParameterList.hpp>

#include <string>

#include "mesh/generators/entry.hpp"

namespace ixos {

/// Makes the mesh of a validated "Mesh" list; it has passed check_cells(). Looks for a mesh file in the working folder,
/// then in `scene_folder`. Throws InputError with the list path.
Mesh scene_mesh(Teuchos::ParameterList& list, const std::string& scene_folder);

/// Returns the catalogue of meshes; its choice is "Type".
const Catalogue<MeshEntry>& meshes();

}  // namespace ixos
