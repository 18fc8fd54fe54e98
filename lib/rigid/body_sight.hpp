/// How forces at points that a rigid body sees act on it.
#pragma once
#include <array>
#include <cstddef>

#include "base/turn.hpp"

namespace ixos {

/// Forces f in space at the arms a from a body's centre act on w, the rotation since the start of the step, as
/// L sum a x f. At a pose, L = H^T R^T with H of cayley_spin(): the force is then the derivative of the work by w.
/// Between the poses at both ends of a step, a is the mean of both arms and L = M^T, M the mean of both rotations: then
/// the work in the step is exact, and the moment that acts on the body in space, M^-T L sum a x f, is the sum of a x f.
class BodySight {
 public:
  /// `turn`: R - I of the pose; `step`: its w; `to`: the derivative of that w by the unknown.
  static BodySight at(const Turn& turn, const std::array<double, 3>& step, double to);
  /// Between a start and the pose of the unknown.
  static BodySight between(const Turn& start, const Turn& end, const std::array<double, 3>& step);

  bool is_mean() const { return mean_; }
  /// Returns R - I of the pose, or M - I.
  const Turn& forces() const { return forces_; }
  const Turn& pose() const { return pose_; }
  double to() const { return to_; }
  /// Returns L x, and dL/dw_k x.
  std::array<double, 3> to_rotation(const std::array<double, 3>& x) const;
  std::array<double, 3> to_rotation_by(std::size_t k, const std::array<double, 3>& x) const;
  /// Returns the matrix L.
  Small<double, 3> matrix() const;
  /// Returns the rotation vector in space by which the pose turns with w_k.
  std::array<double, 3> turning(std::size_t k) const;

 private:
  Turn forces_{}, pose_{};
  std::array<double, 3> step_{};
  double to_ = 1;
  bool mean_ = false;
};

}  // namespace ixos
