/// The contract of a physics term.
#pragma once
#include <limits>
#include <memory>
#include <vector>

#include "fem/rule.hpp"

namespace ixos {

/// Local arrays (owned nodes, then ghosts) at the ends of a stage's segment. `from` and `velocity` (h v_from, a length)
/// may be null if the rule does not use them.
struct Segment {
  const double* from = nullptr;
  const double* velocity = nullptr;
  const double* to = nullptr;
};

/// This rank's share of an interaction's report on a displacement. Sums over ranks give the whole; for `least_gap`, the
/// minimum.
struct InteractionReport {
  std::vector<double> force;  ///< on the bodies [E0 L0^(D-1)]
  double measure = 0;         ///< reference length or area closer than the gap of largest attraction [L0^(D-1)]
  double least_gap = std::numeric_limits<double>::infinity();  ///< [L0]
};

/// Means over the reference volume of each cell of one block, for output.
struct CellFields {
  std::vector<double> stress_invariant;  ///< tr(sigma)/E [-], E Young's modulus
  std::vector<double> jacobian;          ///< J [-]
  std::vector<double> energy_density;    ///< W per reference volume [E0]
};

/// The kind of tangent: the exact derivative of the force, or the one without the interactions' negative stiffness,
/// which gives a descent direction when the exact tangent is not positive definite.
enum class Tangent { Exact, Convex };

/// The parts that an elastic action applies beside the tangent.
struct LinearPart {
  double rest = 0;     ///< factor of the undeformed body's tangent: stiffness damping
  double inertia = 0;  ///< factor times density of the mass: inertia and mass damping
};

/// A term's tangent applied without a matrix, from what linearize() keeps at the quadrature points. Arrays are local;
/// entries of ghost rows are scratch. The term must outlive it. None of the functions communicates.
class TangentAction {
 public:
  virtual ~TangentAction() = default;
  /// Takes the tangent that Term::add_tangent would add, plus the linear part, which interactions do not have. Accepts
  /// only rules with is_gradient(). An elastic action keeps single precision, see ElasticAction.
  virtual void linearize(const Segment& segment, const Rule& rule, Tangent kind, const LinearPart& linear) = 0;
  /// Returns whether it applies a mass. If not, the linear part's `inertia` has to be 0.
  virtual bool applies_mass() const { return false; }
  /// Adds K x to y.
  virtual void add_product(const double* x, double* y) const = 0;
  /// Adds the diagonal of K to d, without that of a mass.
  virtual void add_diagonal(double* d) const = 0;
};

/// One conservative contribution to the model: elasticity of a block, interaction of a surface. A term evaluates a rule
/// on a segment, not a state. Forces are internal forces, dPi/du; all arrays are local; entries of ghost rows are
/// scratch. None of the functions communicates.
class Term {
 public:
  virtual ~Term() = default;

  /// Adds the rule's force to f (not its kept part, which is a force at u_from). Returns false if some time point is
  /// inadmissible (a gap <= 0, an inverted element): f is then unusable. Does not look for a NaN in u: it shows in f.
  virtual bool add_force(const Segment& segment, const Rule& rule, double* f) const = 0;

  /// Adds the rule's tangent, d(force)/du_to, to the matrix values laid out by the model's Pattern.
  virtual void add_tangent(const Segment& segment, const Rule& rule, Tangent kind, double* values) const = 0;

  /// Returns the tangent as an operator; null if the term offers none.
  virtual std::unique_ptr<TangentAction> create_action() const { return nullptr; }

  /// Adds to a local array, for each degree of freedom, the sum of |k_rc| over its rows of the cells' tangents at
  /// segment.to: at least the row sum of the assembled one. Returns false if segment.to is inadmissible.
  virtual bool add_row_sums(const Segment& segment, double* sums) const = 0;

  /// Adds the diagonal of an elastic term's tangent at segment.to to a local array; other terms add nothing.
  virtual void add_diagonal(const Segment& /*segment*/, double* /*diagonal*/) const {}

  /// Returns this rank's share of the potential energy [E0 L0^D].
  virtual double energy(const double* u) const = 0;

  /// Returns the largest step s <= 1 for which segment.to + s direction stays admissible with a margin.
  virtual double admissible_step(const Segment&, const Rule&, const double* /*direction*/) const { return 1.0; }

  /// Returns this rank's share of the potential whose derivative in u_to is the force of the exact rule; interactions
  /// only.
  virtual double mean_potential(const Segment& /*segment*/) const { return 0; }

  /// Returns the largest ratio of the gaps at a quadrature point of an interaction in a step. Only points whose lesser
  /// gap is below ten times the equilibrium gap count. Other terms return 1.
  virtual double gap_ratio(const double* /*from*/, const double* /*to*/) const { return 1; }

  /// Returns the sum of squares of the forces at quadrature points that cancel in add_force, and of the effect of
  /// rounding the gap, both over the machine's epsilon: near the equilibrium gap the force consists of nothing else.
  /// Other terms return 0.
  virtual double rounding(const double* /*u*/) const { return 0; }

  /// Adds an interaction's report on u; other terms add nothing.
  virtual void report(const double* /*u*/, InteractionReport&) const {}

  /// Fills in the fields of an elastic term's block; other terms do nothing.
  virtual void cell_fields(const double* /*u*/, CellFields&) const {}

  /// Adds, per local node, int N_a dA over an interaction's surface [L0^(D-1)]; other terms add nothing.
  virtual void add_nodal_measure(double* /*measure*/) const {}
};

}  // namespace ixos
