/// The mesh that a scene asks for.
#pragma once
#include <Teuchos_ParameterList.hpp>

#include <string>

#include "mesh/generators/entry.hpp"

namespace ixos {

/// Makes the mesh of a validated "Mesh" list; it has passed check_cells(). Looks for a mesh file in the working folder,
/// then in `scene_folder`. Throws InputError with the list path.
Mesh scene_mesh(Teuchos::ParameterList& list, const std::string& scene_folder);

/// Completes a mesh that a program provides: adds the sets of a validated "Mesh" list. The mesh has passed
/// check_arrays() and check_cells(). Throws InputError with the list path.
Mesh scene_mesh(const Teuchos::ParameterList& list, Mesh given);

/// Returns the user's scene with "Given" as its mesh, of that dimension, in place of any other; its "Mesh/Sets" stay.
Teuchos::ParameterList with_given_mesh(const Teuchos::ParameterList& scene, int dimension);

/// Returns the catalogue of meshes; its choice is "Type".
const Catalogue<MeshEntry>& meshes();

}  // namespace ixos
