/// The parts of a side that other sides face.
#pragma once
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cstddef>
#include <utility>
#include <vector>

#include "mesh/mortar/facet.hpp"
#include "mesh/tree_point.hpp"

namespace ixos {

/// A part of a side that another side faces: a convex polygon of the former's plane; or a part of a
/// curve.
struct FacingPart {
  const Facet* other;
  Polygon polygon;
};

/// The parts of a side, and what is wrong with them.
struct FacingParts {
  std::vector<FacingPart> parts;
  double covered = 0;  ///< the parts' area over that of the side [-]
  double too_far = 0;  ///< the least distance of sides that are left out because they are too far away [L0]; 0: none
};

/// Sides, to be found by what faces them (Boost.Geometry's R-tree).
class FacingFacets {
 public:
  /// Refers to the sides.
  explicit FacingFacets(const std::vector<Facet>& sides);

  /// Returns the parts of `side` that these sides face at a distance of at most `reach` across it [L0]. Normals, if
  /// any, are opposite but for 60 degrees.
  FacingParts parts_of(const Facet& side, double reach) const;

 private:
  using Box = boost::geometry::model::box<TreePoint>;
  using Entry = std::pair<Box, std::size_t>;
  static Box box_around(const Facet& side, double beyond);

  const std::vector<Facet>& facets_;
  boost::geometry::index::rtree<Entry, boost::geometry::index::rstar<16>> tree_;
};

}  // namespace ixos
