#include "mesh/turned_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "base/small_matrix.hpp"
#include "fem/cell_info.hpp"
#include "fem/jacobian.hpp"
#include "fem/with_element.hpp"
#include "mesh/cell_sides.hpp"

namespace ixos {
namespace {

/// Flags of cells, by block.
using CellFlags = std::vector<std::vector<bool>>;

/// The mirror image of a cell's numbering.
struct Mirror {
  std::vector<int> node;  ///< by new node: the old one
  std::vector<int> side;  ///< by old side: the new one
};

/// Returns, by corner of a shape, the corner that takes its place in the mirror image: triangles, quadrilaterals,
/// tetrahedra and pyramids keep corner 0 and run the other way round; bottom and top of prisms and hexahedra change
/// places.
std::vector<int> mirrored_corners(ReferenceShape shape) {
  switch (shape) {
    case ReferenceShape::Triangle:
      return {0, 2, 1};
    case ReferenceShape::Quadrilateral:
      return {0, 3, 2, 1};
    case ReferenceShape::Tetrahedron:
      return {0, 2, 1, 3};
    case ReferenceShape::Pyramid:
      return {0, 3, 2, 1, 4};
    case ReferenceShape::Prism:
      return {3, 4, 5, 0, 1, 2};
    case ReferenceShape::Hexahedron:
      return {4, 5, 6, 7, 0, 1, 2, 3};
  }
  throw std::logic_error("cells of this shape have no mirror image");
}

/// Returns the mirror image of a cell without an enriched side.
Mirror mirror_of_plain(const CellInfo& info) {
  const std::vector<int> corners = mirrored_corners(info.shape);
  const auto image = [&](std::vector<int> of) {
    for (int& corner : of) corner = corners[static_cast<std::size_t>(corner)];
    std::sort(of.begin(), of.end());
    return of;
  };
  const auto sorted = [](std::vector<int> of) {
    std::sort(of.begin(), of.end());
    return of;
  };
  Mirror mirror;
  const std::vector<NodeCorners>& pattern = info.node_corners;
  for (const NodeCorners& own : pattern) {
    const auto found = std::find_if(pattern.begin(), pattern.end(),
                                    [&](const NodeCorners& other) { return sorted(other) == image(own); });
    mirror.node.push_back(static_cast<int>(found - pattern.begin()));
  }
  const SideNodes& sides = cell_info(info.corners).sides;
  for (const std::vector<int>& old : sides)
    for (std::size_t now = 0; now < sides.size(); ++now)
      if (sorted(sides[now]) == image(old)) mirror.side.push_back(static_cast<int>(now));
  return mirror;
}

/// Returns the mirror image of a cell; that of an enriched one is that of its plain_type().
const Mirror& mirror_of(CellType type) {
  static const std::vector<Mirror> all = [] {
    std::vector<Mirror> mirrors;
    for (const CellInfo& info : cell_infos()) mirrors.push_back(mirror_of_plain(cell_info(info.plain)));
    return mirrors;
  }();
  return all[static_cast<std::size_t>(cell_info(type).type)];
}

/// Returns whether a cell is a mirror image: the linear cell of its corners has a negative Jacobian at the origin of
/// the reference shape.
bool is_mirrored(CellType type, const std::vector<double>& coordinates, const int* nodes) {
  return with_element(corner_type(type), [&](auto tag) {
    using Element = typename decltype(tag)::type;
    constexpr std::size_t D = Element::dimension;
    return determinant(jacobian_at<Element>(std::array<double, D>{}, coordinates, nodes)) < 0;
  });
}

CellFlags mirrored_cells(const Mesh& mesh) {
  CellFlags flags;
  for (const ElementBlock& block : mesh.blocks) {
    flags.emplace_back(static_cast<std::size_t>(block.cells()));
    for (int cell = 0; cell < block.cells(); ++cell) {
      const int* nodes = &block.nodes[cell_entry(cell, nodes_per_cell(block.type))];
      flags.back()[static_cast<std::size_t>(cell)] = is_mirrored(block.type, mesh.coordinates, nodes);
    }
  }
  return flags;
}

bool has_any(const CellFlags& flags) {
  return std::any_of(flags.begin(), flags.end(),
                     [](const auto& own) { return std::find(own.begin(), own.end(), true) != own.end(); });
}

/// Returns whether two cells pass the corners of their common side in the same direction.
bool run_alike(const Mesh& mesh, const Side& one, const Side& other) {
  const SideCorners a = corners_of(mesh, one), b = corners_of(mesh, other);
  const std::size_t count = count_of(a);
  const auto place = static_cast<std::size_t>(std::find(b.begin(), b.end(), a[0]) - b.begin());
  return count == 2 ? place == 0 : a[1] == b[(place + 1) % count];
}

/// Drops the flags of cells folded over a neighbour: numbered as that one, which passes the common side the other way,
/// but with a volume of the other sign.
void keep_folded_cells(const Mesh& mesh, CellFlags& flags) {
  const auto flag = [&](const Side& side) -> bool {
    return flags[static_cast<std::size_t>(side.block)][static_cast<std::size_t>(side.cell)];
  };
  std::vector<Side> folded;
  const std::vector<CellSide> sides = sorted_sides(mesh);
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const Side &one = sides[i - 1].side, &other = sides[i].side;
    if (sides[i - 1].corners != sides[i].corners || flag(one) == flag(other) || run_alike(mesh, one, other)) continue;
    folded.push_back(flag(one) ? one : other);
  }
  for (const Side& side : folded)
    flags[static_cast<std::size_t>(side.block)][static_cast<std::size_t>(side.cell)] = false;
}

}  // namespace

void turn_cells(Mesh& mesh) {
  CellFlags turned = mirrored_cells(mesh);
  if (!has_any(turned)) return;
  keep_folded_cells(mesh, turned);
  int count = 0;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    ElementBlock& block = mesh.blocks[b];
    const int n = nodes_per_cell(block.type);
    const Mirror& mirror = mirror_of(block.type);
    for (int cell = 0; cell < block.cells(); ++cell) {
      if (!turned[b][static_cast<std::size_t>(cell)]) continue;
      ++count;
      const auto first = block.nodes.begin() + static_cast<std::ptrdiff_t>(cell_entry(cell, n));
      const std::vector<int> old(first, first + n);
      for (int a = 0; a < n; ++a) first[a] = old[static_cast<std::size_t>(mirror.node[static_cast<std::size_t>(a)])];
    }
  }
  for (SideSet& set : mesh.side_sets)
    for (Side& side : set.sides)
      if (turned[static_cast<std::size_t>(side.block)][static_cast<std::size_t>(side.cell)])
        side.side =
            mirror_of(mesh.blocks[static_cast<std::size_t>(side.block)].type).side[static_cast<std::size_t>(side.side)];
  const bool only_cubes =
      std::all_of(mesh.blocks.begin(), mesh.blocks.end(), [](const auto& block) { return is_cube(block.type); });
  if (mesh.dimension == 3 && count > 0)
    mesh.notes.push_back(
        fmt::format("{} of the mesh's {} {} are numbered as mirror images (left-handed); Ixos turned them", count,
                    mesh.cells(), only_cubes ? "hexahedra" : "cells"));
}

}  // namespace ixos
