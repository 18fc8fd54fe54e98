#include <fmt/format.h>

#include "interaction/catalogue.hpp"
#include "interaction/damage_law.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/law_parameters.hpp"

namespace ixos {
namespace {

enum class Constants { Adhesion, Range };

struct Parameters {
  Constants constants = Constants::Adhesion;
  double work = default_work, strength = default_strength, range = 0, stiffness = 10;
  bool on_touch = false;
};

}  // namespace

LawEntry bilinear_damage_law() {
  Options<Parameters> options;
  options
      .choose_one("Constants", &Parameters::constants, {{"Adhesion", Constants::Adhesion}, {"Range", Constants::Range}},
                  {{"Adhesion", {"Work of Adhesion"}}, {"Range", {"Range"}}},
                  "The constant that a scene gives beside Strength and Stiffness: Work of Adhesion or Range.")
      .add("Work of Adhesion", &Parameters::work,
           "Work W that separates the surfaces once [E0 L0]. The range is d_f = 2 W/s0.", greater_than(0))
      .add("Strength", &Parameters::strength, "Largest attraction s0 [E0].", greater_than(0))
      .require("Range", &Parameters::range, "Gap d_f at which the bond is broken [L0].", greater_than(0))
      .add("Stiffness", &Parameters::stiffness,
           "Traction K per gap of the undamaged bond, and of an overlap [E0/L0]. The attraction is largest at the gap "
           "d0 = s0/K, which must be less than the range.",
           greater_than(0))
      .add(
          "Bond on Touch", &Parameters::on_touch,
          "Whether points that begin without a bond get one later. If true, a point that begins at a gap above d0 only "
          "repels, until a step ends at a gap of 0 or less; then its bond is whole. If false, bonds form at the start "
          "only, up to the range.");
  return {"Bilinear Damage",
          "A cohesive bond that does not heal: T(r) = -K r up to the gap d0 = s0/K, then T falls linearly to 0 at the "
          "gap d_f. Each point keeps the largest gap kappa that a step ended at. At smaller gaps T(r) = -(1 - D) K r "
          "with the damage D = d_f (kappa - d0)/(kappa (d_f - d0)). At negative gaps T(r) = -K r whatever the damage.",
          "Camanho and Davila 2002", options.list(), [options](const SceneNode& node) {
            const Parameters p = options.read(node);
            const bool adhesion = p.constants == Constants::Adhesion;
            const double range = adhesion ? 2 * p.work / p.strength : p.range, peak = p.strength / p.stiffness;
            const std::string names = std::string(adhesion ? "Work of Adhesion" : "Range") + ", Strength and Stiffness";
            check_derived(node, names, {{"range d_f", range}, {"gap d0 of largest attraction", peak}});
            if (!(peak < range))
              node.refuse("Stiffness", fmt::format("{} gives the gap of largest attraction s0/K = {:.6g}, which must "
                                                   "be less than the range, {:.6g}: more than {:.6g} is needed",
                                                   p.stiffness, peak, range, p.strength / range));
            check_derived(node, names, {{"slope s0/(d_f - d0)", p.strength / (range - peak)}});
            return gap_law(DamageLaw(p.stiffness, p.strength, range, p.on_touch));
          }};
}

}  // namespace ixos
