#include "scene/examine/notes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace ixos {
namespace {

using Note = std::string;  ///< empty: nothing to note

/// Concerns a block or a pillar: a film that is peeled off hardly narrows. An oblique pull draws a warning.
Note straight_pull_without_friction(const SurfaceNumbers& surface, const SurfaceFacts& own, const BodyNumbers& body,
                                    const SceneFacts&) {
  constexpr double oblique = 0.1, compact = 4, least_column = 0.5, least_ratio = 0.1;
  const double ratio = std::sqrt(std::max(0.0, 1 - body.modulus / body.plane_modulus));  // Poisson's
  if (own.column < least_column || own.moved || ratio < least_ratio || body.size > compact * surface.thickness)
    return "";
  for (const Pull& pull : own.drive.pulls)
    if (pull.away > 0 && pull.along <= oblique * pull.away)
      return fmt::format(
          "{} pulls the foot off without friction: the foot slides along the obstacle and narrows as it is stretched. "
          "A foot that cannot slide may hold several times the force; if the surfaces stick, give the interaction a "
          "Friction",
          pull.path);
  return "";
}

/// Bodies that fly, fall or are pushed towards the obstacle begin away from it on purpose.
Note start_far_from_equilibrium(const SurfaceNumbers& surface, const SurfaceFacts& own, const BodyNumbers&,
                                const SceneFacts& facts) {
  if (surface.work == 0 || !own.rest_gap || facts.moves || own.drive.approach > 0) return "";
  if (!own.drive.held && facts.has_inertia) return "";
  if (std::any_of(own.drive.pulls.begin(), own.drive.pulls.end(), [](const Pull& pull) { return pull.towards > 0; }))
    return "";
  const bool apart = surface.least_gap > own.peak_gap;
  if (!apart && own.repulsion <= surface.peak_traction) return "";
  std::vector<std::string> shift;
  for (std::size_t i = 0; i < static_cast<std::size_t>(facts.dimension); ++i)
    shift.push_back(fmt::format("{:.6g}", (*own.rest_gap - surface.least_gap) * surface.normal[i] + 0.0));
  return fmt::format(
      "the surface begins at a least gap of {:.6g} L0, {}; the equilibrium gap of its law is {:.6g} L0. To begin in "
      "contact and in equilibrium, shift the mesh by ({}) L0: the generator's place, the Translation of a part, or a "
      "Map",
      surface.least_gap,
      apart ? "beyond its largest attraction" : "where it is repelled more than it ever is attracted", *own.rest_gap,
      fmt::join(shift, ", "));
}

Note missing_symmetry(const SurfaceNumbers&, const SurfaceFacts& own, const BodyNumbers&, const SceneFacts&) {
  if (!own.open_cut) return "";
  const char axis = "xyz"[own.open_cut->axis];
  return fmt::format(
      "the surface meets the plane {} = {:.6g} at a right angle and bends away from it, as at a plane of symmetry, but "
      "nothing acts on that plane: the body ends there. If it is a part of a symmetric body, hold the nodes of the "
      "plane by a Displacement of the Components {}",
      axis, own.open_cut->place, axis);
}

}  // namespace

std::vector<std::string> scene_notes(const SceneFacts& facts) {
  std::vector<std::string> notes;
  for (const auto& note : {straight_pull_without_friction, start_far_from_equilibrium, missing_symmetry})
    for (std::size_t i = 0; i < facts.surfaces.size(); ++i) {
      const SurfaceNumbers& numbers = facts.numbers.surfaces[i];
      const Note text = note(numbers, facts.surfaces[i], facts.numbers.bodies[numbers.body], facts);
      if (!text.empty()) notes.push_back("Interactions/" + numbers.name + ": " + text);
    }
  return notes;
}

}  // namespace ixos
