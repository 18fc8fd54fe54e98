/// Means of numbers at points of a cell or a side, at another point of it.
#pragma once
#include <cstddef>
#include <vector>

#include "mesh/splitting/tree_cell.hpp"

namespace ixos {

/// A point's share in a mean; the shares are not negative and their sum is 1.
struct ShareOfPoint {
  std::size_t point = 0;
  double weight = 0;
};

/// Difference of reference coordinates up to which two are one.
constexpr double same_place = 1e-10;

/// Returns the shares of the points of a tensor grid: linear between them along each axis, constant beyond.
std::vector<ShareOfPoint> shares_in_grid(const std::vector<RootPlace>& grid, const RootPlace& at);

/// Returns the shares of points of a triangle or a tetrahedron, or of one of its faces: linear in the smallest simplex
/// of points near the place that contains it, or if none does, the point of all these that is closest to it; the mean
/// if several are as small. `dimension`: that of the cell; `along`: that of the points, less by one on a face.
std::vector<ShareOfPoint> shares_in_simplex(const std::vector<RootPlace>& points, int dimension, int along,
                                            const RootPlace& at);

}  // namespace ixos
