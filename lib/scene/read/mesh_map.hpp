/// Nodes moved by formulas.
#pragma once
#include <Teuchos_ParameterList.hpp>

#include "mesh/mesh.hpp"
#include "parameters/scene_node.hpp"

namespace ixos {

/// Declares the list "Map" of a mesh.
void declare_map(Teuchos::ParameterList& map);

/// Moves each node to the place that the expressions of a list "Map" give for its own. Throws InputError, with the list
/// path, for an expression that cannot be read, the third one on a mesh of two dimensions, and the first node whose
/// place is not finite. It does not check the cells.
void map_nodes(const SceneNode& map, Mesh& mesh);

}  // namespace ixos
