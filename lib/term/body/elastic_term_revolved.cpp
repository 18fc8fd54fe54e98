#include "term/body/elastic_term_revolved.hpp"
#include "element/elastic_kernel.hpp"

namespace ixos {

std::unique_ptr<Elasticity> make_revolved_term(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                               const std::shared_ptr<const ElasticLaw>& law, int points,
                                               Formulation formulation) {
  if (formulation == Formulation::MeanDilatation) return make_revolved_mean_term(mesh, block, pattern, law, points);
  if (formulation == Formulation::Enhanced && block.type == CellType::Quad4)
    return make_revolved_enhanced_term(mesh, block, pattern, law, points);
  return with_plane_element(block.type, [&](auto element) {
    return make_ring_term<ElasticKernel, typename decltype(element)::type>(mesh, block, pattern, law, points);
  });
}

}  // namespace ixos
