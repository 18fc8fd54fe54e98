#include "term/body/elastic_term_impl.hpp"

#include <stdexcept>

#include "element/projected_dilatation_kernel.hpp"
#include "fem/with_element.hpp"

namespace ixos {

std::unique_ptr<Elasticity> make_mean_dilatation_term(const LocalMesh& mesh, const LocalBlock& block,
                                                      const Pattern& pattern,
                                                      const std::shared_ptr<const ElasticLaw>& law, int points) {
  return with_element(block.type, [&](auto element) -> std::unique_ptr<Elasticity> {
    using Element = typename decltype(element)::type;
    if constexpr (CellTraits<Element>::has_cures)
      return make_kernel_term<DilatationKernel, Element>(mesh, block, pattern, law, points);
    else
      throw std::logic_error("these cells have Standard elements only");
  });
}

}  // namespace ixos
