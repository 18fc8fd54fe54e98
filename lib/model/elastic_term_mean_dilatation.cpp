#include "model/elastic_term_impl.hpp"

#include "fem/cell_types.hpp"
#include "fem/mean_dilatation_kernel.hpp"

namespace ixos {

std::unique_ptr<Term> make_mean_dilatation_term(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                                ElasticLaw law, const Lame& lame, int points) {
  return with_element(block.type, [&](auto element) {
    return make_kernel_term<MeanDilatationKernel, typename decltype(element)::type>(mesh, block, pattern, law, lame,
                                                                                    points);
  });
}

}  // namespace ixos
