#include "geometry/surface_patches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/error.hpp"
#include "fem/cell_type.hpp"
#include "geometry/lagrange_patches.hpp"

namespace ixos {
namespace {

/// Returns the number of corners of a side of a cell.
std::size_t corners_of(const LocalBlock& block, const LocalSide& side) {
  return side_nodes(corner_type(block.type), side.side).size();
}

/// Returns a number that sides have in common if they can meet: of the nodes along an edge of a triangle or a
/// quadrilateral, or of all nodes of another side.
template <std::size_t D>
std::size_t kind_of(const LocalBlock& block, const LocalSide& side) {
  const std::size_t nodes = side.nodes.size();
  if (D == 2) return nodes;
  if (corners_of(block, side) == 3) return nodes == 3 ? 2 : 3;
  return nodes == 4 ? 2 : nodes == 9 ? 3 : nodes;
}

}  // namespace

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
    if (kind_of<D>(block, side) !=
        kind_of<D>(mesh.blocks[static_cast<std::size_t>(sides.front().block)], sides.front()))
      throw InputError(
          fmt::format("the surface \"{}\" has sides of {} and of {} nodes; surfaces of two bodies need sides of one "
                      "order: use the same Contact Element and Cell Order on all of it",
                      name, sides.front().nodes.size(), side.nodes.size()));
    std::vector<int> nodes = side.nodes;
    for (const InnerNode& inner : tied_nodes(block, side.side)) nodes[inner.node] = -1;
    std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(surface.nodes), [](int node) { return node >= 0; });
    surface.owned.push_back(side.owned ? 1 : 0);
    surface.sides.push_back({side.block, side.cell, side.side});
    surface.part.push_back(0);
  }
  std::sort(surface.nodes.begin(), surface.nodes.end(), [&](int a, int b) {
    return mesh.global_ids[static_cast<std::size_t>(a)] < mesh.global_ids[static_cast<std::size_t>(b)];
  });
  surface.nodes.erase(std::unique(surface.nodes.begin(), surface.nodes.end()), surface.nodes.end());
  return surface;
}

std::size_t number_of_patches(const LocalMesh& mesh, const std::vector<LocalSide>& sides) {
  if (!has_triangles(mesh, sides)) return sides.size();
  std::size_t sum = 0;
  for (const LocalSide& side : sides) sum += corners_of(mesh.blocks[static_cast<std::size_t>(side.block)], side);
  return sum;
}

bool has_triangles(const LocalMesh& mesh, const std::vector<LocalSide>& sides) {
  return mesh.dimension == 3 && std::any_of(sides.begin(), sides.end(), [&mesh](const LocalSide& side) {
           return corners_of(mesh.blocks[static_cast<std::size_t>(side.block)], side) == 3;
         });
}

template <std::size_t D>
std::vector<LocalSide> SurfacePatches<D>::sides_of_patches() const {
  std::vector<LocalSide> result;
  for (std::size_t p = 0; p < sides.size(); ++p)
    result.push_back({sides[p][0], sides[p][1], sides[p][2], {}, owned[p] != 0, part[p]});
  return result;
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

template std::vector<LocalSide> SurfacePatches<2>::sides_of_patches() const;
template std::vector<LocalSide> SurfacePatches<3>::sides_of_patches() const;
template void combine_places(const std::vector<int>&, const std::vector<double>&, double, const NodeParts&,
                             std::vector<Vec<2>>&);
template void combine_places(const std::vector<int>&, const std::vector<double>&, double, const NodeParts&,
                             std::vector<Vec<3>>&);
template SurfacePatches<2> surface_of_sides<2>(const LocalMesh&, const std::vector<LocalSide>&, const std::string&);
template SurfacePatches<3> surface_of_sides<3>(const LocalMesh&, const std::vector<LocalSide>&, const std::string&);

}  // namespace ixos
