#include "interaction/friction_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.hpp"

namespace ixos {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void check(const Friction& friction) {
  const auto need = [](bool good, const char* what, double value, const char* allowed) {
    if (!good) throw InputError(fmt::format("the friction has the {} {}; it must be {}", what, value, allowed));
  };
  const auto at_least_zero = [&](const char* what, double value) {
    need(std::isfinite(value) && value >= 0, what, value, "finite and at least 0");
  };
  const auto positive = [&](const char* what, double value) {
    need(std::isfinite(value) && value > 0, what, value, "finite and greater than 0");
  };
  if (friction.type == FrictionType::None) throw InputError("the friction has no type");
  need(friction.cutoff_share >= 0 && friction.cutoff_share <= 1, "cutoff share", friction.cutoff_share,
       "at least 0 and at most 1");
  if (friction.type == FrictionType::ConstantStress) {
    at_least_zero("stress", friction.stress);
    at_least_zero("sharpness", friction.sharpness);
  } else {
    at_least_zero("coefficient", friction.coefficient);
  }
  if (friction.type == FrictionType::Smoothed)
    positive("slip speed", friction.slip_speed);
  else
    at_least_zero("stiffness", friction.stiffness);
}

}  // namespace

FrictionLaw::FrictionLaw(const Friction& friction, std::shared_ptr<const GapLaw> law)
    : friction_(friction),
      law_(std::move(law)),
      cutoff_(friction.cutoff_share * law_->adhesion_gap() + (1 - friction.cutoff_share) * law_->equilibrium_gap()) {
  check(friction);
  check_fit();
  if (friction.type != FrictionType::ConstantStress) traction_at_cutoff_ = law_->traction(cutoff_)[0];
  if (friction_.stiffness == 0) friction_.stiffness = default_stiffness();
}

double FrictionLaw::default_stiffness() const {
  constexpr double elastic_share = 0.003, stiffest = 100;
  const double gap = law_->equilibrium_gap(), attraction = std::abs(law_->traction(law_->adhesion_gap())[0]);
  const double threshold =
      friction_.type == FrictionType::ConstantStress ? friction_.stress : friction_.coefficient * attraction;
  const double stiffness = std::min(threshold / (elastic_share * gap), stiffest * attraction / gap);
  return std::isfinite(stiffness) && stiffness > 0 ? stiffness : 50;
}

void FrictionLaw::check_fit() const {
  const bool follows_traction = friction_.type != FrictionType::ConstantStress;
  if (follows_traction && law_->has_history())
    throw InputError(
        "the threshold of the friction follows the traction of a law with a history; use the type \"Constant Stress\"");
  if (follows_traction && !law_->repels())
    throw InputError(
        "the threshold of the friction grows with repulsion, but the law only attracts: give the friction to the "
        "interaction that repels, or use the type \"Constant Stress\"");
  // The equilibrium gap of other laws is a scale, at which the traction may be any.
  if (friction_.cutoff_share < 1 && (law_->has_history() || !law_->repels()))
    throw InputError(
        fmt::format("the friction has the cutoff share {}, but the law {}: it must be 1", friction_.cutoff_share,
                    law_->has_history() ? "has a history" : "only attracts, without a gap of equilibrium"));
  if (needs_positive_gaps() && !(cutoff_ > 0))
    throw InputError(
        fmt::format("the friction acts at gaps below {:.6g}, the gap of the law's largest attraction, which no surface "
                    "reaches: give the friction to another interaction of the side set",
                    cutoff_));
}

Pack FrictionLaw::threshold(const Pack& gap) const {
  const auto acts = gap < cutoff_ && gap > -infinity;
  if (friction_.type == FrictionType::ConstantStress) {
    if (friction_.sharpness == 0) return select(acts, Pack(friction_.stress), Pack(0.0));
    const Pack weight = std::experimental::exp(Pack(friction_.sharpness * (gap - cutoff_)));
    return select(gap > -infinity, Pack(friction_.stress / (1.0 + weight)), Pack(0.0));
  }
  const Pack excess = law_->traction(select(acts, gap, Pack(cutoff_))) - traction_at_cutoff_;
  return select(excess > 0.0, Pack(friction_.coefficient * excess), Pack(0.0));
}

double FrictionLaw::threshold_at(double gap) const { return threshold(gap)[0]; }

Pack FrictionLaw::slope(const Pack& gap) const {
  if (friction_.type == FrictionType::ConstantStress) {
    if (friction_.sharpness == 0) return 0.0;
    // With x = |k (g - g_cut)|, so that nothing overflows.
    const Pack x = std::experimental::abs(Pack(friction_.sharpness * (gap - cutoff_)));
    const Pack weight = std::experimental::exp(-x), sum = 1.0 + weight;
    return select(gap > -infinity, Pack(-friction_.stress * friction_.sharpness * weight / (sum * sum)), Pack(0.0));
  }
  const auto acts = gap < cutoff_ && gap > -infinity;
  const Pack place = select(acts, gap, Pack(cutoff_));
  const auto slides = acts && law_->traction(place) > traction_at_cutoff_;
  return select(slides, Pack(-friction_.coefficient * law_->stiffness(place)), Pack(0.0));
}

}  // namespace ixos
