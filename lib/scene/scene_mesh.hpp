/// The mesh that a scene asks for.
#pragma once
#include <Teuchos_ParameterList.hpp>

#include <string>

#include "mesh/generators/entry.hpp"
#include "units/unit_system.hpp"

namespace ixos {

/// Makes the mesh of a validated "Mesh" list; it has passed check_cells(). Looks for a mesh file in the working folder,
/// then in `scene_folder`. Throws InputError with the list path.
Mesh scene_mesh(Teuchos::ParameterList& list, const std::string& scene_folder);

/// Returns "the mesh spans 30 x 40 L0 = 30 nm x 40 nm" for a mesh that the validated "Mesh" list reads from a file, in
/// which a wrong unit of length shows; an empty text for others.
std::string size_note(const Teuchos::ParameterList& list, const Mesh& mesh, const UnitSystem& units);

/// Returns the catalogue of meshes; its choice is "Type".
const Catalogue<MeshEntry>& meshes();

}  // namespace ixos
