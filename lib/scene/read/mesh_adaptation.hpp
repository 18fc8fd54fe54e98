/// A mesh that follows the front of a scene.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <vector>

#include "adapt/options.hpp"
#include "mesh/mesh.hpp"
#include "parameters/scene_node.hpp"
#include "scene/read/interactions.hpp"

namespace ixos {

/// Adds the list "Adapt" to that of the mesh.
void declare_adaptation(Teuchos::ParameterList& mesh);

/// Returns the settings of a scene's list "Mesh/Adapt". Throws InputError, with the path, for a scene that has what no
/// change of the mesh carries along.
AdaptOptions read_adaptation(const SceneNode& scene, const std::vector<SceneInteraction>& interactions);

/// Throws InputError for settings that the mesh does not allow.
void check_adaptation(const AdaptOptions& options, const std::vector<SceneInteraction>& interactions, const Mesh& mesh);

}  // namespace ixos
