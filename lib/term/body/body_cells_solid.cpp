#include "fem/with_element.hpp"
#include "term/body/body_cells_of.hpp"

namespace ixos {

std::unique_ptr<BodyCells<SolidSpace>> make_body_cells(SolidSpace, const LocalMesh& mesh, const LocalBlock& block,
                                                       const Pattern& pattern, int points) {
  return with_solid_element(block.type, [&](auto element) -> std::unique_ptr<BodyCells<SolidSpace>> {
    return std::make_unique<BodyCellsOf<typename decltype(element)::type>>(mesh, block, pattern, points);
  });
}

}  // namespace ixos
