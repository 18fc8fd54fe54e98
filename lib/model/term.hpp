/// The contract of a physics term.
#pragma once
#include <limits>
#include <memory>
#include <vector>

#include "fem/rule.hpp"

namespace ixos {

/// Local arrays (owned nodes, then ghosts) at the ends of a stage's segment. `from` and `velocity` (h v_from, a length)
/// may be null where the rule does not use them.
struct Segment {
  const double* from = nullptr;
  const double* velocity = nullptr;
  const double* to = nullptr;
};

/// What a term says of a displacement, this rank's share. Sums over ranks give the whole; `least_gap` its minimum.
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

/// Which derivative of the force: the exact one, or the one without the interactions' negative stiffness, which makes a
/// descent direction where the exact tangent is not positive definite.
enum class Tangent { Exact, Convex };

/// What an elastic action applies beside the tangent.
struct LinearPart {
  double rest = 0;     ///< factor of the undeformed body's tangent: stiffness damping
  double inertia = 0;  ///< factor times density of the mass: inertia and mass damping
};

/// A term's tangent applied without a matrix, from what linearize() keeps at the quadrature points. Arrays are local;
/// entries of ghost rows are scratch. The term must outlive it. None of the functions communicates.
class TangentAction {
 public:
  virtual ~TangentAction() = default;
  /// Takes the tangent that Term::add_tangent would add, plus the linear part, which interactions do not have. Only
  /// rules with is_gradient(). An elastic action keeps single precision, see ElasticAction.
  virtual void linearize(const Segment& segment, const Rule& rule, Tangent kind, const LinearPart& linear) = 0;
  /// Whether it applies a mass: else the linear part's `inertia` has to be 0.
  virtual bool applies_mass() const { return false; }
  /// y += K x.
  virtual void add_product(const double* x, double* y) const = 0;
  /// d += the diagonal of K; a mass's is not added.
  virtual void add_diagonal(double* d) const = 0;
};

/// One conservative contribution to the model: elasticity of a block, interaction of a surface. A term evaluates a rule
/// on a segment, not a state. Forces are internal forces, dPi/du; all arrays are local; entries of ghost rows are
/// scratch. None of the functions communicates.
class Term {
 public:
  virtual ~Term() = default;

  /// Adds the rule's force to f (not its kept part, which is a force at u_from). False where some time point is
  /// inadmissible (a gap <= 0, an inverted element): f is then unusable. A NaN in u is not looked for: it shows in f.
  virtual bool add_force(const Segment& segment, const Rule& rule, double* f) const = 0;

  /// Adds the rule's tangent, d(force)/du_to, to the matrix values laid out by the model's Pattern.
  virtual void add_tangent(const Segment& segment, const Rule& rule, Tangent kind, double* values) const = 0;

  /// The tangent as an operator; null where the term offers none.
  virtual std::unique_ptr<TangentAction> create_action() const { return nullptr; }

  /// Adds to a local array, for each degree of freedom, the sum of |k_rc| over its rows of the cells' tangents at
  /// segment.to: at least the row sum of the assembled one. False where segment.to is inadmissible.
  virtual bool add_row_sums(const Segment& segment, double* sums) const = 0;

  /// An elastic term adds the diagonal of its tangent at segment.to to a local array; other terms add nothing.
  virtual void add_diagonal(const Segment& /*segment*/, double* /*diagonal*/) const {}

  /// This rank's share of the potential energy [E0 L0^D].
  virtual double energy(const double* u) const = 0;

  /// The largest step s <= 1 for which segment.to + s direction stays admissible with a margin.
  virtual double admissible_step(const Segment&, const Rule&, const double* /*direction*/) const { return 1.0; }

  /// This rank's share of the potential whose derivative in u_to is the force of the exact rule; interactions only.
  virtual double mean_potential(const Segment& /*segment*/) const { return 0; }

  /// An interaction: the largest ratio that the gap at a quadrature point has in a step, where the lesser gap is below
  /// ten times that of equilibrium. 1 of other terms.
  virtual double gap_ratio(const double* /*from*/, const double* /*to*/) const { return 1; }

  /// Sum of squares of the forces at quadrature points that cancel in add_force, and of what rounding the gap costs,
  /// both over the machine's epsilon: near the equilibrium gap they are all that is left of the force. 0 of other
  /// terms.
  virtual double rounding(const double* /*u*/) const { return 0; }

  /// Adds what an interaction reports of u; other terms add nothing.
  virtual void report(const double* /*u*/, InteractionReport&) const {}

  /// An elastic term fills in the fields of its block; other terms do nothing.
  virtual void cell_fields(const double* /*u*/, CellFields&) const {}

  /// An interaction adds, per local node, int N_a dA over its surface [L0^(D-1)]; other terms add nothing.
  virtual void add_nodal_measure(double* /*measure*/) const {}
};

}  // namespace ixos
