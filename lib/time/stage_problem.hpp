/// The stages of a scheme as nonlinear problems.
#pragma once
#include <memory>
#include <vector>

#include "balance/balance.hpp"
#include "balance/tangent_operator.hpp"
#include "model/model.hpp"
#include "model/traits.hpp"
#include "solve/newton/nonlinear_problem.hpp"
#include "state/state.hpp"
#include "time/body_stage.hpp"
#include "time/carried_grips.hpp"
#include "time/table.hpp"

namespace ixos {

class BorderedOperator;

/// Returns whether the stage's rules are gradients for all terms of the model, so that its tangent is symmetric. Rate
/// terms have symmetric tangents in any case.
bool is_symmetric(const Model& model, const Stage& stage);

/// f(u_s) = (1/dt^2) M inertia + rate terms + elastic rule + interaction rule - mean load. arm() sets it up for a stage
/// of a step; until the next arm() of a problem of that model it is constant. Model and table must outlive it.
///
/// A constrained degree of freedom has the row kappa (u - u_bar), and nothing couples it to the others, so that the
/// matrix stays symmetric. Until u reaches u_bar, the other rows are those at u, moved along the tangent to u_bar: f_f
/// - K_fp (u - u_bar)_p. Newton's step with the uncoupled matrix is then the one with the prescribed values eliminated
/// exactly.
class StageProblem final : public NonlinearProblem {
 public:
  /// `matrix_free`: the tangent is a TangentOperator, otherwise a matrix. `mixed_steps`: take them if a body is nearly
  /// incompressible.
  StageProblem(Model& model, const Table& table, bool matrix_free = false, bool mixed_steps = true);
  StageProblem(Model&, Table&&, bool = false, bool = true) = delete;

  /// Sets the stage to solve. `known` are the step's start and the ends of the stages before this one; they and the
  /// step's memories must stay until the solve is over. Throws std::logic_error if the start of the segment is
  /// inadmissible.
  void arm(std::size_t stage, const std::vector<State>& known, double dt, StepMemories& step);

  /// Moves `guess` from `base` (an admissible local array) towards `guess` as far as is admissible; both local.
  /// Collective.
  void clip(const std::vector<double>& base, std::vector<double>& guess) const;

  /// Returns the time of the stage's end.
  double time() const { return stage_time_; }
  /// Puts mean load and reactions at the last x that residual() saw into the state.
  void record_forces(State& state) const;

  Teuchos::RCP<const Map> map() const override { return model_.space().unknown_map(); }
  bool is_bordered() const override { return model_.space().has_globals(); }
  Teuchos::RCP<Operator> create_operator() override;
  bool residual(const Vector& x, Vector& f) override;
  void tangent(const Vector& x, Operator& w) override;
  double admissible_step(const Vector& x, const Vector& direction) override;
  /// Returns tolerance x the largest of |inertia|, |elastic|, |interaction|, |load|, but at least the change that
  /// rounding u_s alone makes; 0 until the prescribed values are reached.
  double convergence_bound(double relative_tolerance) const override;
  /// Returns the largest of those four norms at the last x that residual() saw.
  double force_scale() const { return scale_; }
  bool is_lost() const override { return lost_; }
  bool is_gradient() const override { return has_potential_ && !moving_; }
  bool has_kinks() const override { return !has_potential_ && !moving_ && has_friction(model_); }
  double way_left(const Vector& x) override;
  void complete_direction(const Vector& x, Vector& direction) override;
  Potential potential(const Vector& x) override;
  void relax_tangent(int level) override;
  void begin_solve() override;
  bool has_mixed_steps() const override { return mixed_ && !iterates_.are_left && iterates_.are_used; }
  void leave_mixed_steps(bool again) override;
  int family() const override { return static_cast<int>(stage_ - table_.stages.data()); }

 private:
  Segment segment(const Rule& rule) const;
  BalancePoint point() const;
  BalancePoint tangent_point() const;
  TangentWeights weights() const;
  void begin_stage(const std::vector<KnownState>& known, StepMemories& step) const;
  void inertia_bracket(const std::vector<double>& u, std::vector<double>& bracket) const;
  /// Sets the tangent's values at u_, constraints apart.
  void assemble(double* values) const;
  KeptForces* kept_points() { return kept_points_.empty() ? nullptr : &kept_points_; }
  /// Sets u_ to x, ghosts included.
  void move_to(const Vector& x);
  bool is_at(const Vector& x) const;
  bool has_tangent() const;
  void linearize();
  void take_iterate();
  Tangent tangent_kind() const;
  double shift() const;
  bool is_reached(std::size_t dof, double value) const;
  void constrain_residual(double* out);
  void sum_globals();
  void move_globals(const std::vector<double>& missing);
  void find_border();
  void take_border(BorderedOperator& w, const double* values);
  void add_grip_forces();
  Potential globals_potential(const std::vector<double>& u, const std::vector<double>& bracket) const;
  double rounding_force(const State& start, double coefficient);
  double reach(const State& start) const;

