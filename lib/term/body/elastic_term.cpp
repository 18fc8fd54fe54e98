#include "base/error.hpp"
#include "fem/cell_info.hpp"
#include "term/body/elastic_terms.hpp"

namespace ixos {

bool has_action(Formulation formulation) { return formulation == Formulation::Standard; }

std::unique_ptr<Elasticity> make_elastic_term(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                              const std::shared_ptr<const ElasticLaw>& law, int points,
                                              Formulation formulation) {
  if (formulation == Formulation::Enhanced && is_quadratic(block.type))
    throw InputError("block \"" + block.name +
                     "\": quadratic cells do not lock in bending and have no Enhanced formulation; use Standard, or "
                     "Mean Dilatation for nearly incompressible materials");
  if (formulation != Formulation::Standard && cell_info(block.type).constant_strain)
    throw InputError(
        "block \"" + block.name +
        "\": the strain of linear triangles is constant, so that neither Mean Dilatation nor Enhanced changes "
        "them; use Standard, or quadrilaterals");
  if (formulation == Formulation::MeanDilatation) {
    const auto make = mesh.axisymmetric     ? make_ring_dilatation_term
                      : mesh.dimension == 2 ? make_plane_dilatation_term
                                            : make_solid_dilatation_term;
    return make(mesh, block, pattern, law, points);
  }
  const bool enhanced = formulation == Formulation::Enhanced && !is_enriched(block.type);
  return (enhanced ? make_enhanced_term : make_standard_term)(mesh, block, pattern, law, points);
}

}  // namespace ixos
