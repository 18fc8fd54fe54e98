/// The linear solver of a scheme's stages, chosen for a program that leaves the choice to Ixos.
#pragma once
#include <memory>

#include "model/model.hpp"
#include "solve/choice/linear_solver.hpp"
#include "solve/choice/linear_solver_defaults.hpp"
#include "time/table.hpp"

namespace ixos {

/// Returns how much the elastic forces weigh beside inertia in the tangents of a step of length dt, at the stiffest
/// degree of freedom (ProblemSize::stiffness). Infinite for schemes without inertia, for explicit ones, and if dt is
/// infinite.
double tangent_stiffness(const Model& model, const Table& table, double dt);

/// Returns the properties of the stages' linear systems, for completed_linear_solver(): those of a scene with this
/// model and scheme, but for the width of a DistributedMesh and the shape of cells.
ProblemSize stage_size(const Model& model, const Table& table, double longest_step);

/// Returns the solver that a scene with this model and scheme gets if it asks for none, see completed_linear_solver().
/// It does not look for long cells, nor for slender bodies in a DistributedMesh: in three dimensions these take the
/// solvers of compact bodies, too. May release the damping's matrix, see Model::do_without_matrices(). Add interactions
/// before. `longest_step`: of the steps that the program takes [T0]. Collective.
std::shared_ptr<const LinearSolverFactory> default_linear_solver(Model& model, const Table& table, double longest_step);

}  // namespace ixos
