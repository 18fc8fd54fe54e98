#include "material/linear_elastic.hpp"

#include "material/catalogue.hpp"
#include "material/elastic_law.hpp"

namespace ixos {

std::shared_ptr<const ElasticLaw> linear_elastic(const Lame& lame) { return elastic_law(LinearElastic{lame}); }

ElasticEntry linear_elastic_entry() {
  return {"Linear Elastic",
          "Linear Elastic: Hooke's law for small strains and small rotations.",
          "",
          isotropic_options().list(),
          [](const SceneNode& node) { return linear_elastic(isotropic_options().read(node).lame()); },
          true};
}

}  // namespace ixos
