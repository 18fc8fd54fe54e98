#include "mesh/mortar/polygon.hpp"

#include <algorithm>
#include <cstddef>

#include "fem/simplex_rules.hpp"

namespace ixos {
namespace {

double cross(const Vec<2>& a, const Vec<2>& b) { return a[0] * b[1] - a[1] * b[0]; }

/// The part on the left of the line from `from` to `to`.
Polygon left_part(const Polygon& polygon, const Vec<2>& from, const Vec<2>& to) {
  Polygon kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec<2>&here = polygon[k], &next = polygon[(k + 1) % polygon.size()];
    const double side = cross(to - from, here - from), next_side = cross(to - from, next - from);
    if (side >= 0) kept.push_back(here);
    if ((side > 0 && next_side < 0) || (side < 0 && next_side > 0))
      kept.push_back(here + side / (side - next_side) * (next - here));
  }
  return kept;
}

}  // namespace

double area(const Polygon& polygon) {
  if (polygon.size() == 2) return polygon[1][0] - polygon[0][0];
  double twice = 0;
  for (std::size_t k = 2; k < polygon.size(); ++k) twice += cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
  return twice / 2;
}

Polygon common_part(const Polygon& a, const Polygon& b) {
  Polygon common = a;
  if (a.size() == 2) {
    common = {{std::max(a[0][0], b[0][0]), 0.0}, {std::min(a[1][0], b[1][0]), 0.0}};
  } else {
    for (std::size_t k = 0; k < b.size() && !common.empty(); ++k)
      common = left_part(common, b[k], b[(k + 1) % b.size()]);
  }
  // Polygons that touch may have an edge in common, which is no segment of the line y = 0.
  return (common.size() > 2 || a.size() == 2) && area(common) > 0 ? common : Polygon();
}

std::vector<PolygonPoint> points_of(const Polygon& polygon, int degree) {
  std::vector<PolygonPoint> points;
  if (polygon.size() == 2) {
    const Quadrature rule = gauss_legendre_unit(degree / 2 + 1);
    points.reserve(rule.points.size());
    for (std::size_t q = 0; q < rule.points.size(); ++q)
      points.push_back({polygon[0] + rule.points[q] * (polygon[1] - polygon[0]), rule.weights[q] * area(polygon)});
    return points;
  }
  const QuadratureRule<2> rule = triangle_rule(degree <= 4 ? 2 : degree / 2 + 2);
  points.reserve((polygon.size() - 2) * rule.size());
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    const Vec<2> u = polygon[k - 1] - polygon[0], v = polygon[k] - polygon[0];
    for (std::size_t q = 0; q < rule.size(); ++q)
      points.push_back({polygon[0] + rule.points[q][0] * u + rule.points[q][1] * v, rule.weights[q] * cross(u, v)});
  }
  return points;
}

}  // namespace ixos
