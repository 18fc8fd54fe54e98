#include "model/surface_forces.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/error.hpp"
#include "geometry/patch_points.hpp"
#include "interaction/gap_law.hpp"

namespace ixos {
namespace {

/// Returns why a cutoff is not allowed; empty if it is.
std::string why_no_cutoff(const GapLaw& law, double cutoff) {
  if (cutoff == 0) return "";
  const bool attracts = !law.repels() || work_of_adhesion(law) > 0;
  if (!(cutoff > law.adhesion_gap()))
    return fmt::format("cuts off the {}; it must be 0, or greater than {}, {:.6g}",
                       attracts ? "attraction" : "repulsion",
                       attracts ? "the gap of largest attraction" : "the gap at which it ends", law.adhesion_gap());
  if (law.has_history() && cutoff < law.range())
    return fmt::format("cuts off a law with a history, which ends by itself at {:.6g}; it must be 0", law.range());
  return "";
}

}  // namespace

std::shared_ptr<const GapLaw> acting_law(const SurfaceForces& forces) {
  return forces.cutoff > 0 ? forces.law->cut_off(forces.cutoff) : forces.law;
}

std::optional<Refusal> refusal_of_forces(const SurfaceForces& forces) {
  if (!forces.law) return Refusal{"Law", "", "is missing"};
  if (forces.points < 0 || forces.points > most_points_on_a_side)
    return Refusal{"Surface Points", std::to_string(forces.points),
                   fmt::format("is out of range: 0 to {} Gauss points a direction are allowed", most_points_on_a_side)};
  if (!(forces.margin > 0 && forces.margin < 1))
    return Refusal{"Step Margin", fmt::format("{}", forces.margin), "must be greater than 0 and less than 1"};
  if (std::string why = why_no_cutoff(*forces.law, forces.cutoff); !why.empty())
    return Refusal{"Cutoff", fmt::format("{}", forces.cutoff), std::move(why)};
  const Friction& friction = forces.friction;
  if (friction.type == FrictionType::ConstantStress && friction.current && friction.sharpness == 0)
    return Refusal{"Friction/Threshold", "\"Current\"",
                   "with the Type \"Constant Stress\" and the Sharpness 0: the traction would jump within a step where "
                   "the gap passes g_cut, and Newton's method fails there; use \"Lagged\", or a Sharpness greater than "
                   "0"};
  return std::nullopt;
}

}  // namespace ixos
