#include "mesh/splitting/refine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "fem/cell_info.hpp"
#include "fem/corner_bits.hpp"
#include "mesh/cell_order.hpp"
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
      : mesh_(mesh), tree_(tree), before_(mesh), nodes_before_(nodes_before), order_(order) {}

  void make() {
    add_cells();
    for (const Side& side : boundary_sides(before_))
      for_each_part(side, [&](const Side& part) { outside_.push_back(part); });
    add_side_sets();
    add_node_sets();
    const HangingNodes hanging = find_hanging_nodes(tree_, order_);
    mesh_.ties = hanging.ties;
    mesh_.hanging_edges = hanging.edges;
    find_hanging_sides();
  }

 private:
  /// The type of the leaves of a block. Those of cells with bubbles are without: add_bubbles() gives them new ones.
  CellType leaf_type(const ElementBlock& old) const {
    const CellType corners = corner_type(old.type);
    if (tree_shape(cell_info(old.type).shape) == TreeShape::Box) return cube_type(mesh_.dimension, order_);
    return order_ == 1 ? corners : raised_type(corners, false);
  }

  /// The nodes of a leaf as a cell of the mesh.
  std::vector<int> nodes_of_leaf(const TreeCell& leaf, CellType type) {
    std::vector<int> nodes(at(nodes_per_cell(type)), -1);
    if (leaf.shape == TreeShape::Whole) {
      const ElementBlock& old = before_.blocks[at(leaf.block)];
      std::copy_n(&old.nodes[cell_entry(leaf.root, nodes_per_cell(old.type))], nodes.size(), nodes.begin());
      return nodes;
    }
    const bool is_box = leaf.shape == TreeShape::Box;
    for (int corner = 0; corner < leaf.count; ++corner)
      nodes[at(is_box ? corner_bits(corner) : corner)] = leaf.corners[at(corner)];
    if (!is_quadratic(type)) return nodes;
    if (is_box) {
      for (const CellMiddle& middle : cell_middles(mesh_.dimension))
        if (int& node = nodes[at(middle.node)]; node < 0)
          node = tree_.middle(leaf, nodes[at(middle.low)], nodes[at(middle.high)], place_in(leaf, middle.place));
      return nodes;
    }
    const std::vector<NodeCorners>& between = cell_info(type).node_corners;
    for (std::size_t a = at(leaf.count); a < nodes.size(); ++a)
      nodes[a] = tree_.middle(leaf, nodes[at(between[a][0])], nodes[at(between[a][1])], leaf.middle_place(between[a]));
    return nodes;
  }

  /// The place of a point of a box with coordinates from 0 to 1 along its axes.
  static RootPlace place_in(const TreeCell& box, const std::array<double, 3>& own) {
    RootPlace place{};
    for (std::size_t k = 0; k < 3; ++k) place[k] = box.lower[k] + own[k] * (box.upper[k] - box.lower[k]);
    return place;
  }

  void add_cells() {
    for (std::size_t b = 0; b < mesh_.blocks.size(); ++b) {
      const ElementBlock& old = before_.blocks[b];
      ElementBlock block = old;
      block.type = leaf_type(old);
      block.nodes.clear();
      block.file_numbers.clear();
      first_leaf_.emplace_back();
      for (int cell = 0; cell < old.cells(); ++cell) {
        first_leaf_.back().push_back(block.cells());
        tree_.for_each_leaf(static_cast<int>(b), cell, [&](const TreeCell& leaf) {
          const std::vector<int> nodes = nodes_of_leaf(leaf, block.type);
          block.nodes.insert(block.nodes.end(), nodes.begin(), nodes.end());
          if (!old.file_numbers.empty()) block.file_numbers.push_back(old.file_numbers[at(cell)]);
        });
      }
      mesh_.blocks[b] = std::move(block);
    }
  }

  /// The face of a whole cell on which a side lies, see TreeCell::faces().
  static int face_of(const TreeCell& whole, CellType type, int side) {
    const std::vector<int> corners = side_nodes(corner_type(type), side);
    const std::set<int> own(corners.begin(), corners.end());
    for (int face = 0; face < whole.faces(); ++face) {
      std::set<int> of_face;
      for (const int corner : whole.corners_on(face))
        of_face.insert(whole.shape == TreeShape::Box ? corner_bits(corner) : corner);
      if (of_face == own) return face;
    }
    throw std::logic_error("a side of a cell has no face");
  }
  /// The side of a simplex with those corners.
  static int side_with(CellType type, std::vector<int> corners) {
    const CellInfo& info = cell_info(corner_type(type));
    std::sort(corners.begin(), corners.end());
    for (std::size_t side = 0;; ++side) {
      std::vector<int> own = info.sides.at(side);
      std::sort(own.begin(), own.end());
      if (own == corners) return static_cast<int>(side);
    }
  }

  /// Calls visit(part) for the parts of a side of a cell of the mesh before.
  template <class Visit>
  void for_each_part(const Side& side, const Visit& visit) const {
    const CellType type = before_.blocks[at(side.block)].type;
    const TreeCell& whole = tree_.whole(side.block, side.cell);
    const bool is_box = whole.shape == TreeShape::Box;
    const int face = whole.shape == TreeShape::Whole ? -1 : face_of(whole, type, side.side);
    int leaf_number = first_leaf_[at(side.block)][at(side.cell)];
    tree_.for_each_leaf(side.block, side.cell, [&](const TreeCell& leaf) {
      const Side part{side.block, leaf_number++, side.side};
      if (face < 0) return visit(part);
      if (!leaf.touches(face)) return;
      visit(is_box ? part : Side{part.block, part.cell, side_with(type, leaf.corners_on(face))});
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

  /// A set that is not that of its sides gets the nodes between its own; if these are on the surface of the body, so
  /// are the new ones: an edge from one side of a thin body to the other leads through its inside.
  void add_node_sets() {
    const SetPairs of_sides = sets_of_sides(before_);
    std::vector<char> on_surface(at(mesh_.nodes()), 0);
    for (const Side& side : outside_)
      for (const int node : nodes_of_side(mesh_, side)) on_surface[at(node)] = 1;
    for (NodeSet& set : mesh_.node_sets) {
      std::vector<char> is_in(at(mesh_.nodes()), 0);
      for (const int node : set.nodes) is_in[at(node)] = 1;
      const bool is_outside =
          std::all_of(set.nodes.begin(), set.nodes.end(), [&](int node) { return on_surface[at(node)] != 0; });
      for (int node = nodes_before_; node < mesh_.nodes(); ++node) {
        const auto [a, b] = tree_.middles().origin(node);
        if (is_in[at(a)] == 0 || is_in[at(b)] == 0 || (is_outside && on_surface[at(node)] == 0)) continue;
        is_in[at(node)] = 1;
        set.nodes.push_back(node);
      }
    }
    renew_sets_of_sides(mesh_, of_sides);
  }

  /// Sides that one cell alone has are on the boundary, or hang.
  void find_hanging_sides() {
    std::set<std::array<int, 3>> outside;
    for (const Side& side : outside_) outside.insert({side.block, side.cell, side.side});
    for (const Side& side : boundary_sides(mesh_))
      if (outside.count({side.block, side.cell, side.side}) == 0) mesh_.hanging_sides.push_back(side);
  }

  Mesh& mesh_;
  CellTree& tree_;
  const Mesh before_;
  int nodes_before_;
  int order_;
  std::vector<Side> outside_;                 ///< parts of the sides that are the surface of the body
  std::vector<std::vector<int>> first_leaf_;  ///< by block and cell of the mesh before: its first leaf
};

/// Removes the nodes that no cell has any more. Returns the trees with the new numbers.
SplitTree without_unused(Mesh& mesh, const SplitTree& trees) {
  std::vector<int> number(at(mesh.nodes()), -1);
  const std::vector<std::string> notes = mesh.notes;
  const std::vector<int> before = drop_unused_nodes(mesh);
  mesh.notes = notes;
  mesh.linear_nodes = -1;
  for (std::size_t node = 0; node < before.size(); ++node) number[at(before[node])] = static_cast<int>(node);
  std::vector<TreeCell> cells = trees.cells();
  for (TreeCell& cell : cells)
    for (int corner = 0; corner < cell.count; ++corner) cell.corners[at(corner)] = number[at(cell.corners[at(corner)])];
  return trees.with(std::move(cells));
}

template <class Condition>
bool has_cells(const Mesh& mesh, const Condition& condition) {
  return std::any_of(mesh.blocks.begin(), mesh.blocks.end(),
                     [&](const ElementBlock& block) { return block.cells() > 0 && condition(cell_info(block.type)); });
}
bool has_cells(const Mesh& mesh, TreeShape shape) {
  return has_cells(mesh, [shape](const CellInfo& info) { return tree_shape(info.shape) == shape; });
}

void check(const Mesh& mesh) {
  if (mesh.plain_nodes >= 0) throw InputError("the mesh has enriched sides; refine it before it is enriched");
  if (!mesh.ties.empty()) throw InputError("the mesh has tied nodes already; refine it before they are tied");
  if (!has_cells(mesh, TreeShape::Box) && !has_cells(mesh, TreeShape::Simplex))
    throw InputError(
        "prisms and pyramids are not refined; give a mesh of them its size where it is made, or split them into "
        "tetrahedra");
}

/// Makes the mesh of the leaves of a tree, which grow(tree) splits.
template <class Growth>
SplitTree grown(Mesh& mesh, int order, const Growth& grow) {
  const bool curved = has_cells(mesh, [](const CellInfo& info) { return info.order == 2; });
  const bool bubbles = has_cells(mesh, [](const CellInfo& info) { return info.bubbles; });
  if (order == 2 && has_cells(mesh, TreeShape::Whole)) {
    raise_order(mesh);
    mesh.linear_nodes = -1;
  }
  const int nodes_before = mesh.nodes();
  CellTree tree(mesh);
  grow(tree);
  if (const int bounded = tree.bounded(); bounded > 0)
    mesh.notes.push_back(
        fmt::format("{} cell{} beside or near prisms or pyramids {} as fine as asked: those are not split", bounded,
                    bounded == 1 ? "" : "s", bounded == 1 ? "is not" : "are not"));
  LeafMesh(mesh, tree, nodes_before, order).make();
  SplitTree trees = tree.trees();
  if (curved && (order == 1 || bubbles)) trees = without_unused(mesh, trees);
  if (bubbles && order == 2) add_bubbles(mesh);
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

bool has_simplices(const Mesh& mesh) { return has_cells(mesh, TreeShape::Simplex); }

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
  for (std::size_t r = 0; r < searches.size(); ++r)
    if (!searches[r].splits_all() && has_simplices(mesh))
      throw InputError(names[r] + ": triangles and tetrahedra have no axes; leave Directions out");
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
    mesh.notes = trial.notes;
  }
  *splitting.tree = split(mesh, splits, order);  // numbers that depend on the splits alone
}

}  // namespace ixos
