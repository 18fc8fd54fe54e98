#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/law_parameters.hpp"
#include "interaction/piecewise_law.hpp"

namespace ixos {
namespace {

struct Parameters {
  double stiffness = 10, gap = 0.25;
};

}  // namespace

LawEntry penalty_law() {
  Options<Parameters> options;
  options.add("Stiffness", &Parameters::stiffness, "Penalty e, the pressure per overlap [E0/L0].", greater_than(0))
      .add("Gap", &Parameters::gap, "Gap r_c below which the surface is pushed away [L0].", greater_than(0));
  return {"Penalty",
          "T(r) = e (r_c - r) below the gap r_c. It only repels, and its finite repulsion allows penetration.",
          "Wriggers 2006", options.list(), [options](const SceneNode& node) {
            const Parameters p = options.read(node);
            check_derived(node, "Stiffness and Gap", {{"pressure e r_c", p.stiffness * p.gap}});
            return gap_law(PiecewiseLaw({{p.gap, p.gap, {0, -p.stiffness, 0, 0}}}, p.gap, p.gap));
          }};
}

}  // namespace ixos
