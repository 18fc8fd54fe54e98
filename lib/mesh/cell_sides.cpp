#include "mesh/cell_sides.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <stdexcept>

#include "fem/cell_info.hpp"

namespace ixos {

std::vector<int> nodes_of_side(const Mesh& mesh, const Side& side) {
  const ElementBlock& block = mesh.blocks[static_cast<std::size_t>(side.block)];
  std::vector<int> nodes;
  for (int a : side_nodes(block.type, side.side))
    nodes.push_back(block.nodes[cell_entry(side.cell, nodes_per_cell(block.type), a)]);
  return nodes;
}

int opposite_side(CellType type, int side) {
  const ReferenceShape shape = cell_info(type).shape;
  if (shape == ReferenceShape::Quadrilateral || (shape == ReferenceShape::Hexahedron && side < 4))
    return (side + 2) % 4;
  if (shape == ReferenceShape::Hexahedron) return side == 4 ? 5 : 4;
  throw std::logic_error("only sides of quadrilaterals and hexahedra have one opposite");
}

std::array<double, 3> centre_of(const Mesh& mesh, const SideCorners& corners) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  const auto count = static_cast<double>(count_of(corners));
  std::array<double, 3> x{};
  for (int node : corners)
    for (std::size_t i = 0; i < d && node >= 0; ++i)
      x[i] += mesh.coordinates[static_cast<std::size_t>(node) * d + i] / count;
  return x;
}

SideCorners corners_of(const Mesh& mesh, const Side& side) {
  const ElementBlock& block = mesh.blocks[static_cast<std::size_t>(side.block)];
  const int* nodes = &block.nodes[cell_entry(side.cell, nodes_per_cell(block.type))];
  SideCorners corners;
  corners.fill(-1);
  auto corner = corners.begin();
  for (int place : side_nodes(corner_type(block.type), side.side)) *corner++ = nodes[place];
  return corners;
}

std::size_t count_of(const SideCorners& corners) {
  return static_cast<std::size_t>(std::count_if(corners.begin(), corners.end(), [](int node) { return node >= 0; }));
}

std::array<double, 3> outward_normal(const Mesh& mesh, const Side& side) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  const SideCorners corners = corners_of(mesh, side);
  // From corner a of the side to corner b. Sides run counter-clockwise, seen from outside.
  const auto along = [&](std::size_t a, std::size_t b) {
    std::array<double, 3> way{};
    for (std::size_t i = 0; i < d; ++i)
      way[i] = mesh.coordinates[static_cast<std::size_t>(corners[b]) * d + i] -
               mesh.coordinates[static_cast<std::size_t>(corners[a]) * d + i];
    return way;
  };
  if (d == 2) {
    const auto t = along(0, 1);
    return {t[1], -t[0], 0};
  }
  const bool triangle = corners[3] < 0;
  const auto s = triangle ? along(0, 1) : along(0, 2), t = triangle ? along(0, 2) : along(1, 3);
  return {s[1] * t[2] - s[2] * t[1], s[2] * t[0] - s[0] * t[2], s[0] * t[1] - s[1] * t[0]};
}

SideCorners sorted_corners(const std::vector<int>& nodes) {
  SideCorners corners;
  corners.fill(-1);
  std::copy(nodes.begin(), nodes.end(), corners.begin());
  std::sort(corners.begin(), corners.end());
  return corners;
}

SideCorners sorted_corners(const Mesh& mesh, const Side& side) {
  SideCorners corners = corners_of(mesh, side);
  std::sort(corners.begin(), corners.end());
  return corners;
}

std::vector<CellSide> sorted_sides(const Mesh& mesh) {
  std::vector<CellSide> sides;
  int number = 0, block = 0;
  for (const ElementBlock& b : mesh.blocks) {
    for (int cell = 0; cell < b.cells(); ++cell, ++number)
      for (int k = 0; k < sides_per_cell(b.type); ++k) {
        const Side side{block, cell, k};
        sides.push_back({sorted_corners(mesh, side), number, side});
      }
    ++block;
  }
  std::stable_sort(sides.begin(), sides.end());
  return sides;
}

EqualSides sides_with(const std::vector<CellSide>& sorted, const SideCorners& corners) {
  return std::equal_range(sorted.begin(), sorted.end(), CellSide{corners, 0, {}});
}

std::vector<Side> boundary_sides(const Mesh& mesh) {
  const std::vector<CellSide> sides = sorted_sides(mesh);
  const auto key = [](const Side& side) { return std::array{side.block, side.cell, side.side}; };
  std::set<std::array<int, 3>> hanging;
  for (const Side& side : mesh.hanging_sides) hanging.insert(key(side));
  std::vector<CellSide> outer;
  for (auto first = sides.begin(); first != sides.end();) {
    const auto next = std::upper_bound(first, sides.end(), *first);
    if (next - first == 1 && hanging.count(key(first->side)) == 0) outer.push_back(*first);
    first = next;
  }
  std::sort(outer.begin(), outer.end(), [](const CellSide& a, const CellSide& b) {
    return std::pair(a.cell, a.side.side) < std::pair(b.cell, b.side.side);
  });
  std::vector<Side> result;
  std::transform(outer.begin(), outer.end(), std::back_inserter(result), [](const CellSide& s) { return s.side; });
  return result;
}

}  // namespace ixos
