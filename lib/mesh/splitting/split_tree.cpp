#include "mesh/splitting/split_tree.hpp"

namespace ixos {

int SplitTree::axis_of(int k) const {
  const TreeCell &whole = cell(k), &low = cell(whole.first_child);
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (low.halvings[axis] != whole.halvings[axis]) return static_cast<int>(axis);
  return -1;
}

int SplitTree::around(const TreeCell& other) const {
  int k = root(other.block, other.root);
  while (!is_leaf(k)) {
    const int child = cell(k).first_child;
    if (cell(child).contains(other.lower, other.upper))
      k = child;
    else if (cell(child + 1).contains(other.lower, other.upper))
      k = child + 1;
    else
      break;
  }
  return k;
}

int SplitTree::leaf_at(const RootPoint& point) const {
  int k = root(point.block, point.root);
  while (!is_leaf(k)) {
    const auto axis = static_cast<std::size_t>(axis_of(k));
    const int child = cell(k).first_child;
    k = point.at[axis] <= cell(child).upper[axis] ? child : child + 1;
  }
  return k;
}

CellSplits SplitTree::splits() const {
  CellSplits splits;
  for (std::size_t k = 0; k < cells_.size(); ++k)
    if (cells_[k].first_child >= 0) splits.add(cells_[k], axis_of(static_cast<int>(k)));
  return splits;
}

}  // namespace ixos
