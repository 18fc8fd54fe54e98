#include "geometry/surface_patches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/error.hpp"
#include "fem/cell_type.hpp"
#include "geometry/lagrange_patches.hpp"

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
    if (is_hermite(block.type))
      throw InputError(
          fmt::format("the surface \"{}\" has sides of the Contact Element Q1CH, which surfaces of two bodies "
                      "cannot have yet; use another one",
                      name));
    if (D == 3 && side_nodes(corner_type(block.type), side.side).size() == 3)
      throw InputError(fmt::format(
          "the surface \"{}\" has triangles; surfaces of two bodies need quadrilaterals (of hexahedra or prisms)",
          name));
    if (side.nodes.size() != sides.front().nodes.size())
      throw InputError(
          fmt::format("the surface \"{}\" has sides of {} and of {} nodes; surfaces of two bodies need "
                      "sides of one kind",
                      name, sides.front().nodes.size(), side.nodes.size()));
    std::vector<int> nodes = side.nodes;
    for (const InnerNode& inner : tied_nodes(block, side.side)) nodes[inner.node] = -1;
    std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(surface.nodes), [](int node) { return node >= 0; });
    surface.owned.push_back(side.owned ? 1 : 0);
    surface.sides.push_back({side.block, side.cell, side.side});
  }
  std::sort(surface.nodes.begin(), surface.nodes.end(), [&](int a, int b) {
    return mesh.global_ids[static_cast<std::size_t>(a)] < mesh.global_ids[static_cast<std::size_t>(b)];
  });
  surface.nodes.erase(std::unique(surface.nodes.begin(), surface.nodes.end()), surface.nodes.end());
  return surface;
}

template <std::size_t D>
void combine_places(const std::vector<int>& nodes, const std::vector<double>& coordinates, double rest,
                    const NodeParts& parts, std::vector<Vec<D>>& places) {
  places.clear();
  places.reserve(nodes.size());
  for (const int node : nodes) {
    Vec<D> place{};
    for (std::size_t i = 0; i < D; ++i) {
      const std::size_t dof = D * static_cast<std::size_t>(node) + i;
      double moved = 0;
      for (const auto& [share, values] : parts)
        if (values != nullptr && share != 0) moved += share * values[dof];
      place[i] = rest * coordinates[dof] + moved;
    }
    places.push_back(place);
  }
}

template void combine_places(const std::vector<int>&, const std::vector<double>&, double, const NodeParts&,
                             std::vector<Vec<2>>&);
template void combine_places(const std::vector<int>&, const std::vector<double>&, double, const NodeParts&,
                             std::vector<Vec<3>>&);
template SurfacePatches<2> surface_of_sides<2>(const LocalMesh&, const std::vector<LocalSide>&, const std::string&);
template SurfacePatches<3> surface_of_sides<3>(const LocalMesh&, const std::vector<LocalSide>&, const std::string&);

}  // namespace ixos
