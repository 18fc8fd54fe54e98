/// Nodes of two surfaces that face each other.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos {

/// Sides of one surface near those of another, by pairs of nodes.
struct FacingNodes {
  std::vector<std::pair<int, int>> pairs;  ///< a node of the first surface, a node of the second one
  std::vector<Side> sides;                 ///< those of the first surface, once each
};

/// Returns the sides of the side set `first` whose middle is nearer to that of the nearest side of `second` than
/// `distance` and the sizes of both sides, in the undeformed mesh, and pairs of their nodes: each node of such a side
/// with the nearest one of the other side [L0]. Boost.Geometry's R-tree finds the nearest sides.
FacingNodes facing_nodes(const Mesh& mesh, const std::string& first, const std::string& second, double distance);

}  // namespace ixos
