#include "fem/cell_type.hpp"  // whose names the elements below have, too

#include <stdexcept>

#include "element/enhanced_kernel.hpp"
#include "element/projected_dilatation_kernel.hpp"
#include "term/body/elastic_term_revolved.hpp"

namespace ixos {

std::unique_ptr<Elasticity> make_revolved_mean_term(const LocalMesh& mesh, const LocalBlock& block,
                                                    const Pattern& pattern,
                                                    const std::shared_ptr<const ElasticLaw>& law, int points) {
  return with_plane_element(block.type, [&](auto element) -> std::unique_ptr<Elasticity> {
    using Element = typename decltype(element)::type;
    if constexpr (CellTraits<Element>::has_cures)
      return make_ring_term<DilatationKernel, Element>(mesh, block, pattern, law, points);
    else
      throw std::logic_error("these cells have Standard elements only");
  });
}

std::unique_ptr<Elasticity> make_revolved_enhanced_term(const LocalMesh& mesh, const LocalBlock& block,
                                                        const Pattern& pattern,
                                                        const std::shared_ptr<const ElasticLaw>& law, int points) {
  return make_ring_term<EnhancedKernel, Quad4>(mesh, block, pattern, law, points);
}

}  // namespace ixos
