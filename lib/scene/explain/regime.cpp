#include "scene/explain/regime.hpp"

#include <fmt/format.h>

#include <cmath>

namespace ixos {
namespace {

constexpr double brittle_share = 0.1;  // of the surface

std::string of_round(const SurfaceNumbers& surface) {
  const std::string number = fmt::format("Tabor number {:.4g}", surface.tabor);
  if (surface.tabor < 0.1)
    return number + ", below 0.1: the limit of DMT; the work of adhesion and the radius decide, not the strength";
  if (surface.tabor > 5)
    return number + ", above 5: the limit of JKR; the work of adhesion and the radius decide, not the strength";
  return number + ", between the limits of DMT (0.1) and JKR (5): work of adhesion and strength both count";
}

std::string of_flat(const SurfaceNumbers& surface) {
  const std::string zone = fmt::format("the cohesive zone is {:.3g} of the surface's size, {:.4g} L0",
                                       surface.cohesive_zone / surface.extent, surface.extent);
  switch (regime(surface)) {
    case Regime::FlawTolerant:
      return "flaw-tolerant: " + zone +
             "; it comes off as a whole, at about strength times area, whatever the work of adhesion is";
    case Regime::Brittle:
      return fmt::format(
          "brittle: {}; from a flaw longer than the zone a crack runs: work of adhesion and stiffness decide, and a "
          "law with the same work and a strength down to {:.3g} E0 gives about the same force on coarser faces. "
          "Without such a flaw the force follows the strength: by a power of it where an edge concentrates the stress, "
          "else in proportion",
          zone, least_strength(surface));
    case Regime::Between:
      break;
  }
  return "between brittle and flaw-tolerant: " + zone + "; work of adhesion and strength both count";
}

}  // namespace

Regime regime(const SurfaceNumbers& surface) {
  if (surface.cohesive_zone >= surface.extent) return Regime::FlawTolerant;
  return surface.cohesive_zone > brittle_share * surface.extent ? Regime::Between : Regime::Brittle;
}

double least_strength(const SurfaceNumbers& surface) {
  // The zone grows with the inverse square of the strength.
  return surface.peak_traction * std::sqrt(surface.cohesive_zone / (brittle_share * surface.extent));
}

std::string regime_in_words(const SurfaceNumbers& surface) {
  if (!(surface.work > 0) || surface.is_electrode) return "";
  if (surface.radius > 0) return of_round(surface);
  const bool is_flat = surface.largest_gap - surface.least_gap < 0.02 * surface.extent;
  return is_flat ? of_flat(surface) : "neither flat nor round: it has no regime";
}

}  // namespace ixos
