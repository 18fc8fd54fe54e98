#include "scene/read/friction.hpp"

#include <fmt/format.h>

#include "interaction/friction_law.hpp"
#include "interaction/gap_law.hpp"
#include "parameters/range_validator.hpp"

namespace ixos {
namespace {

constexpr const char *none = "None", *constant = "Constant Stress", *amontons = "Extended Amontons",
                     *smoothed = "Smoothed";

}  // namespace

const Options<Friction>& friction_options() {
  static const Options<Friction> all =
      Options<Friction>()
          .choose_one(
              "Type", &Friction::type,
              {{none, FrictionType::None},
               {constant, FrictionType::ConstantStress},
               {amontons, FrictionType::ExtendedAmontons},
               {smoothed, FrictionType::Smoothed}},
              {{none, {}},
               {constant, {"Stress", "Sharpness", "Stiffness", "Cutoff Share", "Threshold"}},
               {amontons, {"Coefficient", "Stiffness", "Cutoff Share", "Threshold"}},
               {smoothed, {"Coefficient", "Slip Speed", "Cutoff Share", "Threshold"}}},
              "The threshold T_s of the traction along the obstacle, at gaps below g_cut (Mergel, Sahli, Scheibert and "
              "Sauer 2019). \"Constant Stress\": tau. \"Extended Amontons\": mu (T(g) - T(g_cut)) with the law's "
              "traction T, positive for repulsion; a contact without load slides at mu times the largest attraction if "
              "Cutoff Share is 1. Below the threshold the traction is that of a spring, eps times the elastic slip; "
              "beyond, the surface slides. \"Smoothed\": the threshold of \"Extended Amontons\" without a spring: the "
              "traction grows smoothly from 0 to T_s with the slip of a step, so a surface that sticks creeps (Li et "
              "al. 2020).")
          .require("Stress", &Friction::stress, "Threshold tau [E0].", at_least(0))
          .add("Sharpness", &Friction::sharpness,
               "k: the threshold is tau/(1 + exp(k (g - g_cut))) at every gap g [1/L0]. With 0 it drops to 0 at g_cut.",
               at_least(0))
          .require("Coefficient", &Friction::coefficient, "Coefficient of friction mu [-].", at_least(0))
          .add(
              "Cutoff Share", &Friction::cutoff_share,
              "c: friction acts at gaps below g_cut = c g_max + (1 - c) r_eq, with the gap g_max of largest attraction "
              "and the gap r_eq of equilibrium [-]. With 0 only surfaces that are pressed resist slip.",
              between(0, 1))
          .add(
              "Stiffness", &Friction::stiffness,
              "Traction eps per elastic slip [E0/L0]. The surface slides when the elastic slip reaches T_s/eps. With 0 "
              "the elastic slip before sliding is 0.003 r_eq at a threshold of tau, or of mu times the largest "
              "attraction s0; but eps is at most 100 s0/r_eq. A law without "
              "attraction gets 50 E0/L0.",
              at_least(0))
          .require("Slip Speed", &Friction::slip_speed,
                   "Speed eps_v of slip at which the traction reaches the threshold [L0/T0].", greater_than(0))
          .choose("Threshold", &Friction::current, {{"Lagged", false}, {"Current", true}},
                  "The gap that sets the threshold of a step: \"Lagged\": that at its start; the tangent is symmetric. "
                  "\"Current\": that at its end; the tangent is unsymmetric, and the linear solver has to be one for "
                  "such matrices.");
  return all;
}

std::string friction_in_words(const Friction& friction, const std::shared_ptr<const GapLaw>& law) {
  if (friction.type == FrictionType::None) return "";
  const FrictionLaw threshold(friction, law);
  const double equilibrium = law->equilibrium_gap(), at_rest = threshold.threshold_at(equilibrium);
  std::string text =
      friction.type == FrictionType::ConstantStress
          ? fmt::format("  Friction: {}, threshold {:.6g} E0", constant, friction.stress)
          : fmt::format("  Friction: {}, coefficient {:.6g}, threshold {:.6g} E0 at the equilibrium gap",
                        friction.type == FrictionType::Smoothed ? smoothed : amontons, friction.coefficient, at_rest);
  text += fmt::format(", below a gap of {:.6g} L0", threshold.cutoff());
  if (friction.type == FrictionType::Smoothed)
    text += fmt::format("; full above a slip speed of {:.6g} L0/T0", friction.slip_speed);
  else
    text += fmt::format(
        "; elastic slip up to {:.3g} L0",
        (friction.type == FrictionType::ConstantStress ? friction.stress : at_rest) / threshold.friction().stiffness);
  return text + "; what it stores is part of contact_energy, what it dissipates of dissipated_energy\n";
}

}  // namespace ixos
