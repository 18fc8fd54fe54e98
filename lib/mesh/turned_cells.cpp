#include "mesh/turned_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "base/small_matrix.hpp"
#include "fem/cell_info.hpp"
#include "fem/corner_element.hpp"
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

/// Returns the mirror image of Quad9 or Hex27; that of Quad4 or Hex8 is its beginning. A quadrilateral keeps corner 0
/// and runs the other way round; bottom and top of a hexahedron change places.
Mirror mirror_of_cube(int dimension) {
  const std::vector<int> corners =
      dimension == 2 ? std::vector<int>{0, 3, 2, 1} : std::vector<int>{4, 5, 6, 7, 0, 1, 2, 3};
  const auto image = [&](std::vector<int> of) {
    for (int& corner : of) corner = corners[static_cast<std::size_t>(corner)];
    std::sort(of.begin(), of.end());
    return of;
  };
  Mirror mirror;
  const auto& pattern = corners_of_nodes(dimension);
  for (const std::vector<int>& own : pattern) {
    const auto found = std::find(pattern.begin(), pattern.end(), image(own));
    mirror.node.push_back(static_cast<int>(found - pattern.begin()));
  }
  const CellType linear = cube_type(dimension);
  for (int old = 0; old < sides_per_cell(linear); ++old)
    for (int now = 0; now < sides_per_cell(linear); ++now) {
      std::vector<int> own = side_nodes(linear, now);
      std::sort(own.begin(), own.end());
      if (own == image(side_nodes(linear, old))) mirror.side.push_back(now);
    }
  return mirror;
}

/// Returns the mirror image of a cell. A triangle keeps corner 0.
const Mirror& mirror_of(CellType type) {
  static const Mirror plane = mirror_of_cube(2), solid = mirror_of_cube(3), triangle{{0, 2, 1}, {2, 1, 0}};
  switch (cell_info(type).shape) {
    case ReferenceShape::Triangle:
      return triangle;
    case ReferenceShape::Quadrilateral:
      return plane;
    case ReferenceShape::Hexahedron:
      return solid;
  }
  throw std::logic_error("cells of this shape have no mirror image");
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
  const std::size_t count = mesh.dimension == 2 ? 2 : 4;
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
  if (mesh.dimension == 3 && count > 0)
    mesh.notes.push_back(
        fmt::format("{} of the mesh's {} hexahedra are numbered as mirror images (left-handed); Ixos turned them",
                    count, mesh.cells()));
}

}  // namespace ixos
