#include "mesh/layers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "mesh/cell_sides.hpp"

namespace ixos {
namespace {

int opposite(CellType type, int side) {
  if (corner_type(type) == CellType::Quad4 || side < 4) return (side + 2) % 4;
  return side == 4 ? 5 : 4;
}

/// Returns the mean of the corners.
std::array<double, 3> centre(const Mesh& mesh, const SideCorners& corners) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  const auto count = static_cast<double>(std::count_if(corners.begin(), corners.end(), [](int n) { return n >= 0; }));
  std::array<double, 3> x{};
  for (int node : corners)
    for (std::size_t i = 0; i < d && node >= 0; ++i)
      x[i] += mesh.coordinates[static_cast<std::size_t>(node) * d + i] / count;
  return x;
}

}  // namespace

SingleLayer single_layer(const Mesh& mesh, const SideSet& set) {
  std::map<SideCorners, int> cells;  // that have a side opposite to one of the set
  std::vector<bool> marked(static_cast<std::size_t>(mesh.nodes()), false);
  const auto other_side = [&](const Side& side) {
    const CellType type = mesh.blocks[static_cast<std::size_t>(side.block)].type;
    return sorted_corners(mesh, {side.block, side.cell, opposite(type, side.side)});
  };
  for (const Side& side : set.sides) {
    const SideCorners corners = other_side(side);
    cells[corners] = 0;
    for (int node : corners)
      if (node >= 0) marked[static_cast<std::size_t>(node)] = true;
  }
  for (int block = 0; block < static_cast<int>(mesh.blocks.size()); ++block) {
    const ElementBlock& here = mesh.blocks[static_cast<std::size_t>(block)];
    for (int cell = 0; cell < here.cells(); ++cell)
      for (int side = 0; side < sides_per_cell(here.type); ++side) {
        const SideCorners corners = sorted_corners(mesh, {block, cell, side});
        if (!std::all_of(corners.begin(), corners.end(),
                         [&](int node) { return node < 0 || marked[static_cast<std::size_t>(node)]; }))
          continue;
        if (const auto found = cells.find(corners); found != cells.end()) ++found->second;
      }
  }
  SingleLayer layer;
  double single = 0;
  for (const Side& side : set.sides) {
    const SideCorners far = other_side(side);
    if (cells[far] != 1) continue;
    ++single;
    const auto x = centre(mesh, sorted_corners(mesh, side)), y = centre(mesh, far);
    layer.thickness += std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
  }
  if (single == 0) return layer;
  layer.thickness /= single;
  layer.share = single / static_cast<double>(set.sides.size());
  return layer;
}

}  // namespace ixos
