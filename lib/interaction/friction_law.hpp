/// The threshold of friction with adhesion.
#pragma once
#include <memory>

#include "base/pack.hpp"
#include "interaction/friction.hpp"
#include "interaction/gap_law.hpp"

namespace ixos {

/// The traction T_s beyond which a surface slides (Mergel, Sahli, Scheibert and Sauer 2019, before a rigid obstacle).
/// It acts at gaps below g_cut = c g_max + (1 - c) r_eq, between the gaps of equilibrium and of largest attraction:
/// - Constant Stress: tau below, 0 beyond; with a sharpness k everywhere tau/(1 + exp(k (g - g_cut)));
/// - the others: mu (T(g) - T(g_cut)), at least 0, 0 beyond. With c = 0 this is Amontons' law. With c = 1 a contact
///   without load slides at mu times the largest attraction.
/// A law that only attracts, and one with a history, have no r_eq: their equilibrium_gap() is another scale. They need
/// c = 1 and Constant Stress.
class FrictionLaw {
 public:
  /// Throws InputError if a number is out of range, the type is None, or the law does not fit: the threshold needs a
  /// traction or an r_eq that the law has not, or no surface reaches g_cut.
  FrictionLaw(const Friction& friction, std::shared_ptr<const GapLaw> law);

  /// Returns the friction with the stiffness that acts. A stiffness of 0 becomes the threshold's scale, tau or mu times
  /// the largest attraction s0, over 0.003 r_eq, at most 100 s0/r_eq; 50 E0/L0 if the law does not attract. Newton's
  /// method fails if the elastic slip is much shorter, and if the spring is much stiffer than the law.
  const Friction& friction() const { return friction_; }
  double cutoff() const { return cutoff_; }  ///< g_cut [L0]
  bool needs_positive_gaps() const { return law_->domain() == GapDomain::Positive; }

  /// Returns T_s at a gap [E0], and its derivative [E0/L0]. 0 where the gap is no number or infinite.
  Pack threshold(const Pack& gap) const;
  Pack slope(const Pack& gap) const;
  /// Returns the threshold at one gap [E0]. Callers need not know the width of a Pack.
  double threshold_at(double gap) const;

 private:
  /// Throws InputError if the law does not fit.
  void check_fit() const;
  double default_stiffness() const;

  Friction friction_;
  std::shared_ptr<const GapLaw> law_;
  double cutoff_;
  double traction_at_cutoff_ = 0;
};

}  // namespace ixos
