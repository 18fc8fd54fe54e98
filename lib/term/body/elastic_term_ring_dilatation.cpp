#include "term/body/elastic_term_impl.hpp"

namespace ixos {

std::unique_ptr<Elasticity> make_ring_dilatation_term(const LocalMesh& mesh, const LocalBlock& block,
                                                      const Pattern& pattern,
                                                      const std::shared_ptr<const ElasticLaw>& law, int points) {
  return make_dilatation_term<2, true>(mesh, block, pattern, law, points);
}

}  // namespace ixos
