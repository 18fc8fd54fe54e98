/// The contract of a term whose force depends on rates.
#pragma once
#include <stdexcept>

#include "term/border.hpp"
#include "term/term.hpp"

namespace ixos {

/// A term whose force f(u, v) depends on the velocity v: damping, viscosity. begin_stage() freezes all but the stage's
/// unknown displacement; functions of a place are those of the stage that began last in its step. Arrays are local;
/// rows of ghosts are scratch. None of the functions communicates.
class RateTerm : public Term {
 public:
  bool dissipates() const final { return true; }
  /// Returns whether the stage's force is a gradient in u for that form.
  virtual bool is_gradient(RateForm form) const = 0;
  /// Adds the stage's force to f.
  virtual void add_force(const Place& at, double* f) const = 0;
  /// Adds the symmetric part of its derivative, the whole one if it is a gradient, to the matrix values laid out by the
  /// model's Pattern. The rest must be small, so that Newton's method converges without it.
  virtual void add_tangent(const Place& at, double* values) const = 0;
  /// As ForceTerm::add_border(), for the last tangent.
  virtual void add_border(Border& /*border*/) const {}
  /// Returns this rank's share of the energy whose gradient the stage's force is [E0 L0^D]. Called only if it is one.
  virtual double potential(const Place& at) const = 0;

  /// Adds factor f(u, v) to f.
  virtual void add_force_at(double factor, const double* u, const double* v, double* f) const = 0;
  /// Adds by_velocity df/dv + by_displacement df/du to the matrix values.
  virtual void add_tangent_at(double by_velocity, double by_displacement, const double* u, const double* v,
                              double* values) const = 0;
  /// Adds to sums_r the sum over columns of |df_r/dv_c|, or a bound of it.
  virtual void add_row_sums(const double* u, double* sums) const = 0;

  /// Returns whether df/dv is a constant diagonal matrix and df/du zero. A tangent without a matrix takes only such
  /// terms, and the model's damping, which its actions apply.
  virtual bool is_diagonal() const = 0;
  /// Adds factor df/dv to the diagonal d, a local array. Throws std::logic_error unless is_diagonal().
  virtual void add_diagonal(double /*factor*/, double* /*d*/) const {
    throw std::logic_error("the tangent of a term of rates is not diagonal");
  }
};

}  // namespace ixos
