#include "fem/cell_type.hpp"  // whose names the elements below have, too

#include "element/enhanced_kernel.hpp"
#include "element/projected_dilatation_kernel.hpp"
#include "fem/with_element.hpp"
#include "term/body/elastic_term_impl.hpp"

namespace ixos {
namespace {

template <template <class, class> class Kernel, class Element>
std::unique_ptr<Elasticity> make(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                 const std::shared_ptr<const ElasticLaw>& law, int points) {
  return std::make_unique<ElasticTerm<Kernel<Element, AnyElasticLaw>>>(mesh, block, pattern, AnyElasticLaw(law),
                                                                       points);
}

}  // namespace

std::unique_ptr<Elasticity> make_any_term(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                          const std::shared_ptr<const ElasticLaw>& law, int points,
                                          Formulation formulation) {
  if (formulation == Formulation::Enhanced && block.type == CellType::Quad4)
    return make<EnhancedKernel, Quad4>(mesh, block, pattern, law, points);
  if (formulation == Formulation::Enhanced && block.type == CellType::Hex8)
    return make<EnhancedKernel, Hex8>(mesh, block, pattern, law, points);
  return with_element(block.type, [&](auto element) {
    using Element = typename decltype(element)::type;
    if constexpr (CellTraits<Element>::has_cures)
      if (formulation == Formulation::MeanDilatation)
        return make<DilatationKernel, Element>(mesh, block, pattern, law, points);
    return make<ElasticKernel, Element>(mesh, block, pattern, law, points);
  });
}

}  // namespace ixos
