#include "model/traits.hpp"

#include <algorithm>

#include "material/elastic_law.hpp"

namespace ixos {
namespace {

template <class Is>
bool any_interaction(const Model& model, const Is& is) {
  return std::any_of(model.interactions().begin(), model.interactions().end(),
                     [&](const NamedInteraction& named) { return is(*named.term); });
}

}  // namespace

bool is_gradient(const Model& model, Part part, const Rule& rule) {
  return std::all_of(model.force_terms().begin(), model.force_terms().end(), [&](const NamedForceTerm& named) {
    return named.term->part() != part || named.term->is_gradient(rule);
  });
}

bool rates_are_gradients(const Model& model, RateForm form) {
  return std::all_of(model.rate_terms().begin(), model.rate_terms().end(),
                     [&](const RateTerm* term) { return term->is_gradient(form); });
}

bool has_moved_obstacles(const Model& model) {
  return any_interaction(model, [](const Interaction& term) { return term.motion() != nullptr; });
}

bool obstacles_are_finite(const Model& model, double time) {
  return !any_interaction(
      model, [time](const Interaction& term) { return term.motion() != nullptr && !term.motion()->is_finite(time); });
}

bool has_laws_of_every_gap(const Model& model) {
  return any_interaction(model, [](const Interaction& term) { return !term.admissibility().needs_positive_gaps(); });
}

bool has_friction(const Model& model) {
  return any_interaction(model, [](const Interaction& term) { return term.has_friction(); });
}

bool has_friction(const Model& model, const std::string& interaction) {
  return std::any_of(model.interactions().begin(), model.interactions().end(), [&](const NamedInteraction& named) {
    return named.name == interaction && named.term->has_friction();
  });
}

bool has(const Model& model, const std::string& interaction, SurfaceNumber number) {
  return std::any_of(model.interactions().begin(), model.interactions().end(), [&](const NamedInteraction& named) {
    return named.name == interaction && named.term->reports().has(number);
  });
}

bool has_springs(const Model& model) { return model.has_supports(); }

bool has_turning_bodies(const Model& model) {
  return std::any_of(model.rigid_bodies().begin(), model.rigid_bodies().end(),
                     [](const RigidBody& body) { return body.turns(); });
}

bool has_histories(const Model& model) {
  return std::any_of(model.force_terms().begin(), model.force_terms().end(),
                     [](const NamedForceTerm& named) { return named.term->has_history(); });
}

bool has_viscosity(const Model& model) { return largest_viscosity(model) > 0; }

double largest_viscosity(const Model& model) {
  double largest = 0;
  for (const Body& body : model.bodies()) largest = std::max(largest, body.material.viscosity);
  return largest;
}

bool has_mixed_steps(const Model& model) {
  return std::any_of(model.materials().begin(), model.materials().end(), [](const Material& own) {
    return own.formulation != Formulation::Enhanced && own.law->points(SolidSpace{}).has_mixed_steps() &&
           poissons_ratio(own.law->lame()) > nearly_incompressible;
  });
}

bool has_viscoelasticity(const Model& model) {
  return std::any_of(model.materials().begin(), model.materials().end(),
                     [](const Material& own) { return !own.branches.empty(); });
}

}  // namespace ixos
