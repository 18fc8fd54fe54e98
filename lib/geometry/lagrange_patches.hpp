/// Sides of higher order as patches.
#pragma once
#include <vector>

#include "fem/ties.hpp"
#include "geometry/surface_patch.hpp"
#include "mesh/local_mesh.hpp"

namespace ixos {

/// Returns, by place, the coefficients by power of the polynomial that is 1 there and 0 at the others.
std::vector<std::vector<double>> lagrange_polynomials(const std::vector<double>& places);

/// Returns the patch of a side with Lagrange's interpolation, whose order follows from the number of its nodes: 3 to 5
/// nodes in the order of LagrangeEdge in the plane, 9, 16 or 25 in that of LagrangeFace in space. The corners come
/// first. It has no part in `tied` nodes, whose values follow from others; their numbers do not count. Throws
/// std::logic_error for another number.
template <std::size_t D>
SurfacePatch<D> lagrange_patch(const std::vector<int>& nodes, const std::vector<InnerNode>& tied = {});

/// Returns the nodes of a side that are on its tied edges.
std::vector<InnerNode> tied_nodes(const LocalBlock& block, int side);

}  // namespace ixos
