#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/law_parameters.hpp"
#include "interaction/piecewise_law.hpp"

namespace ixos {
namespace {

enum class Constants { Adhesion, Range };

struct Parameters {
  Constants constants = Constants::Adhesion;
  double work = default_work, strength = default_strength, range = 0, smoothing = 0.2;
};

}  // namespace

LawEntry smooth_dugdale_law() {
  Options<Parameters> options;
  options
      .choose_one("Constants", &Parameters::constants, {{"Adhesion", Constants::Adhesion}, {"Range", Constants::Range}},
                  {{"Adhesion", {"Work of Adhesion"}}, {"Range", {"Range"}}},
                  "The constant that a scene gives beside Strength: Work of Adhesion or Range.")
      .add("Work of Adhesion", &Parameters::work,
           "Work of adhesion W from a gap of 0 on [E0 L0]. The range is h0 = W/s0.", greater_than(0))
      .add("Strength", &Parameters::strength, "Constant attraction s0 [E0].", greater_than(0))
      .require("Range", &Parameters::range, "Gap h0 at which half of the attraction is left [L0].", greater_than(0))
      .add("Smoothing", &Parameters::smoothing,
           "Ratio w/h0 [-]: the attraction ends by a cubic polynomial from h0 - w to h0 + w. The work of adhesion does "
           "not depend on it.",
           greater_than_and_at_most(0, 1));
  return {"Smooth Dugdale",
          "T(r) = -s0 up to the gap h0, where it ends smoothly. It only attracts: another interaction of the side set "
          "has to repel.",
          "Maugis 1992", options.list(), [options](const SceneNode& node) {
            const Parameters p = options.read(node);
            const bool adhesion = p.constants == Constants::Adhesion;
            const double range = adhesion ? p.work / p.strength : p.range, ramp = p.smoothing * range;
            check_derived(node, adhesion ? "Work of Adhesion, Strength and Smoothing" : "Range, Strength and Smoothing",
                          {{"range h0", range}, {"largest slope 3 s0/(4 w)", 0.75 * p.strength / ramp}});
            return gap_law(constant_attraction(p.strength, range, ramp));
          }};
}

}  // namespace ixos
