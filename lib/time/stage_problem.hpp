/// One stage of a scheme as a nonlinear problem.
#pragma once
#include <vector>

#include "model/model.hpp"
#include "solve/nonlinear_problem.hpp"
#include "time/state.hpp"
#include "time/table.hpp"

namespace ixos {

/// f(u_s) = (1/dt^2) M inertia + (1/dt) C damping + elastic rule + interaction rule; the row of a constrained degree of
/// freedom is kappa (u - u_bar). arm() sets it for a step; until the next arm() it is constant. Model and stage must
/// outlive it.
class StageProblem final : public NonlinearProblem {
 public:
  StageProblem(const Model& model, const Stage& stage);

  /// `known` are the step's start and the ends of the stages before this one; they must stay until the solve is over.
  /// `time` is the step's start. Throws std::logic_error where the start of the segment is inadmissible.
  void arm(const std::vector<State>& known, double time, double dt);

  /// u_s = the guess, moved from `base` (an admissible local array) towards `guess` as far as is admissible, with the
  /// constrained values set. Both local, result local in place of guess. Collective.
  void clip(const std::vector<double>& base, std::vector<double>& guess) const;

  Teuchos::RCP<const Map> map() const override { return model_.space().owned_map(); }
  Teuchos::RCP<CrsMatrix> create_matrix() const override { return model_.pattern().create_matrix(model_.space()); }
  bool residual(const Vector& x, Vector& f) override;
  void tangent(const Vector& x, CrsMatrix& w) override;
  double admissible_step(const Vector& x, const Vector& direction) override;
  /// tolerance x the largest of |inertia|, |elastic|, |interaction|, but no less than what rounding u_s alone changes.
  double convergence_bound(double relative_tolerance) const override;

 private:
  Segment segment(const Rule& rule) const;
  void set_constraints(std::vector<double>& u) const;
  double rounding_force(const State& start, double coefficient);

  const Model& model_;
  const Stage& stage_;
  double dt_ = 0;
  double stage_time_ = 0;
  const std::vector<double>* from_ = nullptr;  ///< u at the step's start
  std::vector<double> path_velocity_;          ///< h v at the step's start, where a rule uses it
  std::vector<double> known_inertia_;          ///< inertia row without s (u_s - u_0), local
  std::vector<double> known_damping_;
  std::vector<double> kept_;  ///< kept parts of the rules, local
  double rounding_ = 0;       ///< force by which the last digits of u change the balance
  double diagonal_ = 0;       ///< kappa
  double scale_ = 0;          ///< largest of the three norms at the last residual

  std::vector<double> u_;  ///< local, at the last residual
  std::vector<double> bracket_, inertia_, elastic_, interaction_;
  mutable std::vector<double> direction_;
};

}  // namespace ixos
