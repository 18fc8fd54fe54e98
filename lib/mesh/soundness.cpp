#include "mesh/soundness.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "fem/cell_info.hpp"
#include "mesh/cell_sides.hpp"

namespace ixos {
namespace {

/// A cell's corners in ascending order, -1 for missing ones.
using CellCorners = std::array<int, 8>;

const int* nodes_of(const ElementBlock& block, int cell) {
  return block.nodes.data() + static_cast<std::ptrdiff_t>(cell) * nodes_per_cell(block.type);
}

/// A cell's number over all blocks, and its nodes.
template <class Call>
void for_each_cell(const Mesh& mesh, const Call& call) {
  int cell = 0;
  for (const ElementBlock& block : mesh.blocks)
    for (int c = 0; c < block.cells(); ++c) call(cell++, block.type, nodes_of(block, c));
}

std::vector<double> place(const Mesh& mesh, int node) {
  const auto first = mesh.coordinates.begin() + static_cast<std::ptrdiff_t>(node) * mesh.dimension;
  return {first, first + mesh.dimension};
}

double size_of(const Mesh& mesh) {
  const auto [low, high] = std::minmax_element(mesh.coordinates.begin(), mesh.coordinates.end());
  return *high - *low;
}

/// Joins coarse cells with the fine ones beside them: those that have both ends of an edge with those that have a node
/// in its middle.
void join_across_hanging_sides(const Mesh& mesh, DisjointSets& parts) {
  if (mesh.hanging_edges.empty()) return;
  std::map<int, std::vector<int>> cells;  // by node of such an edge
  for (const auto& edge : mesh.hanging_edges)
    for (const int node : edge) cells[node];
  for_each_cell(mesh, [&](int cell, CellType type, const int* nodes) {
    for (int a = 0; a < nodes_per_cell(corner_type(type)); ++a)
      if (const auto own = cells.find(nodes[a]); own != cells.end()) own->second.push_back(cell);
  });
  for (const auto& [a, b, middle] : mesh.hanging_edges)
    for (const int cell : cells[a])
      if (std::binary_search(cells[b].begin(), cells[b].end(), cell) && !cells[middle].empty())
        parts.join(cell, cells[middle].front());
}

/// Joins the cells of tied nodes with those of the nodes that they follow.
void join_across_ties(const Mesh& mesh, DisjointSets& parts) {
  if (mesh.ties.empty()) return;
  std::vector<int> cell_of(static_cast<std::size_t>(mesh.nodes()), -1);
  for_each_cell(mesh, [&](int cell, CellType type, const int* nodes) {
    for (int a = 0; a < nodes_per_cell(type); ++a) cell_of[static_cast<std::size_t>(nodes[a])] = cell;
  });
  for (const Tie& tie : mesh.ties)
    for (const int master : tie.masters)
      if (const int own = cell_of[static_cast<std::size_t>(tie.node)],
          other = cell_of[static_cast<std::size_t>(master)];
          own >= 0 && other >= 0)
        parts.join(own, other);
}

struct Part {
  int cells = 0;
  int node = 0;    ///< one of them
  int shared = 0;  ///< nodes that other parts have too
  bool held = false;
};

}  // namespace

void refuse_repeated_cells(const Mesh& mesh) {
  std::vector<std::pair<CellCorners, int>> cells;
  for_each_cell(mesh, [&](int cell, CellType type, const int* nodes) {
    CellCorners sorted;
    sorted.fill(-1);
    std::copy_n(nodes, nodes_per_cell(corner_type(type)), sorted.begin());
    std::sort(sorted.begin(), sorted.end());
    cells.emplace_back(sorted, cell);
  });
  std::sort(cells.begin(), cells.end());
  const auto twice =
      std::adjacent_find(cells.begin(), cells.end(), [](const auto& a, const auto& b) { return a.first == b.first; });
  if (twice != cells.end())
    throw InputError(
        fmt::format("elements {} and {} have the same nodes", twice->second + 1, std::next(twice)->second + 1));
}

void refuse_split_faces(const Mesh& mesh) {
  const bool mixed = mesh.dimension == 3 && std::any_of(mesh.blocks.begin(), mesh.blocks.end(),
                                                        [](const auto& block) { return !is_cube(block.type); });
  if (!mixed) return;
  const std::vector<CellSide> sides = sorted_sides(mesh);
  const auto is_outer = [&](const SideCorners& corners) {
    const auto [begin, end] = sides_with(sides, corners);
    return end - begin == 1;
  };
  for (const CellSide& side : sides) {
    if (side.corners[0] < 0 || !is_outer(side.corners)) continue;
    for (std::size_t left_out = 0; left_out < 4; ++left_out) {
      SideCorners triangle = side.corners;
      triangle[left_out] = -1;
      std::sort(triangle.begin(), triangle.end());
      if (is_outer(triangle))
        throw InputError(fmt::format(
            "side {} of element {} is a quadrilateral, and on its other side are triangles (of element {}): "
            "their displacements differ there; a pyramid must stand between",
            side.side.side + 1, side.cell + 1, sides_with(sides, triangle).first->cell + 1));
    }
  }
}

void require_sides(const SideSet& set) {
  if (set.sides.empty()) throw InputError("the side set \"" + set.name + "\" has no sides");
}

void require_outer_sides(const Mesh& mesh, const SideSet& set) {
  const std::vector<CellSide> sides = sorted_sides(mesh);
  std::vector<int> first{0};
  for (const ElementBlock& block : mesh.blocks) first.push_back(first.back() + block.cells());
  for (const Side& side : set.sides) {
    const auto [begin, end] = sides_with(sides, sorted_corners(mesh, side));
    const int cell = first[static_cast<std::size_t>(side.block)] + side.cell;
    if (end - begin > 1)
      throw InputError(fmt::format(
          "the side set \"{}\" has side {} of element {}, which lies inside the body: "
          "element {} is on its other side",
          set.name, side.side + 1, cell + 1, (begin->cell == cell ? std::next(begin)->cell : begin->cell) + 1));
  }
}

void require_nodes(const NodeSet& set) {
  if (set.nodes.empty()) throw InputError("the node set \"" + set.name + "\" has no nodes");
}

std::string coincident_nodes(const Mesh& mesh) {
  // Nodes within the tolerance fall into one box of this grid, or of the one that is shifted by half a box.
  const double box = 2e-9 * size_of(mesh);
  if (!(box > 0)) return "";
  std::map<int, int> partner;  // by node, an earlier one at its place
  for (const double shift : {0.0, 0.5}) {
    std::map<std::vector<double>, int> earlier;
    for (int node = 0; node < mesh.nodes(); ++node) {
      std::vector<double> cell = place(mesh, node);
      for (double& x : cell) x = std::floor(x / box + shift);
      const auto [found, fresh] = earlier.emplace(cell, node);
      if (!fresh) partner.emplace(node, found->second);
    }
  }
  for (const Tie& tie : mesh.ties) partner.erase(tie.node);
  for (const Tie& tie : mesh.ties)
    for (const int master : tie.masters)
      if (const auto found = partner.find(master); found != partner.end() && found->second == tie.node)
        partner.erase(found);
  if (partner.empty()) return "";
  const auto [node, other] = *partner.begin();
  return fmt::format(
      "{} node(s) of the mesh stand where another one stands, the first at ({:.6g}): nodes {} and {}. The body is not "
      "connected there; merge them in the mesh generator unless a crack is meant",
      partner.size(), fmt::join(place(mesh, node), ", "), other + 1, node + 1);
}

std::vector<std::string> loose_parts(const Mesh& mesh, const std::vector<bool>& held) {
  DisjointSets parts(mesh.cells());
  const std::vector<CellSide> sides = sorted_sides(mesh);
  for (std::size_t i = 1; i < sides.size(); ++i)
    if (sides[i].corners == sides[i - 1].corners) parts.join(sides[i].cell, sides[i - 1].cell);
  join_across_hanging_sides(mesh, parts);
  join_across_ties(mesh, parts);

  std::map<int, Part> found;
  std::vector<int> part_of_node(static_cast<std::size_t>(mesh.nodes()), -1);
  std::vector<bool> shared(part_of_node.size(), false);
  const auto for_each_node = [&](const auto& call) {
    for_each_cell(mesh, [&](int cell, CellType type, const int* nodes) {
      for (int k = 0; k < nodes_per_cell(type); ++k) call(parts.of(cell), static_cast<std::size_t>(nodes[k]));
    });
  };
  for_each_cell(mesh, [&](int cell, CellType, const int* nodes) {
    Part& part = found[parts.of(cell)];
    ++part.cells;
    part.node = nodes[0];
  });
  if (found.size() < 2) return {};
  for_each_node([&](int part, std::size_t node) {
    if (part_of_node[node] >= 0 && part_of_node[node] != part) shared[node] = true;
    part_of_node[node] = part;
    if (held[node]) found[part].held = true;
  });
  std::vector<std::pair<int, std::size_t>> counted;  // a node counts once in each part
  for_each_node([&](int part, std::size_t node) {
    if (shared[node]) counted.emplace_back(part, node);
  });
  std::sort(counted.begin(), counted.end());
  counted.erase(std::unique(counted.begin(), counted.end()), counted.end());
  for (const auto& entry : counted) ++found[entry.first].shared;

  const auto body = std::max_element(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return std::pair(a.second.held, a.second.cells) < std::pair(b.second.held, b.second.cells);
  });
  std::vector<std::string> warnings;
  for (const auto& [name, part] : found) {
    if (name == body->first || (part.shared == 0 && part.held) || warnings.size() == 5) continue;
    warnings.push_back(
        fmt::format("{} of the mesh's {} elements, around ({:.6g}), share no side with the rest, and {}", part.cells,
                    mesh.cells(), fmt::join(place(mesh, part.node), ", "),
                    part.shared > 0 ? fmt::format("hang on it by {} node(s)", part.shared) : "nothing holds them"));
  }
  return warnings;
}

}  // namespace ixos
