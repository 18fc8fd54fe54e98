#include <fmt/format.h>

#include "base/error.hpp"
#include "fem/cell_info.hpp"
#include "term/body/elastic_terms.hpp"

namespace ixos {

bool has_action(Formulation formulation) { return formulation == Formulation::Standard; }

std::unique_ptr<Elasticity> make_elastic_term(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                              const std::shared_ptr<const ElasticLaw>& law, int points,
                                              Formulation formulation) {
  const CellInfo& info = cell_info(block.type);
  if (formulation == Formulation::Enhanced && is_quadratic(block.type))
    throw InputError("block \"" + block.name +
                     "\": quadratic cells do not lock in bending and have no Enhanced formulation; use Standard, or "
                     "Mean Dilatation for nearly incompressible materials");
  if (formulation == Formulation::Enhanced && !is_cube(block.type))
    throw InputError(fmt::format("block \"{}\": {} cells have no Enhanced formulation; use Standard with Cell Order 2",
                                 block.name, info.name));
  if (formulation == Formulation::MeanDilatation && info.constant_strain)
    throw InputError(
        fmt::format("block \"{}\": the strain of {} cells is constant, so that Mean Dilatation does not "
                    "change them; use Cell Order 2",
                    block.name, info.name));
  if (formulation == Formulation::MeanDilatation && !is_cube(block.type) && !info.bubbles)
    throw InputError(
        fmt::format("block \"{}\": {} cells have too few nodes for Mean Dilatation; {} cells have enough ({})",
                    block.name, info.name, cell_info(raised_type(info.corners, true)).name,
                    info.order == 1 ? "Cell Order 2" : "raise_order() with bubbles"));
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
