#include <fmt/format.h>

#include <utility>

#include "base/error.hpp"
#include "material/catalogue.hpp"
#include "material/elastic_law.hpp"
#include "material/laws/compressibility.hpp"
#include "material/ogden_law.hpp"
#include "material/strain_law.hpp"

namespace ixos {
namespace {

struct Parameters : Compressibility {
  std::vector<double> moduli{0.6}, exponents{1.3};
};

std::shared_ptr<const ElasticLaw> ogden(const Parameters& p) {
  if (p.moduli.empty() || p.moduli.size() != p.exponents.size())
    throw InputError(
        fmt::format("Moduli has {} numbers and Exponents {}: both need one number for each term, and at "
                    "least one",
                    p.moduli.size(), p.exponents.size()));
  double mu = 0;
  std::vector<OgdenLaw::Term> terms;
  for (std::size_t i = 0; i < p.moduli.size(); ++i) {
    if (p.exponents[i] == 0) throw InputError(fmt::format("Exponents: number {} is 0; it must not be 0", i + 1));
    mu += p.moduli[i] * p.exponents[i] / 2;
    terms.push_back({p.moduli[i], p.exponents[i]});
  }
  if (!(mu > 0))
    throw InputError(
        fmt::format("Moduli and Exponents: the shear modulus, half the sum of their products, is {}; it "
                    "must be greater than 0",
                    mu));
  return elastic_law(StrainLaw(OgdenLaw{std::move(terms), p.volumetric(mu), p.lame(mu)}));
}

}  // namespace

ElasticEntry ogden_entry() {
  Options<Parameters> options;
  options
      .add("Moduli", &Parameters::moduli,
           "Constants mu_p of the terms [E0]. The shear modulus is half the sum of mu_p alpha_p.", any_number())
      .add("Exponents", &Parameters::exponents, "Exponents alpha_p of the terms [-], not 0.", any_number());
  add_compressibility(options);
  return {"Ogden",
          "Ogden: W = sum of mu_p/alpha_p (l1^alpha_p + l2^alpha_p + l3^alpha_p - 3) + U(J), with the isochoric "
          "principal stretches l1, l2 and l3; any number of terms.",
          "Ogden 1972; Holzapfel 2000, section 6.5", options.list(),
          [options](const SceneNode& node) { return ogden(options.read(node)); }};
}

}  // namespace ixos
