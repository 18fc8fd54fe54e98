#include "time/default_linear_solver.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "solve/linear_solver_defaults.hpp"

namespace ixos {
namespace {

bool is_symmetric(const Model& model, const Table& table) {
  return std::all_of(table.stages.begin(), table.stages.end(), [&](const Stage& stage) {
    return model.is_gradient(Part::Elastic, stage.elastic) && model.is_gradient(Part::Interaction, stage.interaction);
  });
}

bool needs_matrix(const Model& model) {
  return std::any_of(model.materials().begin(), model.materials().end(), [](const Material& material) {
    return material.viscosity != 0 || !has_action(*material.law, material.formulation);
  });
}

}  // namespace

double tangent_stiffness(const Model& model, const Table& table, double dt) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (is_static(table) || is_explicit(table) || dt == infinity) return infinity;
  double damping = 0, largest = 0;
  for (const Material& material : model.materials())
    damping = std::max(damping, material.stiffness_damping + material.viscosity);
  for (const Stage& stage : table.stages) {
    const double stiffness = stage.elastic.end_weight() * dt * dt + damping * stage.damping.unknown * dt;
    largest = std::max(largest, stiffness * model.stiffest() / stage.inertia.unknown);
  }
  return largest;
}

std::shared_ptr<const LinearSolverFactory> default_linear_solver(Model& model, const Table& table,
                                                                 double longest_step) {
  ProblemSize size;
  size.dimension = model.mesh().dimension;
  size.dofs = model.space().global();
  size.ranks = model.space().comm()->getSize();
  if (!is_symmetric(model, table)) size.asymmetry = "the scheme \"" + table.name + "\" with this model";
  if (needs_matrix(model)) size.matrix_only = "a material";
  size.stiffness = tangent_stiffness(model, table, longest_step);
  auto solver = std::make_shared<const LinearSolverFactory>(completed_linear_solver({}, size), &model);
  if (solver->matrix_free() && !is_explicit(table)) model.do_without_matrices();
  return solver;
}

}  // namespace ixos
