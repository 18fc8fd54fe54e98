/// A surface in the plane, its sides as curves, at one place of its nodes: the search for nearest points.
#pragma once
#include <limits>
#include <memory>
#include <vector>

#include "interaction/curve_segment.hpp"

namespace ixos {

/// The point of a surface that is nearest to a place.
struct SurfaceFoot {
  int segment = -1;  ///< -1: the surface is out of range
  double t = 0;      ///< on the segment, in [0, 1]
  int end = -1;      ///< the corner or free end that is nearest, 0 or 1; -1: the foot is inside, see CurveFoot
  double gap = std::numeric_limits<double>::infinity();  ///< signed least distance, negative in the body [L0]
  Planar normal{};                                       ///< unit vector, the gap's gradient in the place
};

/// Segments at places of their nodes, in a tree of their bounding boxes (Boost.Geometry's R-tree, packed), so that a
/// search visits few of them. The result depends on the places alone: of two segments that are equally near, it is the
/// one with the lower number. The segments must outlive it.
class PlacedCurves {
 public:
  /// `x`: places of the nodes, by the numbers that segments have [L0].
  PlacedCurves(const std::vector<CurveSegment>& segments, const std::vector<Planar>& x);
  ~PlacedCurves();
  PlacedCurves(PlacedCurves&&) noexcept;
  PlacedCurves& operator=(PlacedCurves&&) = delete;
  PlacedCurves(const PlacedCurves&) = delete;
  PlacedCurves& operator=(const PlacedCurves&) = delete;

  /// Returns the places of a segment's nodes.
  CurveSegment::Points points(int segment) const;
  /// Returns the nearest point if it is nearer than `range`; else a foot without a segment. The gap is positive on the
  /// outer side. At a corner the sum of the normals of its two sides tells the outer side (Baerentzen and Aanaes 2005);
  /// beyond a free end it is positive.
  SurfaceFoot nearest(const Planar& place, double range = std::numeric_limits<double>::infinity()) const;
  /// Returns how far the nodes and the place may move along their ways, as a factor s in [0, 1], while the distance
  /// surely stays at least `least`: until the place or a point of a segment's hull, relative to each other, has moved
  /// as far as the distance exceeds it, or, if that is later, until the plane through the foot that separates them no
  /// longer does by it. `ways`: by node, as x.
  double free_share(const Planar& place, const Planar& way, const std::vector<Planar>& ways, double least) const;

 private:
  struct Tree;
  Planar normal_at(int segment, double t) const;
  bool is_outside(const Planar& from_end, int segment, int end) const;

  const std::vector<CurveSegment>& segments_;
  const std::vector<Planar>& x_;
  std::unique_ptr<Tree> tree_;
};

/// Returns the outward unit normal of a segment, on the right of its direction.
Planar normal_of(const CurveSegment& segment, const CurveSegment::Points& x, double t);

}  // namespace ixos
