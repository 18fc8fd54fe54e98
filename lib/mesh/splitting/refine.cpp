#include "mesh/splitting/refine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <set>

#include "base/error.hpp"
#include "fem/cell_info.hpp"
#include "fem/corner_bits.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/normalize.hpp"
#include "mesh/side_set_nodes.hpp"
#include "mesh/splitting/cell_tree.hpp"
#include "mesh/splitting/hanging_nodes.hpp"
#include "mesh/tied_nodes.hpp"

namespace ixos {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Makes the mesh of a tree's leaves.
class LeafMesh {
 public:
  LeafMesh(Mesh& mesh, CellTree& tree, int nodes_before, int order)
      : mesh_(mesh),
        tree_(tree),
        before_(mesh),
        nodes_before_(nodes_before),
        order_(order),
        type_(cube_type(mesh.dimension, order)) {}

  void make() {
    add_cells();
    add_side_sets();
    add_node_sets();
    const HangingNodes hanging = find_hanging_nodes(tree_, order_);
    mesh_.ties = hanging.ties;
    mesh_.hanging_edges = hanging.edges;
    find_hanging_sides();
  }

 private:
  /// The nodes of a leaf as a cell of the mesh.
  std::vector<int> nodes_of_leaf(const TreeCell& leaf) {
    std::vector<int> nodes(at(nodes_per_cell(type_)), -1);
    for (int bits = 0; bits < 1 << mesh_.dimension; ++bits) nodes[at(corner_bits(bits))] = leaf.corners[at(bits)];
    if (!is_quadratic(type_)) return nodes;
    for (const CellMiddle& middle : cell_middles(mesh_.dimension))
      if (int& node = nodes[at(middle.node)]; node < 0)
        node = tree_.middle(leaf, nodes[at(middle.low)], nodes[at(middle.high)], middle.place);
    return nodes;
  }

