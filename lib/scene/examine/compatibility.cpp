#include "scene/examine/compatibility.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.hpp"
#include "interaction/gap_law.hpp"
#include "scene/read/interactions.hpp"
#include "scene/read/maxwell_branches.hpp"
#include "time/compatibility.hpp"

namespace ixos {
namespace {

/// Returns why no interaction has a ratio of gaps; empty if one has.
std::string why_no_gap_ratio(const std::vector<SceneInteraction>& interactions) {
  for (const SceneInteraction& interaction : interactions)
    if (interaction.law->domain() == GapDomain::Positive) return "";
  if (interactions.empty()) return "the scene has no interaction";
  const SceneNode& node = interactions.front().node;
  return node.path_of("Law") + " \"" + node.text("Law") + "\" is defined at every gap, so it needs no such limit";
}

void check_adaptive(const std::vector<SceneInteraction>& interactions, const AdaptiveOptions& asked,
                    const Table& table) {
  const std::string path = "Time Integrator/Time Step Control/Adaptive";
  if (!asked.on) return;
  if (asked.tolerance == 0 && asked.gap_ratio == 0)
    throw InputError(path + ": neither Tolerance nor Maximum Gap Ratio is given; one must be greater than 0");
  if (asked.gap_ratio > 0 && !(asked.gap_ratio > 1))
    throw InputError(fmt::format("{}/Maximum Gap Ratio: {} must be greater than 1, or 0", path, asked.gap_ratio));
  if (asked.tolerance > 0 && table.error_constant == 0)
    throw InputError(path + "/Tolerance: the scheme \"" + table.name + "\" has no estimate of its local error; use 0");
  const std::string why = why_no_gap_ratio(interactions);
  if (asked.gap_ratio > 0 && !why.empty())
    throw InputError(
        fmt::format("{}/Maximum Gap Ratio: {} has no effect: {}; use 0, and Tolerance", path, asked.gap_ratio, why));
  if (asked.time_points && !why.empty())
    throw InputError(path + "/Choose Time Points: true has no effect: " + why + "; use false");
  if (asked.time_points && table.interaction_points == 0)
    throw InputError(path + "/Choose Time Points: with these settings the scheme \"" + table.name +
                     "\" has no Gauss points in time for the interaction; use false");
}

void check_materials(const SceneNode& lists, const std::vector<Material>& materials, const Table& table) {
  const bool discrete = needs_discrete_gradient(table);
  const std::vector<SceneNode> nodes = lists.sublists();
  for (std::size_t i = 0; i < materials.size(); ++i) {
    const SceneNode& node = nodes[i];
    const auto no_discrete_gradient = [&](const char* entry, const char* use) {
      node.refuse(entry, "\"" + node.text(entry) + "\" has no discrete gradient, which the scheme \"" + table.name +
                             "\" needs; use \"" + use + "\", or the scheme \"Average Vector Field\"");
    };
    if (const auto refusal = refusal_of(materials[i], table.mass != Inertia::None))
      node.refuse_value(refusal->setting, refusal->value, refusal->why);
    if (const std::string why = why_no_branches(materials[i], table); !materials[i].branches.empty() && !why.empty())
      node.refuse(maxwell_branches_name, why);
    if (discrete && !has_discrete_gradient(materials[i])) {
      if (materials[i].formulation != Formulation::Standard) no_discrete_gradient("Element Formulation", "Standard");
      no_discrete_gradient("Model", "Neo-Hooke");
    }
  }
}

void check_friction(const std::vector<SceneInteraction>& interactions, const Table& table) {
  const bool weighs_start = std::any_of(table.stages.begin(), table.stages.end(),
                                        [](const Stage& stage) { return stage.interaction.kept_weight != 0; });
  for (const SceneInteraction& interaction : interactions) {
    if (interaction.friction.type != FrictionType::Smoothed) continue;
    if (is_explicit(table))
      interaction.node.refuse("Friction/Type", "\"Smoothed\" has no longest stable step, which the explicit scheme \"" +
                                                   table.name +
                                                   "\" needs; use \"Extended Amontons\", or an implicit scheme");
    if (weighs_start)
      interaction.node.refuse("Friction/Type", "\"Smoothed\" has no force at a step's start, which the scheme \"" +
                                                   table.name +
                                                   "\" weights; use \"Extended Amontons\", or a scheme such as "
                                                   "Newmark or Average Vector Field");
  }
}

void check_pairs(const std::vector<SceneInteraction>& interactions, const Table& table) {
  for (const SceneInteraction& interaction : interactions) {
    if (!interaction.is_pair()) continue;
    if (const std::string why = why_no_pairs(table); !why.empty()) interaction.node.refuse("Primary Side Set", why);
    if (interaction.passes == Passes::One || interaction.passes == Passes::Two) continue;
    if (const std::string why = why_no_pairs(table, false); !why.empty()) interaction.node.refuse("Passes", why);
  }
}

/// Refuses what rigid bodies cannot have.
void check_bodies(const SceneNode& scene, const std::vector<SceneInteraction>& interactions, const Table& table) {
  const std::vector<SceneNode> grips = scene.sublist("Grips").sublists();
  for (const SceneNode& body : scene.sublist("Rigid Bodies").sublists()) {
    const bool touches = std::any_of(interactions.begin(), interactions.end(),
                                     [&](const SceneInteraction& own) { return own.rigid_body == body.name(); });
    const bool grips_something = std::any_of(
        grips.begin(), grips.end(), [&](const SceneNode& grip) { return grip.text("Rigid Body") == body.name(); });
    if (is_static(table) && !touches && !grips_something && body.numbers("Stiffness").empty())
      throw InputError(body.path() +
                       ": nothing holds the body, which no interaction and no grip names as its Rigid Body; in "
                       "equilibrium it has no place of its own");
  }
}

}  // namespace

void check_compatibility(const SceneNode& scene, const std::vector<Material>& materials,
                         const std::vector<SceneInteraction>& interactions, const AdaptiveOptions& adaptive,
                         const Table& table) {
  check_adaptive(interactions, adaptive, table);
  check_materials(scene.sublist("Materials"), materials, table);
  check_friction(interactions, table);
  check_pairs(interactions, table);
  check_bodies(scene, interactions, table);
}

}  // namespace ixos
