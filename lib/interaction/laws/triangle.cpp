#include <fmt/format.h>

#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/law_parameters.hpp"
#include "interaction/piecewise_law.hpp"

namespace ixos {
namespace {

enum class Constants { Adhesion, Range };

struct Parameters {
  Constants constants = Constants::Adhesion;
  double work = default_work, strength = default_strength, range = 0, peak = 0.1;
};

PiecewiseLaw make(double strength, double peak, double range) {
  return {{{0, 0, {0, 0, 0, 0}},
           {peak, 0, {0, -strength / peak, 0, 0}},
           {range, range, {0, strength / (range - peak), 0, 0}}},
          range / 2,
          peak};
}

}  // namespace

LawEntry triangle_law() {
  Options<Parameters> options;
  options
      .choose_one("Constants", &Parameters::constants, {{"Adhesion", Constants::Adhesion}, {"Range", Constants::Range}},
                  {{"Adhesion", {"Work of Adhesion"}}, {"Range", {"Range"}}},
                  "The constant that a scene gives beside Strength: Work of Adhesion or Range.")
      .add("Work of Adhesion", &Parameters::work, "Work of adhesion W [E0 L0]. The range is 2 W/s0.", greater_than(0))
      .add("Strength", &Parameters::strength, "Largest attraction s0 [E0].", greater_than(0))
      .require("Range", &Parameters::range, "Gap r_a at which the attraction ends [L0].", greater_than(0))
      .add("Peak Gap", &Parameters::peak, "Gap r_p of largest attraction, less than the range [L0].", greater_than(0));
  return {"Triangle",
          "The attraction grows linearly from 0 at a gap of 0 to s0 at r_p, and falls linearly to 0 at r_a. It only "
          "attracts: another interaction of the side set has to repel.",
          "Fang et al. 2023", options.list(), [options](const SceneNode& node) {
            const Parameters p = options.read(node);
            const bool adhesion = p.constants == Constants::Adhesion;
            const double range = adhesion ? 2 * p.work / p.strength : p.range;
            const char* names = adhesion ? "Work of Adhesion and Strength" : "Range and Strength";
            check_derived(node, names, {{"range", range}});
            if (!(p.peak < range))
              node.refuse("Peak Gap", fmt::format("{} must be less than the range, {}", p.peak, range));
            check_derived(
                node, "Peak Gap and Strength",
                {{"slope s0/r_p", p.strength / p.peak}, {"slope s0/(r_a - r_p)", p.strength / (range - p.peak)}});
            return gap_law(make(p.strength, p.peak, range));
          }};
}

}  // namespace ixos
