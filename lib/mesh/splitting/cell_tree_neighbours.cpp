// Neighbours of the cells of a tree: they need nodes on shared edges, and levels beside cells that are never split.
#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>

#include "mesh/splitting/cell_tree.hpp"

namespace ixos {

/// Cells that are never split, and those with one of their nodes, stay as they are.
void CellTree::bound_levels() {
  std::vector<char> of_whole_cells(corner_.size(), 0);
  for (const TreeCell& cell : cells_)
    for (int corner = 0; corner < (cell.shape == TreeShape::Whole ? cell.count : 0); ++corner)
      of_whole_cells[at(cell.corners[at(corner)])] = 1;
  most_.assign(at(roots_), std::numeric_limits<int>::max());
  for (int root = 0; root < roots_; ++root)
    for (int corner = 0; corner < cells_[at(root)].count; ++corner)
      if (of_whole_cells[at(cells_[at(root)].corners[at(corner)])] != 0) most_[at(root)] = 0;
}

std::vector<int> CellTree::levels_of(const std::vector<TreeCell>& cells) const {
  std::vector<int> level(at(roots_), 0);
  for (const TreeCell& cell : cells) {
    int& own = level[at(root(cell.block, cell.root))];
    own = std::max(own, cell.level());
  }
  return level;
}

void CellTree::keep_levels(const SplitTree& trees) { kept_ = levels_of(trees.cells()); }

/// Lowers the levels that the cells around torn ones may have: of all that have more than these, whether or not they
/// are the ones that tear them.
void CellTree::lower_bounds() {
  const std::vector<int> level = levels_of(cells_);
  std::vector<std::vector<int>> around(corner_.size());  // roots by node
  for (int root = 0; root < roots_; ++root)
    for (int corner = 0; corner < cells_[at(root)].count; ++corner)
      around[at(cells_[at(root)].corners[at(corner)])].push_back(root);
  std::sort(torn_.begin(), torn_.end());
  torn_.erase(std::unique(torn_.begin(), torn_.end()), torn_.end());
  for (const int torn : torn_) {
    std::set<int> neighbours;
    for (int corner = 0; corner < cells_[at(torn)].count; ++corner)
      for (const int root : around[at(cells_[at(torn)].corners[at(corner)])]) neighbours.insert(root);
    // Those that are finer than both this cell may be and they have to stay; else those that are finer; else all.
    const std::array<std::function<int(int)>, 3> least{
        [&](int root) { return std::max(most_[at(torn)], kept_.empty() ? 0 : kept_[at(root)]); },
        [&](int) { return most_[at(torn)]; }, [](int) { return 0; }};
    for (const auto& bound : least) {
      bool any = false;
      for (const int root : neighbours) {
        if (level[at(root)] <= bound(root)) continue;
        any = true;
        // A level more than the torn cell's is what neighbours may have without effort.
        const int step = cells_[at(root)].shape == TreeShape::Simplex ? mesh_.dimension : 1;
        const int lower = std::max(bound(root), std::min(level[at(root)] - 1, most_[at(torn)] + step));
        most_[at(root)] = std::min(most_[at(root)], lower);
      }
      if (any) break;
    }
  }
}

bool CellTree::has_two_on_an_edge(const TreeCell& cell, int axis) {
  for (const auto& [left, right] : edges_[at(axis)]) {
    const int a = cell.corners[at(left)], b = cell.corners[at(right)], m = middles_.find(a, b);
    if (m < 0 || !is_corner(m)) continue;
    for (const int end : {a, b})
      if (const int quarter = middles_.find(end, m); quarter >= 0 && is_corner(quarter)) return true;
  }
  return false;
}

/// Returns the edges of leaves that cross one of another leaf on a face: one of both must be halved, for no field of
/// the one is a field of the other.
std::set<std::array<int, 2>> CellTree::crossing_edges() {
  const auto sorted = [](std::array<int, 2> edge) {
    std::sort(edge.begin(), edge.end());
    return edge;
  };
  std::set<std::array<int, 2>> all, crossing;
  for (const int leaf : leaves())
    for (int axis = 0; axis < (cells_[at(leaf)].shape == TreeShape::Box ? mesh_.dimension : 0); ++axis)
      for (const auto& [left, right] : edges_[at(axis)])
        all.insert(sorted({cells_[at(leaf)].corners[at(left)], cells_[at(leaf)].corners[at(right)]}));
  for (const std::array<int, 2>& edge : all)
    for (const std::array<int, 2>& other : middles_.crossing(edge[0], edge[1]))
      if (all.count(sorted(other)) > 0) crossing.insert(edge);
  return crossing;
}

bool CellTree::has_one_of(const std::set<std::array<int, 2>>& edges, const TreeCell& cell, int axis) const {
  if (edges.empty()) return false;
  return std::any_of(edges_[at(axis)].begin(), edges_[at(axis)].end(), [&](const std::array<int, 2>& edge) {
    const int a = cell.corners[at(edge[0])], b = cell.corners[at(edge[1])];
    return edges.count({std::min(a, b), std::max(a, b)}) > 0;
  });
}

bool CellTree::has_middle_on_an_edge(const TreeCell& cell) {
  for (int a = 0; a < cell.count; ++a)
    for (int b = 0; b < a; ++b)
      if (const int m = middles_.named(cell.corners[at(a)], cell.corners[at(b)]); m >= 0 && is_corner(m)) return true;
  return false;
}

/// Returns the axes along which a leaf is to be halved because of the nodes of others on its edges.
std::vector<int> CellTree::axes_for_others(const TreeCell& cell, const std::set<std::array<int, 2>>& crossed,
                                           bool in_all_directions) {
  if (cell.shape == TreeShape::Whole) return {};  // those beside it stay as they are
  if (cell.shape == TreeShape::Simplex) return has_middle_on_an_edge(cell) ? std::vector<int>{0} : std::vector<int>();
  std::vector<int> axes;
  for (int axis = 0; axis < mesh_.dimension; ++axis)
    if (has_two_on_an_edge(cell, axis) || has_one_of(crossed, cell, axis)) axes.push_back(axis);
  if (axes.empty() || !in_all_directions) return axes;
  axes.resize(at(mesh_.dimension));
  std::iota(axes.begin(), axes.end(), 0);
  return axes;
}

/// Splits leaves with too many nodes of others on an edge. Returns whether there were any.
bool CellTree::balance(bool in_all_directions) {
  const auto crossed = in_all_directions ? std::set<std::array<int, 2>>() : crossing_edges();
  bool changed = false;
  for (const int leaf : leaves()) {
    const TreeCell& cell = cells_[at(leaf)];
    const std::vector<int> axes = axes_for_others(cell, crossed, in_all_directions);
    if (axes.empty()) continue;
    if (!may_be_split(cell)) {
      torn_.push_back(root(cell.block, cell.root));
      continue;
    }
    halve(leaf, axes);
    changed = true;
  }
  return changed;
}

}  // namespace ixos
