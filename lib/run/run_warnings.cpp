#include "run/run_warnings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <string>
#include <vector>

#include "scene/output/output_fields.hpp"

namespace ixos {
namespace {

using Facts = RunFacts;
using Message = std::string;  ///< empty: nothing to warn of

/// Returns the value in as many digits, at least those, as tell it from the limit that it passed.
std::string beyond(double value, double limit, int digits = 3) {
  while (digits < 17 && fmt::format("{:.{}g}", value, digits) == fmt::format("{:.{}g}", limit, digits)) ++digits;
  const bool whole = std::abs(value) >= std::pow(10.0, digits) && std::abs(value) < 1e9;  // no power of ten
  return whole ? fmt::format("{:.0f}", value) : fmt::format("{:.{}g}", value, digits);
}

Message energy_error(const Facts& facts) {
  constexpr double limit = 0.05;
  const double share = facts.energy_error / facts.largest_energy;
  if (!facts.has_inertia || !(share > limit)) return "";
  return fmt::format(
      "the scheme's energy error reached {:.3g}, {} % of the largest kinetic, elastic or interaction energy (limit "
      "{:.0f} %); reduce it with shorter steps or with a scheme that conserves energy (see --list-schemes)",
      facts.energy_error, beyond(100 * share, 100 * limit), 100 * limit);
}

Message strains_beyond_mesh(const Facts& facts) {
  constexpr double least = 0.5, largest = 2, stress = 2;
  const StrainExtremes& s = facts.strains;
  std::vector<std::string> found;
  if (!(s.least_jacobian >= least))
    found.push_back(
        fmt::format("cells were compressed to {} of their volume (limit {})", beyond(s.least_jacobian, least), least));
  if (!(s.largest_jacobian <= largest))
    found.push_back(fmt::format("cells were stretched to {} times their volume (limit {})",
                                beyond(s.largest_jacobian, largest), largest));
  if (!(s.largest_invariant <= stress))
    found.push_back(
        fmt::format("|tr(sigma)|/E of cells reached {} (limit {})", beyond(s.largest_invariant, stress), stress));
  if (found.empty()) return "";
  return fmt::format(
      "{}: the mesh may not resolve such strains, and the elastic law may not hold for them; use smaller cells, or "
      "check the units of the law and of Young's modulus",
      fmt::join(found, ", "));
}

Message distorted_cells(const Facts& facts) {
  constexpr double limit = 0.15;
  const double scaled = facts.strains.least_scaled_jacobian;
  // A mesh that is bad from the beginning has had its warning.
  if (scaled >= limit || scaled >= 0.5 * facts.first_scaled_jacobian) return "";
  return fmt::format(
      "the most deformed cell had a scaled Jacobian of {} at t = {:.6g} T0 (limit {}; {:.2g} before the run): the "
      "stresses there are not resolved; use smaller cells there, or check the units of the law and of Young's modulus",
      beyond(scaled, limit, 2), facts.strains.time, limit, facts.first_scaled_jacobian);
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
      "{} oscillates by {} of its size from row to row (limit {}) while the front of the contact passes "
      "{:.0f} faces: the mesh does not resolve the front; use shorter faces or a richer Contact Element",
      facts.ripple.column, beyond(facts.ripple.roughness, limit, 2), limit, facts.ripple.faces);
}

Message jump_to_another_equilibrium(const Facts& facts) {
  constexpr double limit = 0.02;
  const Jump& jump = facts.jumps.largest;
  const double share = jump.released / facts.largest_energy;
  if (facts.has_inertia || !(share > limit)) return "";
  const std::string all = facts.jumps.count > 1 ? fmt::format(", the largest of {} jumps, which released {:.3g}",
                                                              facts.jumps.count, facts.jumps.released)
                                                : "";
  return fmt::format(
      "between t = {:.6g} and {:.6g} T0 the body jumped to another equilibrium and released {:.3g} {}, {:.0f} % "
      "of the largest energy (limit {:.0f} %){}: the states on both sides are equilibria, the way between them is "
      "none, "
      "and there may be other equilibria than the one found; a dynamic scheme shows the way",
      jump.from, jump.to, jump.released, unit_in(facts.body_dimension, "E0 L0^D"), 100 * share, 100 * limit, all);
}

Message detachment_between_outputs(const Facts& facts) {
  constexpr double share = 0.5, faces = 8;
  const double fall = facts.fall.before - facts.fall.after;
  const Jump& jump = facts.jumps.largest;
  const bool is_jump = jump.from == facts.fall.from && jump.to == facts.fall.to;
  if (is_jump && !jump_to_another_equilibrium(facts).empty()) return "";  // that warning says it
  if (facts.face_measure == 0 || fall <= share * facts.largest_measure || fall < faces * facts.face_measure) return "";
  return fmt::format(
      "the contact fell from {:.3g} to {:.3g} between two rows, from t = {:.6g} to {:.6g} T0, {} % of its largest "
      "value (limit {:.0f} %): peaks in between are not recorded; use a smaller History Interval or Time Step",
      facts.fall.before, facts.fall.after, facts.fall.from, facts.fall.to,
      beyond(100 * fall / facts.largest_measure, 100 * share), 100 * share);
}

/// Returns how many times shorter steps have to be for an error of that order to be 1 %.
double shortening(double error, int order = 1) { return std::ceil(std::pow(error / 0.01, 1.0 / order) - 1e-9); }

Message lagged_friction(const Facts& facts) {
  constexpr double limit = 0.02;
  if (!(facts.friction_lag > limit)) return "";
  return fmt::format(
      "the threshold of friction, which is that at the start of each step, changed by {} % in a step on average "
      "(limit {:.0f} %): friction is off by about as much, an error of first order in the step; use steps {:.0f} times "
      "shorter for 1 %, or the Threshold \"Current\"",
      beyond(100 * facts.friction_lag, 100 * limit, 2), 100 * limit, shortening(facts.friction_lag));
}

Message front_against_step(const Facts& facts) {
  constexpr double share = 0.5;
  constexpr long rows = 8;
  const FrontSteps& front = facts.front;
  if (front.fast < rows || static_cast<double>(front.fast) <= share * static_cast<double>(front.moving)) return "";
  return fmt::format(
      "the fronts of the contact moved {:.3g} L0 together in a step on average, farther than the cohesive zone, {:.3g} "
      "L0, in "
      "{} of {} rows in which they moved (limit {:.0f} %): their forces are not resolved in time; use steps {:.0f} "
      "times "
      "shorter",
      front.way, front.zone, front.fast, front.moving, 100 * share, std::ceil(3 * front.way / front.zone));
}

Message unresolved_relaxation(const Facts& facts) {
  constexpr double limit = 0.1;
  if (!(facts.relaxation_error > limit)) return "";
  return fmt::format(
      "the time step's error in the stress of the Maxwell branches was {} % of the stress while they acted (limit "
      "{:.0f} %), an error of {} order in the step: use steps {:.0f} times shorter for 1 %, which are below a third of "
      "the relaxation times that matter",
      beyond(100 * facts.relaxation_error, 100 * limit, 2), 100 * limit,
      facts.relaxation_order == 1 ? "first" : "second", shortening(facts.relaxation_error, facts.relaxation_order));
}

constexpr WarningKind<RunFacts> kinds[] = {
    {"energy error", energy_error},
    {"strains", strains_beyond_mesh},
    {"distorted cells", distorted_cells},
    {"crossed obstacle", crossed_obstacle},
    {"oscillating force", oscillating_force},
    {"detachment", detachment_between_outputs},
    {"lagged friction", lagged_friction},
    {"front and step", front_against_step},
    {"relaxation error", unresolved_relaxation},
    {"jump to another equilibrium", jump_to_another_equilibrium},
};

}  // namespace

std::vector<Warning> run_warnings(const RunFacts& facts) { return warnings_of(facts, kinds); }

}  // namespace ixos
