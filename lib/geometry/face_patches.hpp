/// Patches over the four-sided faces of a surface in space.
#pragma once
#include <array>
#include <vector>

#include "geometry/surface_patch.hpp"

namespace ixos {

/// Weights of nodes in a number that is linear in their places.
struct NodeWeights {
  std::vector<int> nodes;
  std::vector<double> weights;
  /// Adds `weight` to the weight of the node.
  void add(int node, double weight);
  /// Adds a multiple of other weights.
  void add(const NodeWeights& own, double factor);
  /// Returns the weight of a node, 0 if it has none.
  double weight(int node) const;
};

/// The derivatives of a smooth face at a corner: by the lengths along the lines of the grid that belong to the first
/// and the second parameter, and the mixed one. Lengths are those of the undeformed body [L0].
struct CornerDerivatives {
  NodeWeights first, second, mixed;
};

/// Returns the bilinear patch of four corners, counter-clockwise seen from outside. The first parameter grows from
/// corner 0 to corner 1, the second from corner 0 to corner 3.
SurfacePatch<3> bilinear_patch(const std::array<int, 4>& corners);

/// Returns the bicubic patch of four corners, counter-clockwise, with these derivatives at them. `lengths`: the length
/// that the first and the second parameter have in the undeformed body [L0]. If the derivatives at a node are the same
/// for two faces that share an edge, up to the direction of the parameters, both patches have the same places and
/// tangent planes all along the edge.
SurfacePatch<3> bicubic_patch(const std::array<int, 4>& corners, const std::array<CornerDerivatives, 4>& derivatives,
                              const std::array<double, 2>& lengths);

/// Returns the bicubic patch of four corners, counter-clockwise, with the control points of Bezier, which are linear in
/// places of nodes: those along the first parameter fastest. Throws std::length_error if it has more than
/// SurfacePatch<3>::most nodes.
SurfacePatch<3> bezier_patch(const std::array<int, 4>& corners, const std::array<NodeWeights, 16>& controls);

}  // namespace ixos
