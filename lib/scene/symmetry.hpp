/// Checks that a scene's linear solver suits its tangents.
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

/// Throws InputError, with the list path and the cause, if the list "Linear Solver" asks for a solver of symmetric
/// matrices and the tangents are not symmetric, or for matrix-free tangents that a material does not offer. `asymmetry`
/// is the result of asymmetry().
void check_linear_solver(const SceneNode& scene, const std::vector<Material>& materials, const std::string& asymmetry);

}  // namespace ixos
