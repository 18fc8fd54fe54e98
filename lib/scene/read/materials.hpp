/// Materials of a scene.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <vector>

#include "model/model.hpp"
#include "parameters/scene_node.hpp"

namespace ixos {

/// Adds the parameters of a material to a valid list.
void declare_material(Teuchos::ParameterList& list);

/// Returns the materials of the validated list "Materials". Throws InputError with the list path.
std::vector<Material> read_materials(const SceneNode& materials);

}  // namespace ixos
