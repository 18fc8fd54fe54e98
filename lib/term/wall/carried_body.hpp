/// The forces of a surface on the rigid body that carries its obstacle.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "term/border.hpp"
#include "term/wall/moving_frame.hpp"

namespace ixos {

/// How the forces of a point of a rule, or of a mean between two poses, act on a body. With forces g in the frame, f =
/// A g in space at nodes with the arms a from the body's point:
///   force on T: -sum f,   force on w: -L sum a x f.
/// At a point A = R, and both are derivatives of the energy there: L = H^T R^T, H of cayley_spin(). Between two poses A
/// is the mean of both rotations, L = A^T, and arms are means: then the forces' work in the step is the change of
/// energy, and the moment that acts on the body, A^-T L a x f, is that of the forces on the nodes (Betsch and
/// Steinmann 2001 join rigid bodies by directors likewise).
struct BodySight {
  Turn forces{};     ///< A - I
  RigidPose pose{};  ///< of the point, or of the end
  bool mean = false;
  double share = 1;                           ///< of the unknown in the arms
  double to = 1;                              ///< of the unknown in the pose
  std::vector<std::array<double, 3>> arms{};  ///< by node of the frame
  std::vector<std::array<double, 3>> ends{};  ///< those at the pose, if others
};

/// Adds forces to the body's numbers, and the border of the tangent. Not collective: sums are shares of ranks.
class CarriedBody {
 public:
  /// The frame must outlive it, and be carried by a body.
  explicit CarriedBody(const MovingFrame& frame) : frame_(frame), body_(*frame.motion().body()) {}

  /// Return how forces act at a point of a rule, where `seen` is the displacement in the frame, or between two poses.
  BodySight at(const RigidPose& pose, const RulePoint& point, const std::vector<double>& seen) const;
  BodySight between(const RigidPose& start, const RigidPose& end, const std::vector<double>& from,
                    const std::vector<double>& to) const;

  /// Adds the forces on the body to a local array; g: a local array, forces on the nodes in the frame.
  void add_force(const BodySight& sight, const std::vector<double>& g, double* f) const;
  /// Adds to `change` what the body's part of a direction changes in the frame, to first order, times `factor`.
  void see_change(const RigidPose& pose, double factor, const double* direction, const std::vector<double>& seen,
                  std::vector<double>& change) const;

  /// Begins a tangent without parts.
  void clear();
  /// Adds a part: g as above; `values`, in the layout of the pattern, are the derivative of forces by displacements,
  /// both in space.
  void add_border(const BodySight& sight, const std::vector<double>& g, const std::vector<double>& values);
  /// Adds the parts.
  void add_to(Border& border) const;

 private:
  using Triple = std::array<double, 3>;
  static constexpr std::size_t freedoms = 6;  ///< T, then w
  /// Returns L x.
  Triple to_rotation(const BodySight& sight, const Triple& x) const;
  /// Returns dL/dw_k x.
  Triple to_rotation_by(const BodySight& sight, std::size_t k, const Triple& x) const;
  /// Returns the rotation vector in space by which the pose turns with w_k.
  Triple turning(const BodySight& sight, std::size_t k) const;

  const MovingFrame& frame_;
  const RigidBody& body_;
  std::vector<std::array<Triple, freedoms>> columns_, rows_;  ///< by node of the frame, and by T and w
  Small<double, freedoms> block_{};
};

}  // namespace ixos
