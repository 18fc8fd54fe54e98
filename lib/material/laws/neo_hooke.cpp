#include "material/neo_hooke.hpp"

#include "material/catalogue.hpp"
#include "material/elastic_law.hpp"

namespace ixos {

std::shared_ptr<const ElasticLaw> neo_hooke(const Lame& lame) { return elastic_law(NeoHooke{lame}); }

ElasticEntry neo_hooke_entry() {
  return {"Neo-Hooke",
          "Neo-Hooke: W = mu/2 (tr B - 3) - mu ln J + lambda/2 (ln J)^2.",
          "Zienkiewicz and Taylor 2005",
          isotropic_options().list(),
          [](const SceneNode& node) { return neo_hooke(isotropic_options().read(node).lame()); },
          true};
}

}  // namespace ixos
