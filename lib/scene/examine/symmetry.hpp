/// Properties of a scene's tangents on which its linear solver depends.
#pragma once
#include <string>
#include <vector>

#include "model/model.hpp"
#include "parameters/scene_node.hpp"
#include "time/table.hpp"

namespace ixos {

/// Returns what makes the tangents of the stages unsymmetric, in words: "the discrete gradient of the scheme
/// "Energy-Momentum"", "the exact mean before the curved obstacle of Interactions/Wall". Returns an empty string if the
/// tangents of all stages are symmetric.
std::string asymmetry(const SceneNode& scene, const std::vector<Material>& materials, const Model& model,
                      const Table& table);

/// Returns the first entry of a material because of which tangents cannot be applied without a matrix:
/// "Materials/Rubber/Element Formulation "Enhanced"", "Materials/Rubber/Viscosity"; or the choice of an axisymmetric
/// mesh. Returns an empty string if there is
/// none.
std::string matrix_only(const SceneNode& scene, const std::vector<Material>& materials, const LocalMesh& mesh);

}  // namespace ixos
