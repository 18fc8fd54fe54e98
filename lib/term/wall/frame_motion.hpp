/// Where an obstacle is: by a prescribed motion, or as part of a rigid body.
#pragma once
#include <cstddef>
#include <optional>
#include <utility>

#include "histories/rigid_motion.hpp"
#include "rigid/rigid_body.hpp"
#include "state/place.hpp"

namespace ixos {

/// A rigid body's numbers are in displacements, from `first` on; the body must outlive this.
struct CarryingBody {
  const RigidBody* body = nullptr;
  std::size_t first = 0;
};

/// The poses of a frame that an obstacle carries.
class FrameMotion {
 public:
  FrameMotion(RigidMotion motion) : motion_(std::move(motion)) {}  // NOLINT(google-explicit-constructor)
  FrameMotion(const CarryingBody& carrier) : carrier_(carrier) {}  // NOLINT(google-explicit-constructor)

  /// Returns the body; null if the motion is prescribed.
  const RigidBody* body() const { return carrier_.body; }
  std::size_t first() const { return carrier_.first; }
  bool turns() const { return body() != nullptr ? body()->turns() : motion_->turns(); }

  /// Return the pose at a rule's point of a segment, and in a displacement. A body's pose has no rates: it follows from
  /// unknowns, not from time.
  RigidPose pose(const Segment& segment, const RulePoint& point) const;
  RigidPose pose(const double* u, double time) const;
  /// Returns the matrix A, less I, that turns the force of a mean between two poses, A g with the mean's force g in the
  /// frame. Prescribed: the rotation by the mean of both angles. A body: the mean of both rotations. With y = R^T x
  /// that is what makes A g . (x1 - x0) + ... = g . (y1 - y0) exact, and the moment of A g that of the body's.
  Turn mean_turn(const RigidPose& start, const RigidPose& end) const;

 private:
  /// Returns the pose of the body with these numbers.
  RigidPose pose_of(const double* numbers) const;

  std::optional<RigidMotion> motion_;
  CarryingBody carrier_;
};

}  // namespace ixos
