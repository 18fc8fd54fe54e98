/// Obstacles that a surface interacts with.
#pragma once
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>

#include "base/pack.hpp"
#include "base/small_matrix.hpp"
#include "base/vector3.hpp"
#include "interaction/half_space.hpp"

namespace ixos {

struct AreaFactor;

/// A point in space, one pack for each coordinate; the third is 0 in two dimensions.
using PackPoint = std::array<Pack, 3>;

inline Pack length_of(const PackPoint& x) { return std::experimental::sqrt(dot(x, x)); }

/// Returns a divisor for a length: the length, or a tiny number in place of zero.
inline Pack positive(const Pack& length) { return std::experimental::max(length, Pack(1e-290)); }

/// The gap of a point before an obstacle, to second order.
struct ObstacleGap {
  Pack gap;               ///< signed distance to the obstacle's surface [L0], positive outside
  PackPoint normal;       ///< gradient of the gap, a unit vector except of a vertical gap
  Small<Pack, 3> bend{};  ///< second derivatives of the gap [1/L0], symmetric; bend normal = 0
};

/// The gap over a way between two points: the direction of the mean force and its derivative in the second point,
/// the gaps at both points, and the normal at the second one.
struct MeanGap {
  PackPoint normal;
  Small<Pack, 3> slope{};
  Pack start_gap, end_gap;
  PackPoint end_normal;
};

/// A rigid body described by the signed distance to its surface. Obstacles know nothing of laws.
class Obstacle {
 public:
  virtual ~Obstacle() = default;

  /// Returns the half-space if the obstacle is one. Surfaces before it take a scalar path without normals.
  virtual const HalfSpace* half_space() const { return nullptr; }

  /// Returns distance, normal and curvature at the point x. The gap is minus infinity where no surface may be: such a
  /// state is inadmissible.
  virtual ObstacleGap at(const PackPoint& x) const = 0;

  /// Returns the same. The second derivatives may be missing.
  virtual ObstacleGap gap_and_normal(const PackPoint& x) const { return at(x); }

  /// Returns the gap alone.
  virtual Pack gap(const PackPoint& x) const { return at(x).gap; }

  /// Returns the gap, or a lower bound of the same sign that is easier to compute. Minus infinity where the gap is.
  virtual Pack gap_or_less(const PackPoint& x) const { return gap(x); }

  /// Returns the gap up to which the distance is smooth [L0]: a law must have ended there. Beyond it several points of
  /// the obstacle may be nearest, and normal and bend are finite but may jump. Infinity by default.
  virtual double reach() const { return std::numeric_limits<double>::infinity(); }

  /// Returns the factor of the law's energy that the obstacle's curvature asks for; nothing by default. A body of
  /// revolution has `body_dimension` 3. Throws InputError if the factor has no meaning for such a body.
  virtual std::optional<AreaFactor> area_factor(int body_dimension) const;

  /// Returns the length of a path from x in any direction on which the gap stays at least `least`, or less. By default
  /// gap - least: the distance is Lipschitz continuous with constant 1.
  virtual Pack free_way(const PackPoint& x, const Pack& least) const { return gap(x) - least; }

  /// Returns the size of the numbers whose difference the gap at x is [L0]: the gap's rounding error over the machine's
  /// epsilon. By default |x|.
  virtual Pack size_at(const PackPoint& x) const;

  /// Returns a direction n with n . (x1 - x0) = gap(x1) - gap(x0): with it, the force -T n with the mean traction T
  /// of the gaps does the work that the interaction's energy loses. By default n is the mean normal on the straight
  /// path by 3 Gauss points. If the normals vary so much that this mean is not exact to rounding, n is corrected along
  /// the path.
  virtual MeanGap mean(const PackPoint& x0, const PackPoint& x1) const;

  /// Returns the least gap on the straight path from x0 to x1, or less. By default the gap falls and rises along the
  /// tangents at both ends and in the middle. That is a lower bound before convex obstacles, where the gap is a convex
  /// function on the path. Before other obstacles it is an estimate.
  virtual Pack least_gap(const PackPoint& x0, const PackPoint& x1) const;

  /// Returns the largest s <= 1 for which the gap along x + s d stays at least `least`, or less. The gap at x exceeds
  /// `least`. By default sphere tracing: each round advances by free_way(), the gap that exceeds `least`. It ends when
  /// a thousandth of that gap is left, or after 64 rounds: along a wall, a step ends after 64 times the gap that
  /// exceeds `least` at x.
  virtual Pack admissible_step(const PackPoint& x, const PackPoint& d, const Pack& least) const;

  /// Returns whether the obstacle is a body of revolution about the y axis, so that the plane z = 0 shows all of it.
  /// Only these act on axisymmetric meshes.
  virtual bool is_coaxial() const { return false; }
};

}  // namespace ixos
