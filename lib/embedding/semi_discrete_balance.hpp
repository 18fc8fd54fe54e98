/// The balance of the semi-discrete model at one state of motion.
#pragma once
#include <vector>

#include "balance/balance.hpp"

namespace ixos {

/// The nodal forces of the balance Inertia + Damping + Elastic + Interaction - External = 0.
enum class NodalForce {
  Inertia,      ///< M x''
  Damping,      ///< C x' + f_v(x, x'): Rayleigh damping and viscosity
  Elastic,      ///< f_el(x), the gradient of the elastic energy
  Interaction,  ///< f_c(x), the gradient of the interactions' energy: minus the force on the body
  External      ///< f_ext(t), the loads
};

/// Vectors on the owned map: displacement [L0], velocity [L0/T0] and acceleration [L0/T0^2] at a time [T0].
struct MotionState {
  const Vector* u = nullptr;
  const Vector* v = nullptr;  ///< null: zero
  const Vector* a = nullptr;  ///< null: zero
  double time = 0;
};

/// The forces at one state, each evaluated at the first request. Local arrays whose entries of owned nodes are valid
/// [E0 L0^(D-1)]. The model must outlive it. Functions that are not const are collective.
class SemiDiscreteBalance {
 public:
  explicit SemiDiscreteBalance(const Model& model);

  /// Chooses the state, whose vectors must stay until the next call.
  void set(const MotionState& state);
  /// Returns whether u is admissible on all ranks: no inverted element, and no gap <= 0 where the law needs positive
  /// gaps. Evaluates the forces unless it judged the same u last time. The forces of an inadmissible u are not usable.
  bool admissible();

  const std::vector<double>& force(NodalForce part);
  /// Returns the sum of all forces in all rows. In rows of constrained degrees of freedom it is the reaction.
  const std::vector<double>& sum();
  /// Sets f to the sum, in rows of constrained degrees of freedom to u - u_bar(t).
  void residual(Vector& f);

  /// Returns the place of the state, with what the terms keep before any step.
  Place place() const { return {u_.data(), state_.time, &histories_, nullptr, v_.data()}; }
  double time() const { return state_.time; }
  /// Return local arrays, ghosts set.
  const std::vector<double>& displacement() const { return u_; }
  const std::vector<double>& velocity();

 private:
  BalancePoint point();
  void evaluate_forces();
  const std::vector<double>& acceleration();

  const Model& model_;
  Balance balance_;
  TermHistories histories_;
  Rule rule_ = end_rule();
  MotionState state_;
  std::vector<double> u_, v_, a_, part_, sum_;
  std::vector<double> judged_;  ///< the u of the last verdict
  double judged_time_ = 0;      ///< and its time
  bool verdict_ = true;         ///< of this rank
  bool has_velocity_ = false, has_acceleration_ = false, has_forces_ = false, has_sum_ = false;
};

}  // namespace ixos
