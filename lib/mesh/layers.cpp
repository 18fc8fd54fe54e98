#include "mesh/layers.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "fem/cell_info.hpp"
#include "mesh/cell_sides.hpp"

namespace ixos {

SingleLayer single_layer(const Mesh& mesh, const SideSet& set) {
  std::map<SideCorners, int> cells;  // that have a side opposite to one of the set
  std::vector<bool> marked(static_cast<std::size_t>(mesh.nodes()), false);
  const auto other_side = [&](const Side& side) {
    const CellType type = mesh.blocks[static_cast<std::size_t>(side.block)].type;
    return sorted_corners(mesh, {side.block, side.cell, opposite_side(type, side.side)});
  };
  if (!std::all_of(set.sides.begin(), set.sides.end(),
                   [&](const Side& side) { return is_cube(mesh.blocks[static_cast<std::size_t>(side.block)].type); }))
    return {};
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
    const auto x = centre_of(mesh, sorted_corners(mesh, side)), y = centre_of(mesh, far);
    layer.thickness += std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
  }
  if (single == 0) return layer;
  layer.thickness /= single;
  layer.share = single / static_cast<double>(set.sides.size());
  return layer;
}

}  // namespace ixos
