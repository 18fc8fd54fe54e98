#include "model/elastic_term_impl.hpp"

#include "fem/cell_types.hpp"
#include "fem/elastic_kernel.hpp"

namespace ixos {

std::unique_ptr<Term> make_elastic_term(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                        ElasticLaw law, const Lame& lame, int points, Formulation formulation) {
  const bool enriched = block.type != CellType::Quad4 && block.type != CellType::Hex8;
  if (formulation == Formulation::MeanDilatation)
    return make_mean_dilatation_term(mesh, block, pattern, law, lame, points);
  if (formulation == Formulation::Enhanced && !enriched)
    return make_enhanced_term(mesh, block, pattern, law, lame, points);
  return with_element(block.type, [&](auto element) {
    return make_kernel_term<ElasticKernel, typename decltype(element)::type>(mesh, block, pattern, law, lame, points);
  });
}

}  // namespace ixos
