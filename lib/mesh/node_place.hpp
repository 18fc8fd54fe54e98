/// Places of nodes as vectors of three components.
#pragma once
#include "base/vec.hpp"
#include "mesh/mesh.hpp"

namespace ixos {

/// Returns where a node is at rest [L0]; the third component is 0 in two dimensions.
inline Vec<3> node_place(const Mesh& mesh, int node) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  Vec<3> place{};
  for (std::size_t i = 0; i < d; ++i) place[i] = mesh.coordinates[static_cast<std::size_t>(node) * d + i];
  return place;
}

}  // namespace ixos
