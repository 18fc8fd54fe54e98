#include "fem/cell_type.hpp"  // whose names the elements below have, too

#include <stdexcept>

#include "element/enhanced_kernel.hpp"
#include "fem/reference_elements.hpp"
#include "term/body/elastic_term_impl.hpp"

namespace ixos {

std::unique_ptr<Elasticity> make_enhanced_term(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                               const std::shared_ptr<const ElasticLaw>& law, int points) {
  if (block.type == CellType::Quad4)
    return mesh.axisymmetric ? make_kernel_term<EnhancedKernel, Revolved<Quad4>>(mesh, block, pattern, law, points)
                             : make_kernel_term<EnhancedKernel, Quad4>(mesh, block, pattern, law, points);
  if (block.type == CellType::Hex8) return make_kernel_term<EnhancedKernel, Hex8>(mesh, block, pattern, law, points);
  throw std::logic_error("these cells have Standard elements only");
}

}  // namespace ixos
