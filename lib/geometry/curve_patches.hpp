/// Curves between the nodes of a surface in the plane.
#pragma once
#include "geometry/surface_patch.hpp"

namespace ixos {

/// Returns the straight segment from node a to node b.
SurfacePatch<2> straight_patch(int a, int b);

/// Returns the cubic segment from node 1 to node 2 whose tangents at its ends are those of the parabolas through three
/// nodes, x_0, x_1, x_2 and x_1, x_2, x_3, over the lengths of the sides between them in the undeformed body [L0]: with
/// equal lengths Catmull and Rom's (1974). A negative node 0 or 3 is none: there the tangent is that of the side, as if
/// the missing node were 2 x_1 - x_2.
SurfacePatch<2> smooth_patch(const std::array<int, 4>& nodes, const std::array<double, 3>& lengths);

/// Returns the segment from node 2 to node 3 of the cubic spline whose control points are (-x_0 + 8 x_1 - x_2)/6 at
/// node 1, and so on: segments with common nodes have one tangent and one curvature where they meet. On evenly spaced
/// nodes the spline approximates the curve of the nodes to fourth order in their distance (de Boor and Fix 1973).
/// Negative nodes are none, then so are those beyond them: there the curve ends in the last node, without curvature.
SurfacePatch<2> spline_patch(const std::array<int, 6>& nodes);

/// Cubic polynomials on [0, 1] that have the value 1, or the slope 1, at one end, and otherwise neither value nor slope
/// at the ends: coefficients by power.
using Cubic = std::array<double, 4>;
constexpr Cubic start_value{1, 0, -3, 2}, end_value{0, 0, 3, -2};
constexpr Cubic start_slope{0, 1, -2, 1}, end_slope{0, 0, -1, 1};

/// Weights of the nodes before, at and after a node in the tangent of the parabola through them by their distance along
/// the line, of which `before` and `after` are the lengths of its two sides [L0].
std::array<double, 3> parabola_slope(double before, double after);

}  // namespace ixos
