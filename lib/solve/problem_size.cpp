#include "solve/problem_size.hpp"

namespace ixos {

ProblemSize problem_size(const Model& model) {
  ProblemSize size;
  size.dimension = model.mesh().dimension;
  size.dofs = model.space().global();
  size.ranks = model.space().comm()->getSize();
  if (model.has_viscosity()) size.asymmetry = size.matrix_only = "the viscosity";
  for (const NamedForceTerm& named : model.force_terms()) {
    const std::string name = "\"" + named.name + "\"";
    if (!named.term->is_gradient(end_rule())) size.asymmetry = name;
    if (named.term->create_action() == nullptr) size.matrix_only = name;
  }
  return size;
}

}  // namespace ixos
