/// The splits of a mesh's cells as a value.
#pragma once
#include <array>
#include <cstddef>
#include <map>
#include <string>

namespace ixos {

struct TreeCell;

/// The bisections of a mesh's cells and of their parts. It can be kept, compared and written: split() makes the same
/// mesh of it again.
class CellSplits {
 public:
  /// Notes that the cell, or part of one, is bisected along an axis; 0 for simplices.
  void add(const TreeCell& cell, int axis);
  /// Returns the axis along which the cell is bisected; -1: it is not.
  int axis(const TreeCell& cell) const;

  /// Returns whether each split of the other ones is one of these.
  bool contain(const CellSplits& others) const;
  std::size_t size() const { return axis_.size(); }
  bool operator==(const CellSplits& other) const { return axis_ == other.axis_; }
  bool operator!=(const CellSplits& other) const { return !(*this == other); }

  /// Returns the splits as text for a file, nine numbers each, and makes them of such a text. Throws InputError for a
  /// text that is none.
  std::string text() const;
  static CellSplits of_text(const std::string& text);

 private:
  /// Block, cell, halvings along each axis, and how many parts of that length come before it along each axis. A
  /// simplex has its block, its cell, the number of bisections, 0, 0, and its path in parts of 31 bits.
  using Key = std::array<int, 8>;
  static Key key(const TreeCell& cell);

  std::map<Key, int> axis_;
};

}  // namespace ixos
