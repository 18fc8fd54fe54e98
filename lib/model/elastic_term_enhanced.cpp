#include "model/elastic_term_impl.hpp"

#include "fem/enhanced_kernel.hpp"
#include "fem/reference_elements.hpp"

namespace ixos {

std::unique_ptr<Term> make_enhanced_term(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                         ElasticLaw law, const Lame& lame, int points) {
  if (block.type == CellType::Quad4)
    return make_kernel_term<EnhancedKernel, Quad4>(mesh, block, pattern, law, lame, points);
  return make_kernel_term<EnhancedKernel, Hex8>(mesh, block, pattern, law, lame, points);
}

}  // namespace ixos
