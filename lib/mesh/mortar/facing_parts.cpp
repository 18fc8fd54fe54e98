#include "mesh/mortar/facing_parts.hpp"

#include <algorithm>
#include <boost/geometry/algorithms/expand.hpp>
#include <boost/geometry/arithmetic/arithmetic.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <iterator>
#include <limits>
#include <optional>

namespace ixos {
namespace {

namespace bg = boost::geometry;

/// The largest distance between points of both with one image, at the corners of a part.
double distance_at(const Facet& side, const Facet& other, const ProjectionPlane& plane, const Polygon& part) {
  double largest = 0;
  for (const Vec<2>& corner : part) {
    const std::optional<Vec<2>> own = side.find(plane, corner), opposite = other.find(plane, corner);
    if (!own || !opposite) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, length(other.point(*opposite) - side.point(*own)));
  }
  return largest;
}

}  // namespace

FacingFacets::Box FacingFacets::box_around(const Facet& side, double beyond) {
  Box box(tree_point(side.middle()), tree_point(side.middle()));
  for (const Vec<3>& place : side.places()) bg::expand(box, tree_point(place));
  const TreePoint all = tree_point({beyond, beyond, beyond});
  bg::add_point(box.max_corner(), all);
  bg::subtract_point(box.min_corner(), all);
  return box;
}

FacingFacets::FacingFacets(const std::vector<Facet>& sides) : facets_(sides) {
  std::vector<Entry> entries;
  entries.reserve(sides.size());
  for (std::size_t k = 0; k < sides.size(); ++k) entries.emplace_back(box_around(sides[k], 0), k);
  tree_ = decltype(tree_)(entries);
}

FacingParts FacingFacets::parts_of(const Facet& side, double reach) const {
  const ProjectionPlane plane = side.plane();
  const std::vector<Polygon> own = side.images(plane);
  double whole = 0;
  for (const Polygon& polygon : own) whole += area(polygon);
  std::vector<Entry> near;
  tree_.query(bg::index::intersects(box_around(side, reach + side.size())), std::back_inserter(near));
  std::sort(near.begin(), near.end(), [](const Entry& a, const Entry& b) { return a.second < b.second; });
  FacingParts result;
  for (const Entry& entry : near) {
    const Facet& other = facets_[entry.second];
    if (inner(other.normal(), side.normal()) > -0.5 * length(other.normal()) * length(side.normal())) continue;
    const std::vector<Polygon> opposite = other.images(plane);
    for (const Polygon& a : own)
      for (const Polygon& b : opposite) {
        Polygon part = common_part(a, b);
        if (part.empty() || area(part) <= 1e-12 * whole) continue;
        if (const double distance = distance_at(side, other, plane, part); distance > reach) {
          result.too_far = result.too_far > 0 ? std::min(result.too_far, distance) : distance;
        } else {
          result.covered += area(part) / whole;
          result.parts.push_back({&other, std::move(part)});
        }
      }
  }
  return result;
}

}  // namespace ixos
