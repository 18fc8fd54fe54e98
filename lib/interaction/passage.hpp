/// Points that pass through a body within one step.
#pragma once
#include <algorithm>
#include <array>
#include <limits>

#include "interaction/obstacle.hpp"

namespace ixos {

/// The straight way of a point through a body. Without a way through, `deepest` is infinity.
struct WayThrough {
  double start = 0, end = 0;                                 ///< gaps at both ends of the way [L0]
  double length = 0;                                         ///< of the way [L0]
  double deepest = std::numeric_limits<double>::infinity();  ///< the least gap that was found on the way [L0]
  /// Scalar product of the normals where the way enters the body and where it leaves it, or at an end inside.
  double turn = 1;
};

/// Returns whether a point has surely passed through the body, so that the law does not notice at the ends what it met
/// in between. Either it leaves the body at another side, or is pushed out there, and was more than twice as deep as at
/// one end. Or it was deeper than both ends, and than the surface, by more than `scale` [L0]. A point that slides along
/// the surface, so that both ends are no farther away than that, must be deeper by an eighth of its way, too: a chord
/// of a convex body is deeper than its ends by less, if it is shorter than the body's radius. A short step of a point
/// passes through nothing.
inline bool has_passed(const WayThrough& way, double scale) {
  if (!(way.deepest < 0)) return false;
  const bool at_another_side = way.turn < 0 && std::max(way.start, way.end) > way.deepest / 2;
  const bool slides = std::max(way.start, way.end) <= scale;
  const double least = slides ? std::max(scale, way.length / 8) : scale;
  return at_another_side || way.deepest < std::min({0.0, way.start, way.end}) - least;
}

/// Returns the way of a point from x0 to x1 through the obstacle, by samples between the places where it enters and
/// leaves it.
WayThrough way_through(const Obstacle& obstacle, const std::array<double, 3>& x0, const std::array<double, 3>& x1);

/// Returns the lanes in which way_through() can find a passage, as 1, and 0 for others: a point that moves by less than
/// its gap stays outside, and no way is deeper than the mean of the gaps at its ends less half of its length. Before an
/// obstacle whose gap changes faster than that it can miss lanes.
Pack may_pass(const Obstacle& obstacle, const PackPoint& x0, const PackPoint& x1, double scale);

}  // namespace ixos
