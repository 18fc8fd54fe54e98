/// Coarser and finer meshes of a scene.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

#include "study/advice/advice_directions.hpp"

namespace ixos {

/// The meshes of a scene, the coarsest first.
struct MeshLevels {
  std::vector<AdviceLevel> levels;  ///< at least that of the scene; sizes are cell lengths over those of the scene
  std::size_t scene_level = 0;
  int dimension = 2;
  std::string note;  ///< why there is one level only; empty if there are more
};

/// Returns the meshes that the generator of a complete scene's list "Mesh" can make, with cells of half and of twice
/// the length. Parts are refined together. If the mesh follows the front, its bounds go with the cells; one without a
/// parameter that refines it has levels with more and fewer halvings.
MeshLevels mesh_levels(const Teuchos::ParameterList& mesh);

}  // namespace ixos
