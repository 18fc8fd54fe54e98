/// The acceleration from the balance of forces in a state.
#pragma once
#include <memory>
#include <vector>

#include "balance/balance.hpp"
#include "solve/choice/linear_solver.hpp"
#include "state/state.hpp"
#include "time/mass_solver.hpp"

namespace ixos {

/// A solver for M a = f_ext(t) - C v - f(u); constrained degrees of freedom take the acceleration of their motion. A
/// lumped mass needs a division only. The matrix of a consistent mass is made at the first request; if tangents are
/// matrix-free, plain CG (to 1e-12, whatever the scene's linear solver) takes its place. The model must outlive it.
/// Collective.
class Acceleration {
 public:
  Acceleration(const Model& model, std::shared_ptr<const LinearSolverFactory> linear_solver);

  /// Forgets the mass matrix, for a pattern that has changed.
  void renew() { mass_.renew(); }
  /// Evaluates the right-hand side at a place with its velocity. Returns false if it is inadmissible.
  bool balance(const Place& at);
  /// Calls balance() and solves for a, a local array. Returns false if the place is inadmissible or the solve with the
  /// mass matrix fails. Without inertia a is 0.
  bool solve(const Place& at, std::vector<double>& a);
  /// Puts load and reactions, M a less the last balance, into the state of that balance.
  void record_forces(State& state) const;

 private:
  bool solve_consistent(double time, std::vector<double>& a);
  bool solve_with_grips(const Place& at, std::vector<double>& a);
  void find_reactions(const Place& at);
  void grip_forces(const Place& at, const std::vector<double>& a);
  void record_driving_forces(State& state) const;

  const Model& model_;
  MassSolver mass_;
  Balance forces_;
  std::vector<double> balance_;    ///< less the sum of forces: local, valid for owned entries
  std::vector<double> load_;       ///< less the load: scratch, local
  std::vector<double> reactions_;  ///< less the sum of forces on globals, over ranks
};

}  // namespace ixos
