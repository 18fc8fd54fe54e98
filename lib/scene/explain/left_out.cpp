#include "scene/explain/left_out.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "model/traits.hpp"
#include "parameters/parameter_entries.hpp"

namespace ixos {
namespace {

/// An absent part, and what its absence means.
struct Absence {
  bool absent;
  const char* name;
  const char* meaning;
};

bool prescribes_displacements(const Simulation& simulation) {
  if (!simulation.model().grips().empty()) return true;
  const Teuchos::ParameterList& conditions = simulation.parameters().sublist("Boundary Conditions");
  const auto all = entries(conditions);
  return std::any_of(all.begin(), all.end(), [&](const auto& entry) {
    const auto type = conditions.sublist(entry.first).template get<std::string>("Type");
    return type == "Displacement" || type == "Symmetry";
  });
}

bool has_friction(const Simulation& simulation) {
  const std::vector<SceneInteraction>& all = simulation.interactions();
  return std::any_of(all.begin(), all.end(),
                     [](const SceneInteraction& own) { return own.friction.type != FrictionType::None; });
}

bool has_pair(const Simulation& simulation) {
  const std::vector<SceneInteraction>& all = simulation.interactions();
  return std::any_of(all.begin(), all.end(), [](const SceneInteraction& own) { return own.is_pair(); });
}

std::vector<Absence> physics(const Simulation& simulation) {
  const Model& model = simulation.model();
  const bool wall = model.has_interactions(), moves = model.mass() != nullptr;
  return {{!wall, "interaction", "no wall attracts or stops the body"},
          {wall && !has_friction(simulation), "friction",
           "obstacles act along their normals only, and the body slides along them freely"},
          {!moves, "inertia",
           "time is a load parameter; the body passes from equilibrium to equilibrium, without vibration"},
          {moves && model.damping() == nullptr, "damping", "no Rayleigh damping takes energy from vibrations"},
          {moves && !has_viscosity(model) && !has_viscoelasticity(model), "viscosity",
           "the material is elastic and dissipates nothing"},
          {!prescribes_displacements(simulation), "prescribed motion", "nothing holds or drives the body"},
          {model.loads().empty(), "loads", "no tractions, no point forces, no weight"},
          {!has_pair(simulation), "a second body",
           "no interaction has a Primary Side Set: bodies, and parts of one body, pass through each other"}};
}

std::vector<Absence> files(const OutputOptions& output) {
  return {{!output.has_frames(), "fields.e", "there are no configurations to draw; see Output/Fields Interval"},
          {!output.energies, "Energies in history.csv", "their columns stay empty, and no energy error is found"},
          {!output.momenta, "Momenta in history.csv", "their columns stay empty"},
          {!output.interaction, "Interaction in history.csv", "contact force, contact measure and gap stay empty"}};
}

}  // namespace

std::string left_out(const Simulation& simulation) {
  std::string text = "Left out, at no cost:\n";
  for (const std::vector<Absence>& parts : {physics(simulation), files(simulation.output())})
    for (const Absence& part : parts)
      if (part.absent) text += fmt::format("  {}: {}\n", part.name, part.meaning);
  return text;
}

}  // namespace ixos
