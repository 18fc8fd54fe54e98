#include "embedding/semi_discrete_responses.hpp"

#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>
#include <algorithm>

#include "base/error.hpp"
#include "model/set_reactions.hpp"
#include "model/state_report.hpp"

namespace ixos {
namespace {

std::string axes(const Model& model) { return model.mesh().dimension == 2 ? "xy" : "xyz"; }

void append(std::vector<std::string>& names, const std::string& stem, const std::string& axes) {
  for (const char axis : axes) names.push_back(stem + "_" + axis);
}

}  // namespace

SemiDiscreteResponses::SemiDiscreteResponses(const Model& model, const std::vector<std::string>& reactions)
    : model_(model) {
  add_names({"kinetic_energy", "elastic_energy", "contact_energy"});
  std::vector<std::string> momenta, interaction, sets;
  append(momenta, "linear_momentum", axes(model));
  append(momenta, "angular_momentum", model.mesh().dimension == 2 ? "z" : "xyz");
  add_names(std::move(momenta));
  append(interaction, "contact_force", axes(model));
  interaction.insert(interaction.end(), {"contact_measure", "min_gap"});
  add_names(std::move(interaction));
  for (const std::string& name : reactions) {
    add_reaction_set(name);
    append(sets, "reaction_" + name, axes(model));
  }
  if (!sets.empty()) add_names(std::move(sets));
}

void SemiDiscreteResponses::add_names(std::vector<std::string> names) {
  const auto size = static_cast<Tpetra::global_size_t>(names.size());
  spaces_.push_back(vector_space(Teuchos::rcp(new Map(size, 0, model_.space().comm(), Tpetra::LocallyReplicated))));
  names_.push_back(std::move(names));
}

void SemiDiscreteResponses::add_reaction_set(const std::string& name) {
  try {
    check_held(model_, name);
  } catch (const InputError& error) {
    throw InputError(std::string("reactions of an evaluator: ") + error.what());
  }
  reaction_sets_.push_back(model_.mesh().node_set(name));
}

void SemiDiscreteResponses::evaluate(int response, SemiDiscreteBalance& balance, Vector& g) const {
  const std::vector<double> components = values(static_cast<Response>(response), balance);
  const auto view = g.getLocalViewHost(Tpetra::Access::OverwriteAll);
  std::copy(components.begin(), components.end(), view.data());
}

std::vector<double> SemiDiscreteResponses::values(Response response, SemiDiscreteBalance& balance) const {
  const bool moves = response == Response::Energies || response == Response::Momenta;
  if (moves) balance.velocity();  // the place then has it
  const StateReport report(model_, balance.place());
  switch (response) {
    case Response::Energies:
      return {report.momenta().kinetic_energy, report.elastic_energy(), report.energy(Part::Interaction)};
    case Response::Momenta: {
      const Momenta momenta = report.momenta();
      std::vector<double> all(momenta.linear);
      all.insert(all.end(), momenta.angular.begin(), momenta.angular.end());
      return all;
    }
    case Response::Interaction: {
      const InteractionReport interaction = report.interaction_report();
      std::vector<double> all(interaction.force);
      all.insert(all.end(), {interaction.measure, interaction.least_gap});
      return all;
    }
    case Response::Reactions:
      break;
  }
  return set_reactions(model_, balance.sum(), reaction_sets_);
}

}  // namespace ixos
