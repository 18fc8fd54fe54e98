/// Convex polygons of a plane.
#pragma once
#include <vector>

#include "base/vec.hpp"

namespace ixos {

/// Corners counter-clockwise [L0]. Two corners are a segment of the line y = 0, x ascending.
using Polygon = std::vector<Vec<2>>;

/// Returns the area [L0^2], of a segment its length [L0].
double area(const Polygon& polygon);

/// Returns what two convex polygons, or two segments, have in common; empty if they have no area in common. Each edge
/// of `b` cuts off a part of `a` (Sutherland and Hodgman 1974, Commun. ACM 17), so that edges of both that coincide but
/// for rounding cost slivers of that width, no more.
Polygon common_part(const Polygon& a, const Polygon& b);

/// A point of a polygon, and its share of the area.
struct PolygonPoint {
  Vec<2> place;
  double weight;
};

/// Returns the points of a rule that is exact for polynomials of this degree: Gauss points on a segment, those of
/// triangle_rule() on the triangles from the first corner.
std::vector<PolygonPoint> points_of(const Polygon& polygon, int degree);

}  // namespace ixos
