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
    if (cell(child).contains(other))
      k = child;
    else if (cell(child + 1).contains(other))
      k = child + 1;
    else
      break;
  }
  return k;
}

int SplitTree::leaf_at(const RootPoint& point) const {
  int k = root(point.block, point.root);
  while (!is_leaf(k)) {
    const int child = cell(k).first_child;
    if (cell(k).shape == TreeShape::Box) {
      const auto axis = static_cast<std::size_t>(axis_of(k));
      k = point.at[axis] <= cell(child).upper[axis] ? child : child + 1;
    } else {
      k = cell(child).depth(point.at) >= cell(child + 1).depth(point.at) ? child : child + 1;
    }
  }
  return k;
}

std::vector<int> SplitTree::leaves_at(const RootPoint& point, double slack) const {
  std::vector<int> open{root(point.block, point.root)}, found;
  while (!open.empty()) {
    const int k = open.back();
    open.pop_back();
    if (cell(k).depth(point.at) < -slack) continue;
    if (is_leaf(k)) {
      found.push_back(k);
    } else {
      open.push_back(cell(k).first_child + 1);
      open.push_back(cell(k).first_child);
    }
  }
  return found;
}

CellSplits SplitTree::splits() const {
  CellSplits splits;
  for (std::size_t k = 0; k < cells_.size(); ++k)
    if (cells_[k].is_split()) splits.add(cells_[k], axis_of(static_cast<int>(k)));
  return splits;
}

}  // namespace ixos
