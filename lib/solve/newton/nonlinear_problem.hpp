/// The interface of a problem f(x) = 0 to a nonlinear solver.
#pragma once
#include "base/tpetra.hpp"

namespace ixos {

/// A potential's value, and the sum of its parts' magnitudes, the scale of its rounding errors.
struct Potential {
  double value = 0;
  double magnitude = 0;
};

/// A problem f(x) = 0. All functions are collective; vectors live on map(). The problem may change between two solves.
/// During a solve only relax_tangent() may change it.
class NonlinearProblem {
 public:
  virtual ~NonlinearProblem() = default;

  virtual Teuchos::RCP<const Map> map() const = 0;
  /// Returns whether the tangent's operator is a BorderedOperator. Equal on all ranks.
  virtual bool is_bordered() const { return false; }
  /// Creates the tangent's operator: a fill-complete matrix of its sparsity, an AssemblableOperator, or one of these
  /// with a border.
  virtual Teuchos::RCP<Operator> create_operator() = 0;

  /// Computes f(x). Returns false, on all ranks alike, if x is inadmissible: f is then unusable.
  virtual bool residual(const Vector& x, Vector& f) = 0;
  /// Sets W, made by create_operator(), to df/dx at x, or to the tangent that relax_tangent() has selected.
  virtual void tangent(const Vector& x, Operator& w) = 0;
  /// Returns the largest step s <= 1 for which x + s direction is admissible with a margin.
  virtual double admissible_step(const Vector& x, const Vector& direction) = 0;
  /// Returns the bound of the norm |f| for convergence at the last x that residual() saw, given the relative tolerance.
  virtual double convergence_bound(double relative_tolerance) const = 0;

  /// Returns whether the last x that residual() saw is farther than any solution can be.
  virtual bool is_lost() const { return false; }
  /// Returns whether f, at the last x that residual() saw, is the gradient of potential(). It is not until the
  /// prescribed values are reached.
  virtual bool is_gradient() const { return false; }
  /// Returns whether f has kinks, without being a gradient, so that full steps of Newton's method may cycle.
  virtual bool has_kinks() const { return false; }
  /// Returns the squared distance of prescribed values from their targets; 0 if f is a gradient.
  virtual double way_left(const Vector& /*x*/) { return 0; }
  /// Sets a direction's part for prescribed values to the whole way left, exactly.
  virtual void complete_direction(const Vector& /*x*/, Vector& /*direction*/) {}
  /// Returns the potential. Valid only if is_gradient() and x is admissible.
  virtual Potential potential(const Vector& /*x*/) { return {}; }

  /// Selects the tangent. 0: the exact one; 1: without negative interaction stiffness; more: with a growing multiple of
  /// the identity besides. For directions of descent when the exact tangent gives none.
  virtual void relax_tangent(int /*level*/) {}

  /// Tells that a solve begins: what it keeps from iterate to iterate is of no use for it.
  virtual void begin_solve() {}
  /// Returns whether the last tangent depends on the iterate before, too, such that full steps are good although the
  /// potential rises in some of them.
  virtual bool has_mixed_steps() const { return false; }
  /// Takes the next tangent without an iterate before; if not `again`, all that follow in this solve.
  virtual void leave_mixed_steps(bool /*again*/) {}

  /// Returns the number, from 0, of this problem among several that take turns: iteration counts with a shared
  /// preconditioner are compared within a family.
  virtual int family() const { return 0; }
};

}  // namespace ixos
