#include "material/catalogue.hpp"

#include "parameters/range_validator.hpp"

namespace ixos {

#define ENTRY(name) ElasticEntry name();
#include "material/laws.def"
#undef ENTRY

const Catalogue<ElasticEntry>& elastic_laws() {
#define ENTRY(name) name(),
  static const Catalogue<ElasticEntry> catalogue("Model", "Elastic law.",
                                                 {
#include "material/laws.def"
                                                 });
#undef ENTRY
  return catalogue;
}

std::shared_ptr<const ElasticLaw> make_elastic_law(const std::string& name, const Settings& settings) {
  return elastic_laws().make_named("elastic law", name, settings);
}

Options<IsotropicConstants> isotropic_options() {
  Options<IsotropicConstants> options;
  options.add("Young's Modulus", &IsotropicConstants::young, "Young's modulus E [E0].", greater_than(0))
      .add("Poisson's Ratio", &IsotropicConstants::poisson, "Poisson's ratio nu [-].", greater_and_less_than(-1, 0.5));
  return options;
}

}  // namespace ixos
