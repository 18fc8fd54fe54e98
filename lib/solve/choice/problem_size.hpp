/// The size of a model's linear systems where no scene describes the solver.
#pragma once
#include <string>

#include "model/model.hpp"
#include "solve/choice/linear_solver_defaults.hpp"

namespace ixos {

/// Returns whether all cells of the mesh are quadratic. Same on all ranks.
bool has_quadratic_cells(const LocalMesh& mesh);

/// Returns what has no Galerkin product on linear cells (TangentAction::has_coarse()): in quotes the name of the last
/// term whose tangent can be applied without a matrix; or, in words, planes of symmetry or tied corners of cells. Empty
/// if all have one. Collective.
std::string term_without_coarse(const Model& model);

/// Returns the properties of the derivatives of a model's semi-discrete equation, for solvers that no scene describes:
/// without stiffness, and without width for a DistributedMesh. A viscosity makes W unsymmetric.
ProblemSize problem_size(const Model& model);

}  // namespace ixos
