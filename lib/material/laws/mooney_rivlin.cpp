#include <fmt/format.h>

#include "base/error.hpp"
#include "material/catalogue.hpp"
#include "material/elastic_law.hpp"
#include "material/laws/compressibility.hpp"
#include "material/mooney_rivlin.hpp"
#include "material/strain_law.hpp"

namespace ixos {
namespace {

struct Parameters : Compressibility {
  double c10 = 0.15, c01 = 0.05;
};

}  // namespace

ElasticEntry mooney_rivlin_entry() {
  Options<Parameters> options;
  options.add("C10", &Parameters::c10, "Constant c10 of I1 - 3 [E0].", any_number())
      .add("C01", &Parameters::c01, "Constant c01 of I2 - 3 [E0]. 2 (c10 + c01), the shear modulus, must be positive.",
           any_number());
  add_compressibility(options);
  return {"Mooney-Rivlin",
          "Mooney-Rivlin: W = c10 (I1 - 3) + c01 (I2 - 3) + U(J), with the isochoric invariants I1 and I2.",
          "Holzapfel 2000, section 6.5", options.list(), [options](const SceneNode& node) {
            const Parameters p = options.read(node);
            const double mu = 2 * (p.c10 + p.c01);
            if (!(mu > 0))
              throw InputError(fmt::format("C10 {} and C01 {}: their sum must be greater than 0", p.c10, p.c01));
            return elastic_law(StrainLaw(IsochoricLaw<MooneyRivlin>{{p.c10, p.c01}, p.volumetric(mu), p.lame(mu)}));
          }};
}

}  // namespace ixos
