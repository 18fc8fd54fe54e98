#include "scene/compatibility.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "scene/list_access.hpp"
#include "scene/materials.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;

void check_adaptive(const List& scene, const AdaptiveOptions& asked, const Table& table) {
  const std::string path = "Time Integrator/Time Step Control/Adaptive";
  if (!asked.on) return;
  if (asked.tolerance == 0 && asked.gap_ratio == 0)
    throw InputError(path + ": neither Tolerance nor Maximum Gap Ratio is given; one must be greater than 0");
  if (asked.gap_ratio > 0 && !(asked.gap_ratio > 1))
    throw InputError(fmt::format("{}/Maximum Gap Ratio: {} must be greater than 1, or 0", path, asked.gap_ratio));
  if (asked.tolerance > 0 && table.error_constant == 0)
    throw InputError(path + "/Tolerance: the scheme \"" + table.name + "\" has no estimate of its local error; use 0");
  if (asked.gap_ratio > 0 && sublists(scene.sublist("Interactions")).empty())
    throw InputError(path + "/Maximum Gap Ratio: the scene has no interaction; use 0");
  if (asked.time_points && table.interaction_points == 0)
    throw InputError(path + "/Choose Time Points: with these settings the scheme \"" + table.name +
                     "\" has no Gauss points in time for the interaction; use false");
}

void check_cutoff(const List& interactions, const Table& table) {
  const bool exact = std::any_of(table.stages.begin(), table.stages.end(),
                                 [](const Stage& stage) { return stage.interaction.mean == Mean::Exact; });
  for (const std::string& name : sublists(interactions))
    if (exact && interactions.sublist(name).get<double>("Cutoff") > 0)
      throw InputError(
          "Interactions/" + name + "/Cutoff: with these settings the scheme \"" + table.name +
          "\" takes the exact mean of the interaction, which allows no cutoff; use 0, or Interaction Points "
          "of at least 1");
}

void check_formulations(const List& materials, const Table& table) {
  const bool discrete = std::any_of(table.stages.begin(), table.stages.end(),
                                    [](const Stage& stage) { return stage.elastic.mean == Mean::DiscreteGradient; });
  for (const std::string& name : sublists(materials)) {
    const List& list = materials.sublist(name);
    const Formulation chosen = formulation(list);
    const std::string path = "Materials/" + name;
    if (discrete && chosen != Formulation::Standard)
      throw InputError(path + "/Element Formulation: \"" + list.get<std::string>("Element Formulation") +
                       "\" has no discrete gradient, which the scheme \"" + table.name +
                       "\" needs; use \"Standard\", or the scheme \"Average Vector Field\"");
    if (chosen == Formulation::Enhanced && list.get<int>("Quadrature Points") < 2)
      throw InputError(path +
                       "/Quadrature Points: 1 is too few for \"Enhanced\" elements, whose modes vanish at the centre; "
                       "use at least 2");
  }
}

}  // namespace

void check_compatibility(const List& scene, const AdaptiveOptions& adaptive, const Table& table) {
  check_adaptive(scene, adaptive, table);
  check_cutoff(scene.sublist("Interactions"), table);
  check_formulations(scene.sublist("Materials"), table);
}

}  // namespace ixos
