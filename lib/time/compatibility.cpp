#include "time/compatibility.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"

namespace ixos {

bool needs_discrete_gradient(const Table& table) {
  return std::any_of(table.stages.begin(), table.stages.end(),
                     [](const Stage& stage) { return stage.elastic.mean == Mean::DiscreteGradient; });
}

bool has_discrete_gradient(const Material& material) {
  return material.formulation == Formulation::Standard && material.law->has_discrete_gradient();
}

bool lacks_potential(const ForceTerm& term, const Table& table) {
  const auto* interaction = dynamic_cast<const Interaction*>(&term);
  if (interaction == nullptr || interaction->has_mean_potential()) return false;
  return std::any_of(table.stages.begin(), table.stages.end(), [&](const Stage& stage) {
    return stage.interaction.mean == Mean::Exact && term.is_gradient(stage.interaction);
  });
}

void check_compatible(const Model& model, const Table& table) {
  if (needs_discrete_gradient(table))
    for (const Material& material : model.materials())
      if (!has_discrete_gradient(material))
        throw InputError(fmt::format(
            "the scheme \"{}\" needs a discrete gradient, and the {} of block \"{}\" has none; use another "
            "one, or the scheme \"Average Vector Field\"",
            table.name, material.formulation == Formulation::Standard ? "elastic law" : "formulation", material.block));
  for (const NamedForceTerm& named : model.force_terms())
    if (lacks_potential(*named.term, table))
      throw InputError(
          fmt::format("the scheme \"{}\" takes the exact mean of the interaction \"{}\", which allows no cutoff before "
                      "a flat wall; use the cutoff 0, or at least 1 interaction point in time",
                      table.name, named.name));
}

}  // namespace ixos
