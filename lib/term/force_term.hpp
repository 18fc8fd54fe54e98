/// The contract of a term whose force is evaluated by a rule on a segment.
#pragma once
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "rule/rule.hpp"
#include "term/border.hpp"
#include "term/term.hpp"

namespace ixos {

class CoarseSpace;

/// The part of a stage's rules that a term follows.
enum class Part { Elastic, Interaction };

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
  /// Takes the tangent that ForceTerm::add_tangent would add, plus the linear part, which interactions do not have.
  /// Accepts only rules for which the term is a gradient. An elastic action keeps single precision, see PointProduct.
  virtual void linearize(const Segment& segment, const Rule& rule, Tangent kind, const LinearPart& linear) = 0;
  /// Returns whether it applies a mass. If not, the linear part's `inertia` has to be 0.
  virtual bool applies_mass() const = 0;
  /// Adds K x to y.
  virtual void add_product(const double* x, double* y) const = 0;
  /// May do the same in single precision. Errors are then near 1e-7 of the forces that the differences of x in a cell
  /// exert.
  virtual void add_rough_product(const double* x, double* y) const { add_product(x, y); }
  /// Adds the diagonal of K to d, without that of a mass.
  virtual void add_diagonal(double* d) const = 0;
  /// Returns whether the action offers add_coarse(). Same on all ranks, whatever cells and sides they have.
  virtual bool has_coarse() const = 0;
  /// Adds P^T K P, that of a mass included, to matrix values of the coarse space's Pattern: the Galerkin product on the
  /// coarse cells. Throws std::logic_error unless has_coarse().
  virtual void add_coarse(const CoarseSpace& /*coarse*/, double* /*values*/) const {
    throw std::logic_error("a term has no Galerkin product on linear cells");
  }
};

/// The results of a force at quadrature points that a term keeps, so that the tangent at the same place need not
/// compute it again.
class KeptPoints {
 public:
  virtual ~KeptPoints() = default;
};

/// A term whose force follows from displacements: elasticity of a block, interaction of a surface. It evaluates a rule
/// on a segment, not a state. Forces are internal forces, dPi/du; all arrays are local; entries of ghost rows are
/// scratch. None of the functions communicates.
class ForceTerm : public Term {
 public:
  virtual Part part() const = 0;

  /// Returns whether the rule's force is a gradient in u_to, and hence its tangent symmetric.
  virtual bool is_gradient(const Rule& rule) const { return rule.is_gradient(); }

  /// Adds the rule's force to f (not its kept part, which is a force at u_from). Returns false if some time point is
  /// inadmissible (a gap <= 0, an inverted element): f is then unusable. Does not look for a NaN in u: it shows in f.
  virtual bool add_force(const Segment& segment, const Rule& rule, double* f) const = 0;

  /// Adds the rule's tangent, d(force)/du_to, to the matrix values laid out by the model's Pattern.
  virtual void add_tangent(const Segment& segment, const Rule& rule, Tangent kind, double* values) const = 0;

  /// Returns a place for what add_force_and_keep() keeps; null if the term keeps nothing.
  virtual std::unique_ptr<KeptPoints> create_kept() const { return nullptr; }
  /// Do the same as add_force() and as add_tangent() at the segment and rule of the last add_force_and_keep(), which
  /// must have found them admissible. `kept` is of create_kept().
  virtual bool add_force_and_keep(const Segment& segment, const Rule& rule, KeptPoints& kept, double* f) const;
  virtual void add_kept_tangent(const Segment& segment, const Rule& rule, Tangent kind, const KeptPoints& kept,
                                double* values) const;

  /// Adds the derivatives by, and of, what is no node's, at the segment and rule of the last add_tangent(),
  /// add_kept_tangent() or TangentAction::linearize(). By default the force knows nothing of globals.
  virtual void add_border(Border& /*border*/) const {}

  /// Returns the tangent as an operator; null if the term offers none.
  virtual std::unique_ptr<TangentAction> create_action() const { return nullptr; }

  /// Adds to a local array, for each degree of freedom, the sum of |k_rc| over its rows of the cells' tangents at
  /// segment.to: at least the row sum of the assembled one. Returns false if segment.to is inadmissible.
  virtual bool add_row_sums(const Segment& segment, double* sums) const = 0;

  /// Returns whether add_time_derivative() has the derivative of the rule's force. Equal on all ranks.
  virtual bool has_time_derivative(const Rule& rule) const = 0;
  /// Adds the derivative of add_force() by segment.start, all displacements kept: what a moved obstacle adds
  /// [E0 L0^(D-1)/T0]. By default the force depends on displacements alone.
  virtual void add_time_derivative(const Segment& /*segment*/, const Rule& /*rule*/, double* /*f*/) const {}
  /// Returns the names of the numbers by which add_parameter_derivative() differentiates the force. Equal on all ranks.
  virtual std::vector<std::string> parameters() const { return {}; }
  /// Adds the derivative of add_force() by a number, all displacements kept: `parameter` is its place in parameters().
  /// Returns false if some time point is inadmissible. Throws std::logic_error by default, for terms without such
  /// numbers.
  virtual bool add_parameter_derivative(std::size_t parameter, const Segment& segment, const Rule& rule,
                                        double* f) const;

  /// Returns this rank's share of the potential energy [E0 L0^D].
  virtual double energy(const Place& at) const = 0;
  /// Returns this rank's share of the energy whose gradient the force is over a segment with a length, in the stage
  /// that began last in the place's step [E0 L0^D]. It differs from the energy if the term relaxes meanwhile.
  virtual double potential(const Place& at) const { return energy(at); }

 protected:
  /// Adds the derivative by the only number of a term that is a factor of its whole force, 1 at first.
  bool add_factor_derivative(std::size_t parameter, const Segment& segment, const Rule& rule, double* f) const;
};

inline bool ForceTerm::add_parameter_derivative(std::size_t, const Segment&, const Rule&, double*) const {
  throw std::logic_error("a term has no derivative by such a parameter");
}
inline bool ForceTerm::add_factor_derivative(std::size_t parameter, const Segment& segment, const Rule& rule,
                                             double* f) const {
  if (parameter != 0) throw std::logic_error("a term has no such parameter");
  return add_force(segment, rule, f);
}
inline bool ForceTerm::add_force_and_keep(const Segment& segment, const Rule& rule, KeptPoints&, double* f) const {
  return add_force(segment, rule, f);
}
inline void ForceTerm::add_kept_tangent(const Segment& segment, const Rule& rule, Tangent kind, const KeptPoints&,
                                        double* values) const {
  add_tangent(segment, rule, kind, values);
}

}  // namespace ixos
