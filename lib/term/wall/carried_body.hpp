/// The forces of a surface on the rigid body that carries its obstacle.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "rigid/body_sight.hpp"
#include "term/border.hpp"
#include "term/wall/moving_frame.hpp"

namespace ixos {

/// How the forces g of a point of a rule, or of a mean between two poses, in the frame, act on a body: in space they
/// are A g at nodes, A of BodySight::forces(), and
///   force on T: -sum A g,   force on w: -L sum a x A g.
struct SurfaceSight {
  BodySight body{};
  double share = 1;                           ///< of the unknown in the arms
  std::vector<std::array<double, 3>> arms{};  ///< by node of the frame
  std::vector<std::array<double, 3>> ends{};  ///< those at the pose, if others
};

/// Adds forces to the body's numbers, and the border of the tangent. Not collective: sums are shares of ranks.
class CarriedBody {
 public:
  /// The frame must outlive it, and be carried by a body.
  explicit CarriedBody(const MovingFrame& frame) : frame_(frame), body_(*frame.motion().body()) {}

  /// Return how forces act at a point of a rule, where `seen` is the displacement in the frame, or between two poses.
  SurfaceSight at(const RigidPose& pose, const RulePoint& point, const std::vector<double>& seen) const;
  SurfaceSight between(const RigidPose& start, const RigidPose& end, const std::vector<double>& from,
                       const std::vector<double>& to) const;

  /// Adds the forces on the body to a local array; g: a local array, forces on the nodes in the frame.
  void add_force(const SurfaceSight& sight, const std::vector<double>& g, double* f) const;
  /// Does the same at a point of a rule, with sums in the frame.
  void add_force(const RigidPose& pose, const std::vector<double>& seen, const std::vector<double>& g, double* f) const;
  /// Adds to `change` what the body's part of a direction changes in the frame, to first order, times `factor`.
  void see_change(const RigidPose& pose, double factor, const double* direction, const std::vector<double>& seen,
                  std::vector<double>& change) const;

  /// Begins a tangent without parts.
  void clear();
  /// Adds a part: g as above; `values`, in the layout of the pattern, are the derivative of forces by displacements,
  /// both in space.
  void add_border(const SurfaceSight& sight, const std::vector<double>& g, const std::vector<double>& values);
  /// Adds the parts.
  void add_to(Border& border) const;

 private:
  using Triple = std::array<double, 3>;
  static constexpr std::size_t freedoms = 6;  ///< T, then w
  /// Subtracts a force on T and one on w.
  void subtract(const Triple& force, const Triple& turning, double* f) const;

  const MovingFrame& frame_;
  const RigidBody& body_;
  std::vector<std::array<Triple, freedoms>> columns_, rows_;  ///< by node of the frame, and by T and w
  Small<double, freedoms> block_{};
  /// How a node moves with the body's freedoms in one part, how forces on it act on them, and its column.
  struct Part {
    std::array<Triple, freedoms> motions, moments, columns;
  };
  std::vector<Part> parts_;  ///< scratch
};

}  // namespace ixos
