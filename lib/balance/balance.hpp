/// The balance of forces M a + C v + f_v(u, v) + f_el(u) + f_c(u) = f_ext(t), summed in one place.
#pragma once
#include <vector>

#include "model/term_sums.hpp"
#include "solve/newton/nonlinear_problem.hpp"

namespace ixos {

/// Selects the forces that depend on rates: none, those of the stage that began last in the step, or f(u, v) in a
/// state.
enum class Rates { None, Stage, State };

/// Where the balance is taken. Its arrays are local and must stay while it is in use.
struct BalancePoint {
  Segment elastic, interaction;  ///< both end at the same displacement
  const Rule* elastic_rule = nullptr;
  const Rule* interaction_rule = nullptr;
  const double* acceleration = nullptr;  ///< what `mass` M multiplies; null: no inertia
  double mass = 1;
  Rates rates = Rates::None;
  const double* velocity = nullptr;  ///< Rates::State only [L0/T0]
};

/// The factors of W = mass M + damping C + stiffness K: the derivatives of the balance by acceleration, velocity and
/// displacement. The rules of the point have the factor of K in their weights.
struct TangentWeights {
  double mass = 0;
  double damping = 0;
  double stiffness = 0;
  double shift = 0;  ///< factor of the identity

  /// Returns the factor of constrained degrees of freedom where their equation is x - u_bar(t) = 0. If W has no
  /// stiffness it is the factor of M: then the equation is the one for accelerations.
  double constrained() const { return stiffness != 0 ? stiffness : mass; }
};

/// The sum over a model's terms, for stages of schemes, for states and for other integrators alike. It keeps the parts
/// of the last evaluation. The model must outlive it. Functions do not communicate.
class Balance {
 public:
  explicit Balance(const Model& model);

  const TermSums& sums() const { return sums_; }

  /// Evaluates inertia, elasticity and interactions. Returns false if the point is inadmissible on this rank. `kept`:
  /// null, or what the terms keep for the tangent.
  bool evaluate(const BalancePoint& at, KeptForces* kept = nullptr);
  /// Evaluates the inertia alone.
  void evaluate_inertia(const BalancePoint& at);
  /// Evaluates one part.
  bool evaluate(Part part, const Segment& segment, const Rule& rule, KeptForces* kept = nullptr);
  /// Returns the parts of the last evaluation; valid for owned entries [E0 L0^(D-1)].
  const std::vector<double>& inertia() const { return inertia_; }
  const std::vector<double>& force(Part part) const { return part == Part::Elastic ? elastic_ : interaction_; }
  /// Sets `out` to the sum of the last evaluation, with the rates of the point, in owned rows. `fixed`: local, forces
  /// that do not depend on the unknown, such as less the load; null: none.
  void sum(const BalancePoint& at, const double* fixed, double* out);
  /// Returns this rank's share of the forces on globals in the last sum(), without inertia.
  const std::vector<double>& global_forces() const { return globals_; }

  /// Sets matrix values in the layout of Pattern::create_matrix, Pattern::values() of them, to W, in all rows and
  /// columns, also those of constrained degrees of freedom. `kept`: null, or that of the last evaluation, which must
  /// have been at the point.
  void tangent(const BalancePoint& at, const TangentWeights& weights, Tangent kind, const KeptForces* kept,
               double* values) const;

  /// Returns this rank's share of the potential whose gradient the elastic and interaction forces are [E0 L0^D]. Called
  /// only if they are gradients.
  Potential potential(const BalancePoint& at) const;

 private:
  Potential rule_potential(Part part, const Segment& segment, const Rule& rule) const;

  const Model& model_;
  TermSums sums_;
  std::vector<double> inertia_, elastic_, interaction_;
  std::vector<double> rates_;  ///< scratch, local
  std::vector<double> globals_;
};

}  // namespace ixos
