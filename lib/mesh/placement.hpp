/// Meshes moved as rigid bodies.
#pragma once
#include <array>

#include "mesh/mesh.hpp"

namespace ixos {

/// A rotation, then a translation.
struct Placement {
  double angle = 0;                           ///< of the rotation, counter-clockwise [degrees]
  std::array<double, 3> axis{0.0, 0.0, 1.0};  ///< of the rotation, a unit vector; in two dimensions z
  std::array<double, 3> point{};              ///< on the axis [L0]
  std::array<double, 3> translation{};        ///< [L0]
};

/// Moves all nodes of a mesh: x becomes point + R (x - point) + translation, with the rotation matrix R of Rodrigues'
/// formula. Angles that are multiples of 90 degrees have exact sines and cosines. The mesh must not be enriched.
void move_nodes(const Placement& placement, Mesh& mesh);

}  // namespace ixos
