/// The size of a model's linear systems where no scene describes the solver.
#pragma once
#include "model/model.hpp"
#include "solve/linear_solver_defaults.hpp"

namespace ixos {

/// Returns whether all cells of the mesh are quadratic. Same on all ranks.
bool has_quadratic_cells(const LocalMesh& mesh);

/// Returns the properties of the derivatives of a model's semi-discrete equation, for solvers that no scene describes:
/// without width and stiffness. A viscosity makes W unsymmetric.
ProblemSize problem_size(const Model& model);

}  // namespace ixos
