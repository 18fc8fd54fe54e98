/// Obstacles that a surface interacts with.
#pragma once
#include <array>
#include <cstddef>
#include <memory>

#include "base/pack.hpp"
#include "base/small_matrix.hpp"
#include "interaction/half_space.hpp"

namespace ixos {

/// A point in space, one pack for each coordinate; the third is 0 in two dimensions.
using PackPoint = std::array<Pack, 3>;

/// The obstacle as a point sees it.
struct Sight {
  Pack gap;               ///< signed distance to the obstacle's surface [L0], positive outside
  PackPoint normal;       ///< gradient of the gap, a unit vector
  Small<Pack, 3> bend{};  ///< second derivatives of the gap [1/L0], symmetric; bend normal = 0
};

/// The direction of the mean force over a step, and its derivative in the second point.
struct MeanSight {
  PackPoint normal;
  Small<Pack, 3> slope{};
};

/// A rigid body described by the signed distance to its surface. Obstacles know nothing of laws.
class Obstacle {
 public:
  virtual ~Obstacle() = default;

  /// Returns the half-space if the obstacle is one. Surfaces before it take a scalar path without normals.
  virtual const HalfSpace* half_space() const { return nullptr; }

  /// Returns distance, normal and curvature at the point x.
  virtual Sight at(const PackPoint& x) const = 0;

  /// Returns the size of the numbers whose difference the gap at x is [L0]: the gap's rounding error over the machine's
  /// epsilon. By default |x|.
  virtual Pack size_at(const PackPoint& x) const;

  /// Returns a direction n with n . (x1 - x0) = gap(x1) - gap(x0): with it, the force -T n with the mean traction T
  /// of the gaps does the work that the interaction's energy loses. By default n is the mean normal on the straight
  /// path by 3 Gauss points. If the normals vary so much that this mean is not exact to rounding, n is corrected along
  /// the path.
  virtual MeanSight mean(const PackPoint& x0, const PackPoint& x1) const;

  /// Returns the least gap on the straight path from x0 to x1, or less. By default the gap falls and rises along the
  /// tangents at both ends and in the middle. That is a lower bound before convex obstacles, where the gap is a convex
  /// function on the path. Before other obstacles it is an estimate.
  virtual Pack least_gap(const PackPoint& x0, const PackPoint& x1) const;

  /// Returns the largest s <= 1 for which the gap along x + s d stays at least `least`, or less. The gap at x exceeds
  /// `least`. By default sphere tracing: the distance is Lipschitz continuous with constant 1, so each round advances
  /// by the gap that exceeds `least`. It ends when a thousandth of that gap is left, or after 64 rounds: along a wall,
  /// a step ends after 64 times the gap that exceeds `least` at x.
  virtual Pack admissible_step(const PackPoint& x, const PackPoint& d, const Pack& least) const;
};

/// Returns the half-space as an obstacle.
std::shared_ptr<const Obstacle> flat_wall(const HalfSpace& wall);

}  // namespace ixos
