#include "time/default_linear_solver.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "solve/choice/problem_size.hpp"
#include "time/stage_problem.hpp"

namespace ixos {

double tangent_stiffness(const Model& model, const Table& table, double dt) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (is_static(table) || is_explicit(table) || dt == infinity) return infinity;
  double damping = 0, largest = 0;
  for (const Material& material : model.materials())
    damping = std::max(damping, material.stiffness_damping + material.viscosity);
  for (const Stage& stage : table.stages) {
    const double stiffness = stage.elastic.end_weight() * dt * dt + damping * stage.damping.unknown * dt;
    largest = std::max(largest, stiffness * model.scales().stiffest / stage.inertia.unknown);
  }
  return largest;
}

ProblemSize stage_size(const Model& model, const Table& table, double longest_step) {
  ProblemSize size = problem_size(model);
  size.asymmetry.clear();  // that of the table's tangents, not that of the semi-discrete equation
  if (!std::all_of(table.stages.begin(), table.stages.end(), [&](const Stage& s) { return is_symmetric(model, s); }))
    size.asymmetry = "the scheme \"" + table.name + "\" with this model";
  size.stiffness = tangent_stiffness(model, table, longest_step);
  return size;
}

std::shared_ptr<const LinearSolverFactory> default_linear_solver(Model& model, const Table& table,
                                                                 double longest_step) {
  auto solver = std::make_shared<const LinearSolverFactory>(
      completed_linear_solver({}, stage_size(model, table, longest_step)), &model);
  if (solver->matrix_free() && !is_explicit(table)) model.do_without_matrices();
  return solver;
}

}  // namespace ixos
