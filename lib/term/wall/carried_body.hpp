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

/// Forces by node of the frame, and in its axes.
using CarriedForces = std::vector<std::array<double, 3>>;

/// Adds forces to the body's numbers, and the border of the tangent. Not collective: sums are shares of ranks.
class CarriedBody {
 public:
  using Triple = std::array<double, 3>;

  /// The frame must outlive it, and be carried by a body.
  explicit CarriedBody(const MovingFrame& frame);

  /// Return how forces act at a point of a rule, where `seen` is the displacement in the frame, or between two poses:
  /// valid until the next call.
  const SurfaceSight& at(const RigidPose& pose, const RulePoint& point, const std::vector<double>& seen);
  const SurfaceSight& between(const RigidPose& start, const RigidPose& end, const std::vector<double>& from,
                              const std::vector<double>& to);

  /// Adds the forces on the body to a local array; g: a local array, forces on the nodes in the frame.
  void add_force(const SurfaceSight& sight, const std::vector<double>& g, double* f) const;
  /// Does the same at a point of a rule, with sums in the frame.
  void add_force(const RigidPose& pose, const std::vector<double>& seen, const std::vector<double>& g, double* f) const;
  /// Adds to `change` what the body's part of a direction changes in the frame, to first order, times `factor`.
  void see_change(const RigidPose& pose, double factor, const double* direction, const std::vector<double>& seen,
                  std::vector<double>& change) const;

  /// Takes forces from a local array, to be kept.
  void gather(const std::vector<double>& g, CarriedForces& forces) const;
  /// Begins a tangent without parts.
  void clear();
  /// Adds a part: `own`, in the layout of the pattern, is the derivative of forces by displacements, both in the frame.
  /// Adds it, in space, to `values`, null for none, and sets it to 0.
  void add_border(const SurfaceSight& sight, const CarriedForces& g, std::vector<double>& own, double* values);
  /// Adds the parts.
  void add_to(Border& border) const;

 private:
  /// Subtracts a force on T and one on w.
  void subtract(const Triple& force, const Triple& turning, double* f) const;
  template <std::size_t D>
  void add_border_of(const SurfaceSight& sight, const CarriedForces& g, std::vector<double>& own, double* values);

  const MovingFrame& frame_;
  const RigidBody& body_;
  std::size_t lanes_;                   ///< numbers for the freedoms of a body, see Freedoms in the source
  std::vector<double> columns_, rows_;  ///< by node of the frame, direction, and freedom
  std::vector<double> block_;           ///< by freedom and freedom
  std::vector<double> parts_;           ///< scratch, see add_border_of()
  SurfaceSight sight_;                  ///< scratch
};

}  // namespace ixos
