#include "term/elastic_term_impl.hpp"

#include "element/projected_dilatation_kernel.hpp"
#include "fem/with_element.hpp"

namespace ixos {

std::unique_ptr<Elasticity> make_mean_dilatation_term(const LocalMesh& mesh, const LocalBlock& block,
                                                      const Pattern& pattern,
                                                      const std::shared_ptr<const ElasticLaw>& law, int points) {
  return with_element(block.type, [&](auto element) {
    return make_kernel_term<DilatationKernel, typename decltype(element)::type>(mesh, block, pattern, law, points);
  });
}

}  // namespace ixos
