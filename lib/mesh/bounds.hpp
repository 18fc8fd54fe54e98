/// The box around points.
#pragma once
#include <algorithm>
#include <limits>

#include "base/vec.hpp"
#include "mesh/mesh.hpp"
#include "mesh/node_place.hpp"

namespace ixos {

/// The least and the largest coordinates of points [L0]; before the first, infinity and its opposite.
struct Bounds {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec<3> lower{infinity, infinity, infinity}, upper{-infinity, -infinity, -infinity};

  void add(const Vec<3>& x) {
    for (std::size_t i = 0; i < 3; ++i) {
      lower[i] = std::min(lower[i], x[i]);
      upper[i] = std::max(upper[i], x[i]);
    }
  }
  double extent(std::size_t axis) const { return upper[axis] - lower[axis]; }
};

/// Returns the box around all nodes of a mesh at rest, those of derivatives included.
inline Bounds bounds_of(const Mesh& mesh) {
  Bounds bounds;
  for (int node = 0; node < mesh.nodes(); ++node) bounds.add(node_place(mesh, node));
  return bounds;
}

}  // namespace ixos
