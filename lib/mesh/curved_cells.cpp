#include "mesh/curved_cells.hpp"

#include <algorithm>
#include <cmath>

#include "fem/cell_info.hpp"

namespace ixos {

bool needs_high_rule(const Mesh& mesh, const ElementBlock& block) {
  const CellInfo& info = cell_info(block.type);
  if (is_cube(block.type) || info.order == 1) return false;
  if (info.dimension == 2) return mesh.axisymmetric;
  const auto d = static_cast<std::size_t>(mesh.dimension);
  for (int cell = 0; cell < block.cells(); ++cell) {
    const auto place = [&](std::size_t a) {
      return &mesh.coordinates[d * static_cast<std::size_t>(
                                       block.nodes[cell_entry(cell, info.nodes, static_cast<int>(a))])];
    };
    double size = 0, offset = 0;
    for (std::size_t a = 0; a < info.node_corners.size(); ++a)
      for (std::size_t i = 0; i < d; ++i) {
        double middle = 0;
        for (const int corner : info.node_corners[a]) middle += place(static_cast<std::size_t>(corner))[i];
        offset = std::max(offset, std::abs(place(a)[i] - middle / static_cast<double>(info.node_corners[a].size())));
        size = std::max(size, std::abs(place(a)[i] - place(0)[i]));
      }
    if (offset > 1e-10 * size) return true;
  }
  return false;
}

}  // namespace ixos
