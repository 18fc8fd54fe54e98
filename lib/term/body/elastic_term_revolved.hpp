/// The elastic terms of bodies of revolution; included only where they are made, see elastic_term_impl.hpp.
#pragma once
#include "fem/revolved.hpp"
#include "fem/with_element.hpp"
#include "material/revolved_law.hpp"
#include "term/body/elastic_term_impl.hpp"

namespace ixos {

/// Returns the term of Kernel<Revolved<Element>, RevolvedLaw<law>>.
template <template <class, class> class Kernel, class Element>
std::unique_ptr<Elasticity> make_ring_term(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                           const std::shared_ptr<const ElasticLaw>& law, int points) {
  const auto make = [&](const auto& own) -> std::unique_ptr<Elasticity> {
    using Law = RevolvedLaw<std::decay_t<decltype(own)>>;
    return std::make_unique<ElasticTerm<Kernel<Revolved<Element>, Law>>>(mesh, block, pattern, Law(own), points);
  };
  if (const auto* own = dynamic_cast<const ElasticLawOf<NeoHooke>*>(law.get())) return make(own->law());
  if (const auto* own = dynamic_cast<const ElasticLawOf<LinearElastic>*>(law.get())) return make(own->law());
  return make(AnyElasticLaw(law));
}

/// Separate files define these functions, so that they compile apart. An enhanced block is not enriched.
std::unique_ptr<Elasticity> make_revolved_mean_term(const LocalMesh& mesh, const LocalBlock& block,
                                                    const Pattern& pattern,
                                                    const std::shared_ptr<const ElasticLaw>& law, int points);
std::unique_ptr<Elasticity> make_revolved_enhanced_term(const LocalMesh& mesh, const LocalBlock& block,
                                                        const Pattern& pattern,
                                                        const std::shared_ptr<const ElasticLaw>& law, int points);

}  // namespace ixos
