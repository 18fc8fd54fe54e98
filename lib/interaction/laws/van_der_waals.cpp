#include "interaction/van_der_waals.hpp"

#include <fmt/format.h>

#include "interaction/catalogue.hpp"

namespace ixos {

LawEntry van_der_waals_law() {
  struct Parameters {
    double gamma_length = 2.5, gamma_energy = 25;
  };
  Options<Parameters> options;
  options
      .add("Gamma L", &Parameters::gamma_length,
           "Van der Waals: ratio L0/r0, where r0 is the length scale of the law [-].", greater_than(0))
      .add("Gamma W", &Parameters::gamma_energy,
           "Van der Waals: ratio E0/W0, where W0 is the energy density scale of the law [-].", greater_than(0));
  return {"Van der Waals",
          "Van der Waals integrates the Lennard-Jones potential over the half-space: at a gap r the traction is T(r) = "
          "c1/r^9 - c2/r^3.",
          "Sauer and Wriggers 2009",
          options.list(),
          [options](const SceneNode& node) {
            const Parameters p = options.read(node);
            const VanDerWaals law(p.gamma_length, p.gamma_energy);
            if (!std::isfinite(law.c1()) || !(law.c1() > 0) || !std::isfinite(law.c2()) || !(law.c2() > 0))
              node.refuse("",
                          fmt::format("Gamma L and Gamma W are too extreme: c1 = {} and c2 = {} must be positive and "
                                      "finite",
                                      law.c1(), law.c2()));
            return gap_law(law);
          },
          true};
}

}  // namespace ixos
