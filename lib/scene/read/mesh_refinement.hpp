/// Places where a scene's mesh is finer.
#pragma once
#include <Teuchos_ParameterList.hpp>

#include <vector>

#include "mesh/splitting/refine.hpp"
#include "parameters/scene_node.hpp"

namespace ixos {

/// Declares a list of "Refine".
void declare_refinement(Teuchos::ParameterList& list);

/// Returns the regions of a list "Refine", one for each of its lists, named after their paths.
std::vector<NamedRegion> refined_regions(const SceneNode& refine);

}  // namespace ixos
