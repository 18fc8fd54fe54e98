#include "mesh/splitting/refine.hpp"

#include <algorithm>
#include <cstddef>
#include <set>

#include "base/error.hpp"
#include "fem/cell_info.hpp"
#include "fem/corner_element.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/normalize.hpp"
#include "mesh/splitting/cell_tree.hpp"
#include "mesh/splitting/hanging_nodes.hpp"
#include "mesh/tied_nodes.hpp"

namespace ixos {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::set<int> nodes_of(const Mesh& mesh, const SideSet& set) {
  std::set<int> nodes;
  for (const Side& side : set.sides) {
    const std::vector<int> own = nodes_of_side(mesh, side);
    nodes.insert(own.begin(), own.end());
  }
  return nodes;
}

/// Makes the mesh of a tree's leaves.
class LeafMesh {
 public:
  LeafMesh(Mesh& mesh, CellTree& tree, int order)
      : mesh_(mesh), tree_(tree), before_(mesh), nodes_before_(mesh.nodes()), order_(order) {}

  void make() {
    find_boundary();
    add_cells();
    add_side_sets();
    add_node_sets();
    const HangingNodes hanging = find_hanging_nodes(tree_, order_);
    mesh_.ties = hanging.ties;
    mesh_.hanging_edges = hanging.edges;
    find_hanging_sides();
  }

 private:
  /// The node of a cell's corners with these bits: a corner, or in the middle of an edge, a face or the cell.
  int node_between(const TreeCell& leaf, std::vector<int> bits) {
    if (bits.size() == 1) return leaf.corners[at(bits.front())];
    std::sort(bits.begin(), bits.end());
    int axis = 0;
    while (std::all_of(bits.begin(), bits.end(), [&](int b) { return (b >> axis & 1) == (bits.front() >> axis & 1); }))
      ++axis;
    std::vector<int> low, high;
    for (const int b : bits) ((b >> axis & 1) != 0 ? high : low).push_back(b);
    std::array<double, 3> place{};
    for (int k = 0; k < mesh_.dimension; ++k) {
      for (const int b : bits) place[at(k)] += (b >> k & 1) != 0 ? leaf.upper[at(k)] : leaf.lower[at(k)];
      place[at(k)] /= static_cast<double>(bits.size());
    }
    return tree_.middle(leaf, node_between(leaf, low), node_between(leaf, high), place);
  }

  void add_cells() {
    const CellType type = cube_type(mesh_.dimension, order_);
    std::vector<std::vector<int>> bits_of_nodes;
    for (const std::vector<int>& corners : corners_of_nodes(mesh_.dimension)) {
      bits_of_nodes.emplace_back();
      for (const int corner : corners) bits_of_nodes.back().push_back(corner_with(corner));
    }
    bits_of_nodes.resize(at(nodes_per_cell(type)));  // corners come first
    for (std::size_t b = 0; b < mesh_.blocks.size(); ++b) {
      const ElementBlock& old = before_.blocks[b];
      ElementBlock block = old;
      block.type = type;
      block.nodes.clear();
      block.file_numbers.clear();
      first_leaf_.emplace_back();
      for (int cell = 0; cell < old.cells(); ++cell) {
        first_leaf_.back().push_back(block.cells());
        tree_.for_each_leaf(static_cast<int>(b), cell, [&](const TreeCell& leaf) {
          for (const std::vector<int>& bits : bits_of_nodes) block.nodes.push_back(node_between(leaf, bits));
          if (!old.file_numbers.empty()) block.file_numbers.push_back(old.file_numbers[at(cell)]);
        });
      }
      mesh_.blocks[b] = std::move(block);
    }
  }

  /// The axis across which a side of a cell lies, and its end.
  std::pair<int, int> axis_of(int side) const {
    const std::vector<int> corners = side_nodes(cube_type(mesh_.dimension), side);
    for (int axis = 0;; ++axis) {
      const int end = corner_with(corners.front()) >> axis & 1;
      if (std::all_of(corners.begin(), corners.end(), [&](int c) { return (corner_with(c) >> axis & 1) == end; }))
        return {axis, end};
    }
  }

