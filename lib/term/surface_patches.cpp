#include "term/surface_patches.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "fem/cell_type.hpp"

namespace ixos {

int surface_number(const std::vector<int>& nodes, int node, const LocalMesh& mesh) {
  const auto found = std::lower_bound(nodes.begin(), nodes.end(), node, [&](int a, int b) {
    return mesh.global_ids[static_cast<std::size_t>(a)] < mesh.global_ids[static_cast<std::size_t>(b)];
  });
  return static_cast<int>(found - nodes.begin());
}

template <std::size_t D>
SurfacePatches<D> surface_of_sides(const LocalMesh& mesh, const std::vector<LocalSide>& sides,
                                   const std::string& name) {
  SurfacePatches<D> surface;
  for (const LocalSide& side : sides) {
    const LocalBlock& block = mesh.blocks[static_cast<std::size_t>(side.block)];
    if (is_enriched(block.type) && (is_hermite(block.type) || is_quadratic(block.type) || block.tied != 0))
      throw InputError(fmt::format(
          "the surface \"{}\" has sides that surfaces of two bodies cannot have yet: {}; use Q1C1, or quadratic cells "
          "with Q2C2",
          name,
          block.tied != 0 ? "enriched faces beside cells that are not enriched" : "Contact Element Q1CH or Q2C4"));
    if (side.nodes.size() != sides.front().nodes.size())
      throw InputError(
          fmt::format("the surface \"{}\" has sides of {} and of {} nodes; surfaces of two bodies need "
                      "sides of one kind",
                      name, sides.front().nodes.size(), side.nodes.size()));
    surface.nodes.insert(surface.nodes.end(), side.nodes.begin(), side.nodes.end());
    surface.owned.push_back(side.owned ? 1 : 0);
    surface.sides.push_back({side.block, side.cell, side.side});
  }
  std::sort(surface.nodes.begin(), surface.nodes.end(), [&](int a, int b) {
    return mesh.global_ids[static_cast<std::size_t>(a)] < mesh.global_ids[static_cast<std::size_t>(b)];
  });
  surface.nodes.erase(std::unique(surface.nodes.begin(), surface.nodes.end()), surface.nodes.end());
  return surface;
}

template SurfacePatches<2> surface_of_sides<2>(const LocalMesh&, const std::vector<LocalSide>&, const std::string&);
template SurfacePatches<3> surface_of_sides<3>(const LocalMesh&, const std::vector<LocalSide>&, const std::string&);

}  // namespace ixos
