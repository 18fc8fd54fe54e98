#include "solve/choice/problem_size.hpp"

#include <algorithm>

#include "model/traits.hpp"

namespace ixos {
namespace {

/// Whether a corner of a cell follows others: the coarse cells know of no ties.
bool has_tied_corner(const LocalMesh& mesh) {
  if (mesh.global_tied == 0) return false;
  for (const LocalBlock& block : mesh.blocks) {
    const int n = nodes_per_cell(block.type), corners = nodes_per_cell(corner_type(block.type));
    for (std::size_t k = 0; k < block.nodes.size(); ++k)
      if (static_cast<int>(k) % n < corners && mesh.is_tied(block.nodes[k])) return true;
  }
  return false;
}

}  // namespace

bool has_quadratic_cells(const LocalMesh& mesh) {
  return std::all_of(mesh.blocks.begin(), mesh.blocks.end(),
                     [](const auto& block) { return block.global_cells == 0 || is_quadratic(block.type); });
}

std::string term_without_coarse(const Model& model) {
  if (model.space().maximum(model.constraints().planes().empty() ? 0 : 1) > 0)
    return "a condition of the Type Symmetry";
  if (model.space().maximum(has_tied_corner(model.mesh()) ? 1 : 0) > 0) return "a mesh whose cells have tied corners";
  std::string name;
  for (const NamedForceTerm& named : model.force_terms()) {
    const auto action = named.term->create_action();
    if (action != nullptr && !action->has_coarse()) name = "\"" + named.name + "\"";
  }
  return name;
}

ProblemSize problem_size(const Model& model) {
  ProblemSize size;
  size.dimension = model.mesh().dimension;
  size.dofs = model.space().global();
  size.ranks = model.space().comm()->getSize();
  size.width = model.mesh().level_width;
  size.quadratic = has_quadratic_cells(model.mesh());
  size.refined = model.mesh().refinement != nullptr;
  if (size.quadratic || size.refined) size.fine_only = term_without_coarse(model);
  if (has_viscosity(model)) size.asymmetry = size.matrix_only = "the viscosity";
  for (const NamedForceTerm& named : model.force_terms()) {
    const std::string name = "\"" + named.name + "\"";
    if (!named.term->is_gradient(end_rule())) size.asymmetry = name;
    if (named.term->create_action() == nullptr) size.matrix_only = name;
  }
  return size;
}

}  // namespace ixos