  Model& model_;
  const Table& table_;
  const Stage* stage_ = nullptr;  ///< the one that it is armed for
  bool exact_rates_;  ///< driven degrees of freedom have the velocity and acceleration of their motion, not the rows'
  bool has_mass_;
  bool has_potential_ = false;  ///< the armed stage's rules are gradients for all terms
  double dt_ = 0;
  double step_time_ = 0;  ///< the step's start
  double stage_time_ = 0;
  const State* start_ = nullptr;  ///< of the step
  const StepMemories* step_ = nullptr;
  std::vector<double> path_velocity_;  ///< h v at the step's start, if a rule uses it
  std::vector<double> known_inertia_;  ///< inertia row without s (u_s - u_0), local
  std::vector<double> kept_;           ///< kept parts of the rules less the mean load, local
  std::vector<double> load_;           ///< mean load, local
  std::vector<double> prescribed_, prescribed_velocity_, prescribed_acceleration_;  ///< local, at constrained dofs
  double rounding_ = 0;       ///< force by which the last digits of u change the balance
  double rounding_here_ = 0;  ///< that force for u at the last residual
  double size_ = 0;           ///< norm of the nodes' distances from the middle of the mesh; 0 with inertia
  double reach_ = 0;      ///< the largest |u| of an equilibrium that is not a body lost in space; infinite with inertia
  double diagonal_ = 0;   ///< kappa
  double stiffness_ = 0;  ///< elastic scale, with that of viscosity
  double load_norm_ = 0;
  double scale_ = 0;     ///< largest of the four norms at the last residual
  bool moving_ = false;  ///< some prescribed value is not reached at the last residual
  bool lost_ = false;    ///< u is far beyond reach_ at the last residual, and no spring holds the body
  int relaxation_ = 0;

  Balance balance_;
  std::vector<double> u_;  ///< local, of the last evaluation of forces or tangents
  /// Results at u_, each with the stage, or the number of the arm(), that it was computed for; nothing if u_ has
  /// another value since.
  struct Computed {
    const Stage* forces_of = nullptr;  ///< the stage whose forces residual() left in the balance
    long imported = 0;                 ///< the arm() in which residual() took u_ from its x
    long kept = 0;                     ///< the arm() in which it kept the points
  };
  Computed at_u_;
  long arm_ = 0;            ///< the number of the last arm()
  KeptForces kept_points_;  ///< of residual(); empty if the tangent is applied without a matrix
  std::vector<double> bracket_, product_, reaction_;
  /// The last two of Newton's iterates that tangent() saw, local, for mixed steps; empty if there are none. The one
  /// before the first is the step's start, whose stress is nearer than that of a guess, which need not keep the volume.
  struct Iterates {
    std::vector<double> last, before;
    int number = 0;         ///< of iterates that tangent() saw
    bool is_last = false;   ///< u_ is `last`
    bool are_used = false;  ///< by the last tangent()
    bool are_left = false;  ///< no more mixed steps in this solve
  };
  Iterates iterates_;
  bool mixed_;  ///< it has mixed steps
  /// Of forces, relative. The stress of the change of volume is the bulk modulus times a small difference of strains.
  double rounding_error_;
  /// Where the tangent was taken last that residual() needed on the way, or the one without a matrix.
  struct TangentAt {
    std::vector<double> u;
    long arm = 0;
    int relaxation = 0;
  };
  TangentAt tangent_at_;
  std::vector<double> values_;                 ///< the values of that tangent, if it is a matrix
  Teuchos::RCP<TangentOperator> matrix_free_;  ///< null if the tangent is a matrix
  std::unique_ptr<CarriedGrips> grips_;        ///< null if no body carries nodes
  std::unique_ptr<BodyStage> bodies_;          ///< null without rigid bodies
  std::vector<double> globals_;                ///< forces on globals at the last residual, summed over ranks
  Border border_;
  mutable std::vector<double> direction_;
};

}  // namespace ixos
