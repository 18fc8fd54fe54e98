/// The cells of a mesh and their parts, after they were split.
#pragma once
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "mesh/splitting/cell_splits.hpp"
#include "mesh/splitting/tree_cell.hpp"

namespace ixos {

/// A point of a cell that may be split: the cell's block and number, and the place there.
struct RootPoint {
  int block = 0, root = 0;
  RootPlace at{};
};

/// A value: the trees of all cells of a mesh, which outlive it. Corners are nodes of the mesh of the leaves.
class SplitTree {
 public:
  SplitTree() = default;
  /// `cells`: the whole cells first, block by block; `first_root`: by block, the first of them.
  SplitTree(int dimension, std::vector<TreeCell> cells, std::vector<int> first_root)
      : dimension_(dimension), cells_(std::move(cells)), first_root_(std::move(first_root)) {}

  int dimension() const { return dimension_; }
  const std::vector<TreeCell>& cells() const { return cells_; }
  const TreeCell& cell(int k) const { return cells_[static_cast<std::size_t>(k)]; }
  bool is_leaf(int k) const { return !cell(k).is_split(); }
  int root(int block, int cell) const { return first_root_[static_cast<std::size_t>(block)] + cell; }

  /// Returns the axis along which a cell that is no leaf is bisected; 0 for simplices.
  int axis_of(int k) const;
  /// Returns the smallest cell of this tree that contains a cell of another tree of the same whole cells.
  int around(const TreeCell& other) const;
  /// Returns a leaf that contains a point; on a border of several one of them.
  int leaf_at(const RootPoint& point) const;
  /// Returns all leaves that contain a point, or whose TreeCell::depth() there is at least -slack.
  std::vector<int> leaves_at(const RootPoint& point, double slack) const;
  CellSplits splits() const;
  /// Returns the same trees with other numbers of corners.
  SplitTree with(std::vector<TreeCell> cells) const { return {dimension_, std::move(cells), first_root_}; }

 private:
  int dimension_ = 0;
  std::vector<TreeCell> cells_;
  std::vector<int> first_root_;
};

}  // namespace ixos