  void add_cells() {
    for (std::size_t b = 0; b < mesh_.blocks.size(); ++b) {
      const ElementBlock& old = before_.blocks[b];
      ElementBlock block = old;
      block.type = type_;
      block.nodes.clear();
      block.file_numbers.clear();
      first_leaf_.emplace_back();
      for (int cell = 0; cell < old.cells(); ++cell) {
        first_leaf_.back().push_back(block.cells());
        tree_.for_each_leaf(static_cast<int>(b), cell, [&](const TreeCell& leaf) {
          const std::vector<int> nodes = nodes_of_leaf(leaf);
          block.nodes.insert(block.nodes.end(), nodes.begin(), nodes.end());
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
      const int end = corner_bits(corners.front()) >> axis & 1;
      if (std::all_of(corners.begin(), corners.end(), [&](int c) { return (corner_bits(c) >> axis & 1) == end; }))
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

  /// A set that is not that of its sides gets the nodes between its own.
  void add_node_sets() {
    const SetPairs of_sides = sets_of_sides(before_);
    for (NodeSet& set : mesh_.node_sets) {
      std::vector<char> is_in(at(mesh_.nodes()), 0);
      for (const int node : set.nodes) is_in[at(node)] = 1;
      for (int node = nodes_before_; node < mesh_.nodes(); ++node) {
        const auto [a, b] = tree_.middles().origin(node);
        if (is_in[at(a)] == 0 || is_in[at(b)] == 0) continue;
        is_in[at(node)] = 1;
        set.nodes.push_back(node);
      }
    }
    renew_sets_of_sides(mesh_, of_sides);
  }

  /// Sides that one cell alone has are on the boundary, or hang.
  void find_hanging_sides() {
    std::set<std::array<int, 3>> outside;
    for (const Side& side : boundary_sides(before_))
      for_each_part(side, [&](const Side& part) { outside.insert({part.block, part.cell, part.side}); });
    for (const Side& side : boundary_sides(mesh_))
      if (outside.count({side.block, side.cell, side.side}) == 0) mesh_.hanging_sides.push_back(side);
  }

  Mesh& mesh_;
  CellTree& tree_;
  const Mesh before_;
  int nodes_before_;
  int order_;
  CellType type_;                             ///< of the cells
  std::vector<std::vector<int>> first_leaf_;  ///< by block and cell of the mesh before: its first leaf
};

/// Removes the nodes beside the corners of cells, which none has any more. Returns the trees with the new numbers.
SplitTree without_middles(Mesh& mesh, const SplitTree& trees) {
  std::vector<int> number(at(mesh.nodes()), -1);
  const std::vector<std::string> notes = mesh.notes;
  const std::vector<int> before = drop_unused_nodes(mesh);
  mesh.notes = notes;
  mesh.linear_nodes = -1;
  for (std::size_t node = 0; node < before.size(); ++node) number[at(before[node])] = static_cast<int>(node);
  std::vector<TreeCell> cells = trees.cells();
  for (TreeCell& cell : cells)
    for (int bits = 0; bits < 1 << mesh.dimension; ++bits) cell.corners[at(bits)] = number[at(cell.corners[at(bits)])];
  return trees.with(std::move(cells));
}

void check(const Mesh& mesh) {
  if (mesh.plain_nodes >= 0) throw InputError("the mesh has enriched sides; refine it before it is enriched");
  if (!mesh.ties.empty()) throw InputError("the mesh has tied nodes already; refine it before they are tied");
  for (const ElementBlock& block : mesh.blocks)
    if (!is_cube(block.type) && block.cells() > 0)
      throw InputError(
          fmt::format("block \"{}\": only quadrilaterals and hexahedra are refined; give a mesh of {} cells its size "
                      "where it is made",
                      block.name, cell_info(block.type).name));
}

/// Makes the mesh of the leaves of a tree, which grow(tree) splits.
template <class Growth>
SplitTree grown(Mesh& mesh, int order, const Growth& grow) {
  const int nodes_before = mesh.nodes();
  const bool curved = std::any_of(mesh.blocks.begin(), mesh.blocks.end(),
                                  [](const ElementBlock& block) { return is_quadratic(block.type); });
  CellTree tree(mesh);
  grow(tree);
  LeafMesh(mesh, tree, nodes_before, order).make();
  SplitTree trees = tree.trees();
  if (curved && order == 1) trees = without_middles(mesh, trees);
  place_tied_nodes(mesh);
  return trees;
}

/// Throws InputError before minutes pass and the memory is full. A region alone makes no more cells than all together.
void refuse_far_too_many(const Mesh& mesh, const RegionSearch& region, const std::string& name) {
  constexpr int deep = 6;
  constexpr std::size_t sample = 2000;
  if (region.levels() <= deep) return;
  Mesh trial = mesh;
  const double cells = CellTree(trial).forecast(region, sample);
  if (cells > 2 * static_cast<double>(most_refined_cells))
    throw InputError(
        fmt::format("{}: the refined mesh would have about {:.2g} cells, more than {}; use fewer levels or "
                    "a smaller region",
                    name, cells, most_refined_cells));
}

}  // namespace

SplitTree refine(Mesh& mesh, const std::vector<NamedRegion>& regions, int order) {
  check(mesh);
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
  for (std::size_t r = 0; r < searches.size(); ++r) refuse_far_too_many(mesh, searches[r], names[r]);
  return grown(mesh, order, [&](CellTree& tree) { tree.split(searches, names, most_refined_cells); });
}

SplitTree split(Mesh& mesh, const CellSplits& splits, int order) {
  check(mesh);
  return grown(mesh, order, [&](CellTree& tree) {
    const auto wish = [&](const TreeCell& cell) {
      const int axis = splits.axis(cell);
      return axis < 0 ? std::vector<int>() : std::vector<int>{axis};
    };
    tree.split(wish, true, most_refined_cells);
  });
}

void split(Mesh& mesh, const Splitting& splitting, int order) {
  if (!splitting.any()) return;
  if (splitting.tree == nullptr) {
    refine(mesh, splitting.regions, order);
    return;
  }
  *splitting.base = mesh;
  CellSplits splits;
  if (splitting.splits != nullptr) {
    splits = *splitting.splits;
  } else {
    Mesh trial = mesh;
    splits = refine(trial, splitting.regions, order).splits();
  }
  *splitting.tree = split(mesh, splits, order);  // numbers that depend on the splits alone
}

}  // namespace ixos
