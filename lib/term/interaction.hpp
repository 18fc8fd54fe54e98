/// The contract of an interaction, beyond that of all terms.
#pragma once
#include <array>
#include <limits>
#include <set>
#include <vector>

#include "term/force_term.hpp"

namespace ixos {

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

/// Sides of cells: local block, cell and side.
using CountedSides = std::set<std::array<int, 3>>;

/// An interaction of a surface with its surroundings.
class Interaction : public ForceTerm {
 public:
  Part part() const final { return Part::Interaction; }

  /// Returns whether a gap r <= 0 is inadmissible.
  virtual bool needs_positive_gaps() const = 0;

  /// Returns the largest step s <= 1 for which segment.to + s direction stays admissible with a margin.
  virtual double admissible_step(const Segment& segment, const Rule& rule, const double* direction) const = 0;

  /// Returns this rank's share of the potential whose derivative in u_to is the force of the exact rule. Called only if
  /// is_gradient() holds for that rule, and has_mean_potential().
  virtual double mean_potential(const Segment& segment) const = 0;

  /// Returns whether the law has that potential. Equal on all ranks.
  virtual bool has_mean_potential() const = 0;

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

  /// Adds, per local node, int N_a dA over those sides of the surface that are not counted yet, and counts them:
  /// several interactions may act on one side [L0^(D-1)].
  virtual void add_nodal_measure(CountedSides& counted, double* measure) const = 0;

  /// Adds, per local node, int N_a T dA with the law's traction T, which is positive where the obstacle pushes the body
  /// away [E0 L0^(D-1)].
  virtual void add_nodal_pressure(const double* u, double* force) const = 0;

  /// Lowers the numbers by local node to the gaps of the surface's nodes [L0]; NaN stands for no gap yet. At derivative
  /// nodes it is the gap's derivative, if this gap is the least at their corner.
  virtual void lower_nodal_gap(const double* u, double* gap) const = 0;
};

}  // namespace ixos
