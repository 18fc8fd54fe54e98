/// Cells that are halved, and their parts.
#pragma once
#include <array>
#include <cstddef>

namespace ixos {

/// A cell of a mesh, or a part of one. Corners stand in the order of bits: bit k tells the end along the cell's axis k.
struct TreeCell {
  int block, root;  ///< the cell of the mesh
  std::array<int, 8> corners;
  std::array<int, 3> halvings;         ///< along each axis
  std::array<double, 3> lower, upper;  ///< its place in that cell, whose axes go from -1 to 1
  int first_child = -1;                ///< two cells, one behind the other; -1: not split

  /// Returns whether a box in the same cell lies in this one.
  bool contains(const std::array<double, 3>& low, const std::array<double, 3>& high) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (low[k] < lower[k] || high[k] > upper[k]) return false;
    return true;
  }
};

}  // namespace ixos
