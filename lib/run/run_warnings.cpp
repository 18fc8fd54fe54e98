#include "run/run_warnings.hpp"

#include <fmt/format.h>

#include <string>

namespace ixos {
namespace {

using Facts = RunFacts;
using Message = std::string;  ///< empty: nothing to warn of

Message energy_error(const Facts& facts) {
  constexpr double limit = 0.05;
  const double share = facts.energy_error / facts.largest_energy;
  if (!facts.has_inertia || !(share > limit)) return "";
  return fmt::format(
      "the scheme's energy error reached {:.3g}, {:.0f} % of the largest kinetic, elastic or interaction energy (limit "
      "{:.0f} %); reduce it with shorter steps or with a scheme that conserves energy (see --list-schemes)",
      facts.energy_error, 100 * share, 100 * limit);
}

Message strains_beyond_mesh(const Facts& facts) {
  constexpr double least = 0.5, largest = 2, stress = 2;
  const StrainExtremes& s = facts.strains;
  if (s.least_jacobian >= least && s.largest_jacobian <= largest && s.largest_invariant <= stress) return "";
  return fmt::format(
      "cells were compressed to {:.3g} of their volume and stretched to {:.3g} (limits {} and {}), their |tr(sigma)|/E "
      "reached {:.3g} (limit {}): the mesh may not resolve such strains, and the elastic law may not hold for them; "
      "use smaller cells, or check "
      "the units of the law and of Young's modulus",
      s.least_jacobian, s.largest_jacobian, least, largest, s.largest_invariant, stress);
}

Message distorted_cells(const Facts& facts) {
  constexpr double limit = 0.15;
  const double scaled = facts.strains.least_scaled_jacobian;
  // A mesh that is bad from the beginning has had its warning.
  if (scaled >= limit || scaled >= 0.5 * facts.first_scaled_jacobian) return "";
  return fmt::format(
      "the most deformed cell had a scaled Jacobian of {:.2g} at t = {:.6g} T0 (limit {}; {:.2g} before the run): the "
      "stresses there are not resolved; use smaller cells there, or check the units of the law and of Young's modulus",
      scaled, facts.strains.time, limit, facts.first_scaled_jacobian);
}

Message crossed_obstacle(const Facts& facts) {
  if (facts.crossings > 0)
    return fmt::format(
        "in {} step(s) a surface crossed its obstacle between quadrature points (limit 0); they were rejected. Use "
        "smaller faces or shorter steps",
        facts.crossings);
  if (!(facts.deepest < -facts.scale) || facts.scale == 0) return "";
  return fmt::format(
      "a surface went {:.3g} L0 below its obstacle, farther than the law's equilibrium gap of {:.3g} L0: the law does "
      "not keep bodies apart there; use a stronger repulsion, slower motions or the law \"Van der Waals\"",
      -facts.deepest, facts.scale);
}

Message oscillating_force(const Facts& facts) {
  constexpr double limit = 0.06, faces = 8;
  if (!(facts.ripple.roughness > limit) || facts.ripple.faces < faces) return "";
  return fmt::format(
      "{} oscillates by {:.2g} of its size from row to row (limit {}) while the front of the contact passes "
      "{:.0f} faces: the mesh does not resolve the front; use shorter faces or a richer Contact Element",
      facts.ripple.column, facts.ripple.roughness, limit, facts.ripple.faces);
}

Message detachment_between_outputs(const Facts& facts) {
  constexpr double share = 0.5, faces = 8;
  const double fall = facts.fall.before - facts.fall.after;
  if (facts.face_measure == 0 || fall <= share * facts.largest_measure || fall < faces * facts.face_measure) return "";
  return fmt::format(
      "the contact fell from {:.3g} to {:.3g} between two rows, from t = {:.6g} to {:.6g} T0, {:.0f} % of its largest "
      "value (limit {:.0f} %): peaks in between are not recorded; use a smaller History Interval or Time Step",
      facts.fall.before, facts.fall.after, facts.fall.from, facts.fall.to, 100 * fall / facts.largest_measure,
      100 * share);
}

Message jump_to_another_equilibrium(const Facts& facts) {
  constexpr double limit = 0.02;
  const double share = facts.jump.released / facts.largest_energy;
  if (facts.has_inertia || !(share > limit)) return "";
  return fmt::format(
      "between t = {:.6g} and {:.6g} T0 the body jumped to another equilibrium and released {:.3g} E0 L0^D, {:.0f} % "
      "of "
      "the largest energy (limit {:.0f} %): the states on both sides are equilibria, the way between them is none; "
      "a dynamic scheme shows it",
      facts.jump.from, facts.jump.to, facts.jump.released, 100 * share, 100 * limit);
}

constexpr WarningKind<RunFacts> kinds[] = {
    {"energy error", energy_error},
    {"strains", strains_beyond_mesh},
    {"distorted cells", distorted_cells},
    {"crossed obstacle", crossed_obstacle},
    {"oscillating force", oscillating_force},
    {"detachment", detachment_between_outputs},
    {"jump to another equilibrium", jump_to_another_equilibrium},
};

}  // namespace

std::vector<Warning> run_warnings(const RunFacts& facts) { return warnings_of(facts, kinds); }

}  // namespace ixos
