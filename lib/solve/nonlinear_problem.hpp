/// What a nonlinear solver needs to know of a problem f(x) = 0.
#pragma once
#include "base/tpetra.hpp"

namespace ixos {

/// A potential's value, and the sum of its parts' magnitudes, by which its rounding errors are measured.
struct Potential {
  double value = 0;
  double magnitude = 0;
};

/// All functions are collective; vectors live on map(). Between two solves the problem may change, during one it may
/// not, except for relax_tangent().
class NonlinearProblem {
 public:
  virtual ~NonlinearProblem() = default;

  virtual Teuchos::RCP<const Map> map() const = 0;
  /// The tangent's operator: a fill-complete matrix of its sparsity, or an AssemblableOperator.
  virtual Teuchos::RCP<Operator> create_operator() = 0;

  /// f(x). False, on all ranks alike, where x is inadmissible: f is then unusable.
  virtual bool residual(const Vector& x, Vector& f) = 0;
  /// W = df/dx at x, or what relax_tangent() has set; W of create_operator().
  virtual void tangent(const Vector& x, Operator& w) = 0;
  /// The largest step s <= 1 for which x + s direction is admissible with a margin.
  virtual double admissible_step(const Vector& x, const Vector& direction) = 0;
  /// The norm |f| must come below at the last x that residual() saw, given the relative tolerance.
  virtual double convergence_bound(double relative_tolerance) const = 0;

  /// Is f, at the last x that residual() saw, the gradient of potential()? Not while prescribed values are still on
  /// their way.
  virtual bool is_gradient() const { return false; }
  /// Squared distance of prescribed values from where they are to be; 0 where f is a gradient.
  virtual double way_left(const Vector& /*x*/) { return 0; }
  /// Sets a direction's part for prescribed values to the whole way left, exactly.
  virtual void complete_direction(const Vector& /*x*/, Vector& /*direction*/) {}
  /// Only where is_gradient() and x is admissible.
  virtual Potential potential(const Vector& /*x*/) { return {}; }

  /// 0: the exact tangent; 1: without negative interaction stiffness; more: with a growing multiple of the identity
  /// besides. For directions of descent where the exact tangent gives none.
  virtual void relax_tangent(int /*level*/) {}

  /// Which of several problems that take turns this is, counted from 0: iterations with a preconditioner that they
  /// share compare within a family.
  virtual int family() const { return 0; }
};

}  // namespace ixos
