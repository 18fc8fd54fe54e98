#include "mesh/layers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace ixos {
namespace {

using Corners = std::array<int, 4>;

/// Returns the corner nodes of a cell's side in ascending order; the last two are -1 in two dimensions.
Corners corners_of(const ElementBlock& block, int cell, int side) {
  const std::size_t count = plain_type(block.type) == CellType::Hex8 ? 4 : 2;
  const std::vector<int>& local = side_nodes(plain_type(block.type), side);
  Corners corners{-1, -1, -1, -1};
  for (std::size_t a = 0; a < count; ++a)
    corners[a] = block.nodes[cell_entry(cell, nodes_per_cell(block.type), local[a])];
  std::sort(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(count));
  return corners;
}

int opposite(CellType type, int side) {
  if (plain_type(type) == CellType::Quad4 || side < 4) return (side + 2) % 4;
  return side == 4 ? 5 : 4;
}

/// Returns the mean of the corners.
std::array<double, 3> centre(const Mesh& mesh, const Corners& corners) {
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
  std::map<Corners, int> cells;  // that have a side opposite to one of the set
  std::vector<bool> marked(static_cast<std::size_t>(mesh.nodes()), false);
  const auto block_of = [&](const Side& side) -> const ElementBlock& {
    return mesh.blocks[static_cast<std::size_t>(side.block)];
  };
  const auto other_side = [&](const Side& side) {
    return corners_of(block_of(side), side.cell, opposite(block_of(side).type, side.side));
  };
  for (const Side& side : set.sides) {
    const Corners corners = other_side(side);
    cells[corners] = 0;
    for (int node : corners)
      if (node >= 0) marked[static_cast<std::size_t>(node)] = true;
  }
  for (const ElementBlock& block : mesh.blocks)
    for (int cell = 0; cell < block.cells(); ++cell)
      for (int side = 0; side < sides_per_cell(block.type); ++side) {
        const Corners corners = corners_of(block, cell, side);
        if (!std::all_of(corners.begin(), corners.end(),
                         [&](int node) { return node < 0 || marked[static_cast<std::size_t>(node)]; }))
          continue;
        if (const auto found = cells.find(corners); found != cells.end()) ++found->second;
      }
  SingleLayer layer;
  double single = 0;
  for (const Side& side : set.sides) {
    const Corners far = other_side(side);
    if (cells[far] != 1) continue;
    ++single;
    const auto x = centre(mesh, corners_of(block_of(side), side.cell, side.side)), y = centre(mesh, far);
    layer.thickness += std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
  }
  if (single == 0) return layer;
  layer.thickness /= single;
  layer.share = single / static_cast<double>(set.sides.size());
  return layer;
}

}  // namespace ixos
