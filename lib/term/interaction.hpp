/// The contract of an interaction, beyond that of all terms.
#pragma once
#include <array>
#include <functional>
#include <vector>

#include "term/admissibility.hpp"
#include "term/coupling.hpp"
#include "term/force_term.hpp"
#include "term/surface_report.hpp"

namespace ixos {

/// A number that varies over a surface, by the place of the undeformed body [L0]; the third coordinate is 0 in two
/// dimensions.
using PlaceFactor = std::function<double(const std::array<double, 3>&)>;

/// A factor over a surface: the product of a function of the place and of numbers at the mesh's nodes.
struct SurfaceFactor {
  PlaceFactor of_place{};  ///< null: 1
  /// By local node, interpolated linearly, in 3D bilinearly, between the corners of each side; empty: 1.
  std::vector<double> of_node{};
};

/// The motion of an interaction's obstacle.
class ObstacleMotion {
 public:
  virtual ~ObstacleMotion() = default;
  /// Returns whether the obstacle's place and velocity are numbers at that time [T0]. Equal on all ranks.
  virtual bool is_finite(double time) const = 0;
  /// Returns this rank's share of the obstacle's work on the way of the segment [E0 L0^D]. For a mean that is no sum of
  /// points it is the change of the interaction's energy less the force's work on the body. Otherwise it is the power
  /// of the forces at the rule's points, summed with the weights, times the length of the segment.
  virtual double work(const Segment& segment, const Rule& rule) const = 0;
};

/// The forces of a surface's interaction with its surroundings. Small contracts have the rest: gaps, couplings,
/// reports, the motion of an obstacle.
class Interaction : public ForceTerm {
 public:
  Part part() const final { return Part::Interaction; }
  /// No interaction relaxes within a stage.
  double potential(const Place& at) const final { return energy(at); }

  /// Returns the rule that the term follows in place of that one.
  virtual const Rule& followed(const Rule& rule) const = 0;
  /// Returns whether the term has forces for rules with that mean. Equal on all ranks.
  virtual bool follows(Mean mean) const = 0;
  /// Returns whether the force is friction alone. Equal on all ranks.
  virtual bool has_friction() const = 0;

  /// Returns this rank's share of the potential whose derivative in u_to is the force of the exact rule. Called only if
  /// is_gradient() holds for that rule.
  virtual double mean_potential(const Segment& segment) const = 0;
  /// Returns the sum of squares of the forces at quadrature points that cancel in add_force, and of the effect of
  /// rounding the gap, both over the machine's epsilon: near the equilibrium gap the force consists of nothing else.
  virtual double rounding(const Place& at) const = 0;

  virtual const Admissibility& admissibility() const = 0;
  virtual const SurfaceReport& reports() const = 0;
  /// Returns null if the tangent couples the nodes of single sides only. Equal on all ranks.
  virtual Coupling* coupling() = 0;
  /// Returns null if the obstacle rests. Equal on all ranks.
  virtual const ObstacleMotion* motion() const = 0;
};

}  // namespace ixos
