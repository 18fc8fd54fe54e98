#include "term/wall/frame_motion.hpp"

#include <algorithm>
#include <array>

#include "rigid/body_sight.hpp"

namespace ixos {

RigidPose FrameMotion::pose(const Segment& segment, const RulePoint& point) const {
  if (body() == nullptr) return motion_->pose(segment.time(point));
  std::array<double, RigidBody::numbers> at{};
  for (const auto& [factor, array] : {std::pair{point.to, segment.to}, std::pair{point.from, segment.from},
                                      std::pair{point.velocity, segment.velocity}})
    if (factor != 0)
      for (std::size_t i = 0; i < RigidBody::attitude; ++i) at[i] += factor * array[first() + i];
  // All ends of the segment are of one step.
  std::copy_n(segment.to + first() + RigidBody::attitude, RigidBody::numbers - RigidBody::attitude,
              at.begin() + RigidBody::attitude);
  return pose_of(at.data());
}

RigidPose FrameMotion::pose(const double* u, double time) const {
  return body() == nullptr ? motion_->pose(time) : pose_of(u + first());
}

RigidPose FrameMotion::pose_of(const double* numbers) const {
  RigidPose pose;
  pose.point = body()->centre();
  pose.translation = RigidBody::triple(numbers);
  pose.turn = body()->turn(numbers);
  pose.step = body()->rotation(numbers);
  return pose;
}

Turn FrameMotion::mean_turn(const RigidPose& start, const RigidPose& end) const {
  if (body() == nullptr) return turn_about(end.axis, (start.angle + end.angle) / 2);
  return BodySight::between(start.turn, end.turn, end.step).forces();
}

}  // namespace ixos
