/// The contract of an interaction, beyond that of all terms.
#pragma once
#include <array>
#include <functional>
#include <limits>
#include <set>
#include <vector>

#include "term/force_term.hpp"

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

/// This rank's share of an interaction's report on a displacement. Sums over ranks give the whole; for `least_gap`, the
/// minimum.
struct InteractionReport {
  std::vector<double> force;  ///< on the bodies [E0 L0^(D-1)]
  double measure = 0;         ///< reference length or area closer than the gap of largest attraction [L0^(D-1)]
  double least_gap = std::numeric_limits<double>::infinity();  ///< [L0]
};

/// The point of a surface that is nearest to its obstacle.
struct LowestPoint {
  double gap = std::numeric_limits<double>::infinity();  ///< [L0]
  std::array<double, 3> place{};                         ///< deformed [L0]; the third is 0 in two dimensions
};

/// A number that friction keeps at each point: the length of the slip so far [L0], the work dissipated per reference
/// area [E0 L0] before the interaction's factor scales it, and whether it slid in the last step, 1 or 0.
enum class FrictionNumber { Slip, Dissipated, Sliding };

/// This rank's share of how surfaces slide along their obstacles. Sums over ranks give the whole. Friction acts where
/// the gap is below its g_cut and its threshold is greater than zero. Measures are reference lengths or areas
/// [L0^(D-1)].
struct FrictionReport {
  double acting = 0;    ///< measure on which friction acts
  double sliding = 0;   ///< measure that slid in the last step
  double sticking = 0;  ///< measure on which friction acts and that did not slide in the last step
  double slip = 0;      ///< integral of the slip so far over the measure on which friction acts [L0^D]
  double work = 0;      ///< integral of the last step's threshold times its slip [E0 L0^D]
  /// Integral of the change of that threshold over the step times the slip; 0 if it is that at the end [E0 L0^D].
  double lag = 0;

  /// Returns the mean of the slip over the measure on which friction acts [L0]; 0 if it acts nowhere.
  double mean_slip() const { return acting > 0 ? slip / acting : 0.0; }
};

/// Sides of cells: local block, cell and side.
using CountedSides = std::set<std::array<int, 3>>;

/// An interaction of a surface with its surroundings. The obstacle may move. Functions of a segment take its place at
/// the times of the segment, functions of a displacement alone its place at the time of set_time(), and gap_ratio() its
/// places at both ends of the step that began last.
class Interaction : public ForceTerm {
 public:
  Part part() const final { return Part::Interaction; }

  /// Returns the rule that the term follows in place of that one.
  virtual const Rule& followed(const Rule& rule) const { return rule; }

  /// Returns whether the term has forces for rules with that mean. Equal on all ranks.
  virtual bool follows(Mean) const { return true; }

  /// Returns whether a gap r <= 0 is inadmissible.
  virtual bool needs_positive_gaps() const = 0;

  /// Returns whether the nodes that the tangent couples change as bodies move. Equal on all ranks.
  virtual bool couples_anew() const { return false; }
  /// Finds the nodes that the tangent couples near the displacement u. Returns whether they have changed on this rank.
  virtual bool update_stencils(const double* /*u*/) { return false; }
  /// Returns the nodes that it found last: stencils as of Discretization::couple(). Entries of nodes that the pattern
  /// does not couple are left out of matrices.
  virtual std::vector<std::vector<int>> stencils() const { return {}; }

  /// Returns the largest step s <= 1 for which segment.to + s direction stays admissible with a margin.
  virtual double admissible_step(const Segment& segment, const Rule& rule, const double* direction) const = 0;

  /// Returns this rank's share of the potential whose derivative in u_to is the force of the exact rule. Called only if
  /// is_gradient() holds for that rule.
  virtual double mean_potential(const Segment& segment) const = 0;

  /// Returns the largest ratio of the gaps at a quadrature point in a step. Only points whose lesser gap is below ten
  /// times the equilibrium gap count. Returns 1 if the law is defined at every gap.
  virtual double gap_ratio(const double* from, const double* to) const = 0;

