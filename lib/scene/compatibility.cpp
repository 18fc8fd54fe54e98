#include "scene/compatibility.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "scene/interactions.hpp"

namespace ixos {
namespace {

void check_adaptive(bool interacts, const AdaptiveOptions& asked, const Table& table) {
  const std::string path = "Time Integrator/Time Step Control/Adaptive";
  if (!asked.on) return;
  if (asked.tolerance == 0 && asked.gap_ratio == 0)
    throw InputError(path + ": neither Tolerance nor Maximum Gap Ratio is given; one must be greater than 0");
  if (asked.gap_ratio > 0 && !(asked.gap_ratio > 1))
    throw InputError(fmt::format("{}/Maximum Gap Ratio: {} must be greater than 1, or 0", path, asked.gap_ratio));
  if (asked.tolerance > 0 && table.error_constant == 0)
    throw InputError(path + "/Tolerance: the scheme \"" + table.name + "\" has no estimate of its local error; use 0");
  if (asked.gap_ratio > 0 && !interacts)
    throw InputError(path + "/Maximum Gap Ratio: the scene has no interaction; use 0");
  if (asked.time_points && table.interaction_points == 0)
    throw InputError(path + "/Choose Time Points: with these settings the scheme \"" + table.name +
                     "\" has no Gauss points in time for the interaction; use false");
}

void check_interactions(const std::vector<SceneInteraction>& interactions, const Table& table) {
  const bool exact = std::any_of(table.stages.begin(), table.stages.end(),
                                 [](const Stage& stage) { return stage.interaction.mean == Mean::Exact; });
  for (const SceneInteraction& interaction : interactions)
    if (exact && interaction.cutoff > 0)
      interaction.node.refuse("Cutoff", "with these settings the scheme \"" + table.name +
                                            "\" takes the exact mean of the interaction, which allows no cutoff; use "
                                            "0, or Interaction Points of at least 1");
}

void check_materials(const SceneNode& lists, const std::vector<Material>& materials, const Table& table) {
  const bool discrete = std::any_of(table.stages.begin(), table.stages.end(),
                                    [](const Stage& stage) { return stage.elastic.mean == Mean::DiscreteGradient; });
  const std::vector<SceneNode> nodes = lists.sublists();
  for (std::size_t i = 0; i < materials.size(); ++i) {
    const SceneNode& node = nodes[i];
    const auto no_discrete_gradient = [&](const char* entry, const char* use) {
      node.refuse(entry, "\"" + node.text(entry) + "\" has no discrete gradient, which the scheme \"" + table.name +
                             "\" needs; use \"" + use + "\", or the scheme \"Average Vector Field\"");
    };
    if (discrete && materials[i].formulation != Formulation::Standard)
      no_discrete_gradient("Element Formulation", "Standard");
    if (discrete && !materials[i].law->has_discrete_gradient()) no_discrete_gradient("Model", "Neo-Hooke");
    if (materials[i].viscosity != 0 && materials[i].formulation != Formulation::Standard)
      node.refuse("Viscosity", fmt::format("{} with \"{}\" elements: their viscous stress would lock; use 0, "
                                           "Stiffness Damping, or the Element Formulation \"Standard\"",
                                           materials[i].viscosity, node.text("Element Formulation")));
    if (materials[i].formulation == Formulation::Enhanced && materials[i].points < 2)
      node.refuse("Quadrature Points",
                  "1 is too few for \"Enhanced\" elements, whose modes vanish at the centre; use at least 2");
  }
}

}  // namespace

void check_compatibility(const SceneNode& scene, const std::vector<Material>& materials,
                         const std::vector<SceneInteraction>& interactions, const AdaptiveOptions& adaptive,
                         const Table& table) {
  check_adaptive(!interactions.empty(), adaptive, table);
  check_interactions(interactions, table);
  check_materials(scene.sublist("Materials"), materials, table);
}

}  // namespace ixos
