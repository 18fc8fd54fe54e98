#include "fem/with_element.hpp"
#include "term/body/body_cells_of.hpp"

namespace ixos {

std::unique_ptr<BodyCells<RingSpace>> make_body_cells(RingSpace, const LocalMesh& mesh, const LocalBlock& block,
                                                      const Pattern& pattern, int points) {
  return with_plane_element(block.type, [&](auto element) -> std::unique_ptr<BodyCells<RingSpace>> {
    return std::make_unique<BodyCellsOf<Revolved<typename decltype(element)::type>>>(mesh, block, pattern, points);
  });
}

}  // namespace ixos