  /// Returns the sum of squares of the forces at quadrature points that cancel in add_force, and of the effect of
  /// rounding the gap, both over the machine's epsilon: near the equilibrium gap the force consists of nothing else.
  virtual double rounding(const double* u) const = 0;

  /// Adds the report on u.
  virtual void report(const double* u, InteractionReport& report) const = 0;

  /// Returns the lowest point of this rank's sides at displacement u. Quadrature points lie inside the sides, so this
  /// looks at the nodes, and between them at a grid twice as fine as the nodes of a side.
  virtual LowestPoint lowest_point(const double* u) const = 0;
  /// Returns whether it is known, without that search, that the lowest point's gap is greater than zero.
  virtual bool is_clear(const double* /*u*/) const { return false; }

  /// Returns the end of a point of this rank's sides that surely passes through the obstacle, or through another body,
  /// on its straight way in a step, with the least gap that was found on the way; if several do, that of the deepest.
  /// The law does not notice that: it acts at the ends, or at a few points in time. An infinite gap by default. A moved
  /// obstacle is at its places at both ends of the step that began last.
  virtual LowestPoint passage(const double* /*from*/, const double* /*to*/) const { return {}; }

  /// Adds, per local node, int w_a dA over those sides of the surface that are not counted yet, and counts them:
  /// several interactions may act on one side. The weight w_a is the shape function N_a [L0^(D-1)], but
  /// N_a/(2 pi R) at a node on the axis of an axisymmetric mesh where int N_a dA vanishes.
  virtual void add_nodal_measure(CountedSides& counted, double* measure) const = 0;

  /// Adds, per local node, int w_a T dA with the law's traction T, which is positive where the obstacle pushes the body
  /// away. The weights are those of add_nodal_measure().
  virtual void add_nodal_pressure(const double* u, double* force) const = 0;

  /// Returns whether the law has a damage. Equal on all ranks.
  virtual bool has_damage() const { return false; }
  /// Adds, per local node, int w_a d dA with the damage d in [0, 1] after the last step. The weights are those of
  /// add_nodal_measure().
  virtual void add_nodal_damage(double* /*sums*/) const {}

  /// Lowers the numbers by local node to the gaps of the surface's nodes [L0]; NaN stands for no gap yet. At derivative
  /// nodes it is the gap's derivative, if this gap is the least at their corner.
  virtual void lower_nodal_gap(const double* u, double* gap) const = 0;

  /// Sets the local array at the surface's nodes to the obstacle's unit normal, away from the obstacle, at its point
  /// nearest to the node. Leaves derivative nodes as they are.
  virtual void set_nodal_normal(const double* u, double* normal) const = 0;

  /// Returns whether the force is friction alone. Equal on all ranks.
  virtual bool has_friction() const { return false; }
  /// Adds, per local node, int w_a s dA with that number s, of the work times the interaction's factor. The weights are
  /// those of add_nodal_measure().
  virtual void add_nodal_friction(FrictionNumber, double* /*sums*/) const {}

  /// Returns whether the obstacle is moved. Equal on all ranks.
  virtual bool is_moved() const { return false; }
  /// Returns whether the obstacle's place and velocity are numbers at that time [T0]. Equal on all ranks.
  virtual bool is_finite(double /*time*/) const { return true; }
  /// Sets the time [T0] of the states on which functions of a displacement alone report.
  virtual void set_time(double /*time*/) const {}
  /// Returns this rank's share of the work of a moved obstacle on the way of the segment [E0 L0^D]. For a mean that is
  /// no sum of points it is the change of the interaction's energy less the force's work on the body. Otherwise it is
  /// the power of the forces at the rule's points, summed with the weights, times the length of the segment.
  virtual double obstacle_work(const Segment& /*segment*/, const Rule& /*rule*/) const { return 0; }

  /// Adds the report of friction on u, if the force is friction.
  virtual void report_friction(const double* /*u*/, FrictionReport& /*report*/) const {}
};

}  // namespace ixos
