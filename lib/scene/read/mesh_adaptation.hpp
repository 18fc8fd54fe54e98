/// A mesh that follows the front of a scene.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <vector>

#include "adapt/options.hpp"
#include "model/material.hpp"
#include "parameters/scene_node.hpp"
#include "scene/read/interactions.hpp"

namespace ixos {

/// Adds the list "Adapt" to that of the mesh.
void declare_adaptation(Teuchos::ParameterList& mesh);

/// Returns the settings of a scene's list "Mesh/Adapt". Throws InputError, with the path, for a scene that has what no
/// change of the mesh carries along.
AdaptOptions read_adaptation(const SceneNode& scene, const std::vector<Material>& materials,
                             const std::vector<SceneInteraction>& interactions);

}  // namespace ixos
