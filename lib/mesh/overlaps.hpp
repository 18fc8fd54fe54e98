/// Overlapping bodies.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos {

/// Two meshes, by their place in a list, and a node or the centre of a cell of the first one inside the second.
struct Overlap {
  std::size_t first, second;
  std::array<double, 3> place;  ///< [L0]
};

/// Returns an overlap of two of the meshes, or none; bodies that touch do not overlap. Only points count that are
/// deeper below the surface than `depth`, a part of the least side of the cell there. A point is inside a cell that is
/// on the inner side of the planes through all its faces: curved and bent cells are taken as their corners have them. A
/// body that passes between all nodes and centres of another one is not found.
std::optional<Overlap> find_overlap(const std::vector<const Mesh*>& meshes, double depth = 1e-9);

}  // namespace ixos