  /// Calls visit(part) for the parts of a side of a cell of the mesh before.
  template <class Visit>
  void for_each_part(const Side& side, const Visit& visit) const {
    const auto [axis, end] = axis_of(side.side);
    int leaf_number = first_leaf_[at(side.block)][at(side.cell)];
    tree_.for_each_leaf(side.block, side.cell, [&, a = at(axis), e = end](const TreeCell& leaf) {
      if (e == 0 ? leaf.lower[a] == -1 : leaf.upper[a] == 1) visit(Side{side.block, leaf_number, side.side});
      ++leaf_number;
    });
  }

  void add_side_sets() {
    for (std::size_t s = 0; s < mesh_.side_sets.size(); ++s) {
      std::vector<Side> parts;
      for (const Side& side : before_.side_sets[s].sides)
        for_each_part(side, [&](const Side& part) { parts.push_back(part); });
      mesh_.side_sets[s].sides = std::move(parts);
    }
  }

  void add_node_sets() {
    for (NodeSet& set : mesh_.node_sets) {
      const auto same = std::find_if(before_.side_sets.begin(), before_.side_sets.end(),
                                     [&](const SideSet& sides) { return sides.name == set.name; });
      if (same != before_.side_sets.end() &&
          std::set<int>(set.nodes.begin(), set.nodes.end()) == nodes_of(before_, *same)) {
        const std::set<int> nodes =
            nodes_of(mesh_, mesh_.side_sets[at(static_cast<int>(same - before_.side_sets.begin()))]);
        set.nodes.assign(nodes.begin(), nodes.end());
        continue;
      }
      std::vector<char> is_in(at(mesh_.nodes()), 0);
      for (const int node : set.nodes) is_in[at(node)] = 1;
      for (int node = nodes_before_; node < mesh_.nodes(); ++node) {
        const auto [a, b] = tree_.middles().origin(node);
        if (is_in[at(a)] == 0 || is_in[at(b)] == 0) continue;
        is_in[at(node)] = 1;
        set.nodes.push_back(node);
      }
    }
  }

  void find_boundary() { boundary_ = boundary_sides(before_); }

  /// Sides that one cell alone has are on the boundary, or hang.
  void find_hanging_sides() {
    std::set<std::array<int, 3>> outside;
    for (const Side& side : boundary_)
      for_each_part(side, [&](const Side& part) { outside.insert({part.block, part.cell, part.side}); });
    for (const Side& side : boundary_sides(mesh_))
      if (outside.count({side.block, side.cell, side.side}) == 0) mesh_.hanging_sides.push_back(side);
  }

  Mesh& mesh_;
  CellTree& tree_;
  const Mesh before_;
  int nodes_before_;
  int order_;
  std::vector<Side> boundary_;
  std::vector<std::vector<int>> first_leaf_;  ///< by block and cell of the mesh before: its first leaf
};

/// Removes the nodes beside the corners of cells, which none has any more.
void drop_middles(Mesh& mesh) {
  const std::vector<std::string> notes = mesh.notes;
  drop_unused_nodes(mesh);
  mesh.notes = notes;
  mesh.linear_nodes = -1;
}

}  // namespace

void refine(Mesh& mesh, const std::vector<NamedRegion>& regions, int order) {
  if (mesh.plain_nodes >= 0) throw InputError("the mesh has enriched sides; refine it before it is enriched");
  if (!mesh.ties.empty()) throw InputError("the mesh has tied nodes already; refine it before they are tied");
  std::vector<RegionSearch> searches;
  std::vector<std::string> names;
  for (const NamedRegion& region : regions) {
    names.push_back(region.name);
    try {
      searches.emplace_back(mesh, region.region);
    } catch (const InputError& error) {
      throw InputError(region.name + ": " + error.what());
    }
  }
  CellTree tree(mesh);
  tree.split(searches, names, most_refined_cells);
  const bool curved = std::any_of(mesh.blocks.begin(), mesh.blocks.end(),
                                  [](const ElementBlock& block) { return is_quadratic(block.type); });
  LeafMesh(mesh, tree, order).make();
  if (curved && order == 1) drop_middles(mesh);
  place_tied_nodes(mesh);
}

}  // namespace ixos
