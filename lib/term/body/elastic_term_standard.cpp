#include "term/body/elastic_term_impl.hpp"

#include "base/error.hpp"
#include "element/elastic_kernel.hpp"
#include "fem/cell_info.hpp"
#include "fem/with_element.hpp"

namespace ixos {

namespace {

bool is_compiled_in(const ElasticLaw& law) {
  return dynamic_cast<const ElasticLawOf<NeoHooke>*>(&law) != nullptr ||
         dynamic_cast<const ElasticLawOf<LinearElastic>*>(&law) != nullptr;
}

}  // namespace

bool has_action(Formulation formulation) { return formulation == Formulation::Standard; }

std::unique_ptr<Elasticity> make_elastic_term(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                              const std::shared_ptr<const ElasticLaw>& law, int points,
                                              Formulation formulation) {
  if (formulation == Formulation::Enhanced && is_quadratic(block.type))
    throw InputError("block \"" + block.name +
                     "\": quadratic cells do not lock in bending and have no Enhanced formulation; use Standard, or "
                     "Mean Dilatation for nearly incompressible materials");
  if (formulation != Formulation::Standard && !cell_info(block.type).has_cures)
    throw InputError(
        "block \"" + block.name +
        "\": the strain of linear triangles is constant, so that neither Mean Dilatation nor Enhanced changes "
        "them; use Standard, or quadrilaterals");
  if (mesh.axisymmetric) return make_revolved_term(mesh, block, pattern, law, points, formulation);
  if (!is_compiled_in(*law)) return make_any_term(mesh, block, pattern, law, points, formulation);
  if (formulation == Formulation::MeanDilatation) return make_mean_dilatation_term(mesh, block, pattern, law, points);
  if (formulation == Formulation::Enhanced && !is_enriched(block.type))
    return make_enhanced_term(mesh, block, pattern, law, points);
  return with_element(block.type, [&](auto element) {
    return make_kernel_term<ElasticKernel, typename decltype(element)::type>(mesh, block, pattern, law, points);
  });
}

}  // namespace ixos
