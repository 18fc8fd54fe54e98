/// Time integration: one engine for every table.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/record.hpp"
#include "model/model.hpp"
#include "solve/choice/linear_solver.hpp"
#include "solve/newton/newton.hpp"
#include "state/state.hpp"
#include "time/acceleration.hpp"
#include "time/stable_step.hpp"
#include "time/stage_problem.hpp"
#include "time/step_error.hpp"
#include "time/table.hpp"

namespace ixos {

/// The result of a step.
struct StepResult {
  bool converged = false;
  int newton_iterations = 0;
  long linear_iterations = 0;  ///< of iterative linear solvers
  std::string reason;          ///< of a failure, for the user
  bool crossed = false;        ///< the reason is that a surface crossed its obstacle, see crossing()
  bool ran_out = false;        ///< the reason is that Newton's iterations were used up
};

/// The work of all steps so far [E0 L0^D].
struct Works {
  double dissipated = 0;  ///< by damping, viscosity, friction and all else
  double external = 0;    ///< of loads, reactions and moved obstacles
};

/// An integrator that advances a model in time. The model must outlive it. Collective.
class Integrator {
 public:
  /// Throws std::invalid_argument if the table is inconsistent (see check), or if only one of table and model has
  /// inertia; InputError if the model does not have what the table needs (see check_compatible). Closes the model, see
  /// Model::close().
  Integrator(Model& model, Table table, std::shared_ptr<const LinearSolverFactory> linear_solver,
             const NewtonOptions& newton);
  Integrator(const Integrator&) = delete;
  Integrator& operator=(const Integrator&) = delete;

  /// Sets the state at `time`: u and v local arrays (ghosts set too); a is the solution of M a = f_ext - C v - f.
  /// Constrained degrees of freedom take their motion's values. Throws InputError if the state is inadmissible.
  void initialize(std::vector<double> u, std::vector<double> v, double time);

  /// Begins without displacements, and does not ask whether that is admissible: transfer() follows, which loads a
  /// state.
  void await_state(double time);

  /// Continues from a state of this model, which may be that of another integrator: as a run does that resumes from
  /// displacements, velocities and histories. Predictors forget earlier steps; works count from 0.
  /// Throws InputError if the state is inadmissible.
  void resume(const State& state);
  /// Does the same, and adds to the works of another integrator, perhaps one of another mesh or scheme. The works of
  /// single sources count from 0.
  void resume(const State& state, const Works& before);

  /// Counts on from the works of another integrator, source by source, and adds to the external work. Sources that only
  /// the other one has count as dissipated before.
  void continue_works(const Integrator& before, double external);

  /// Takes one step of length dt > 0. On failure nothing has changed: state, time and sums are those before the call.
  StepResult step(double dt);
  /// Takes a step in two parts: a caller may judge the result of attempt(), then accept it or attempt another length.
  StepResult attempt(double dt);
  void accept();
  /// Returns local_error() and TermSums::gap_ratio() of the attempted step; throws std::logic_error if there is none.
  /// From the first call of error() on, a velocity is kept.
  double error();
  double gap_ratio() const;
  /// Returns edge_change() over the attempted step, and a bound of the energy by which the tolerance of Newton's method
  /// and rounding move the balance of a scheme with one stage in it, see unbalanced_work(); likewise.
  double edge_change() const;
  double unbalanced_work() const;
  /// Changes the number of points in time of the interaction, if the table allows it (Table::interaction_points); those
  /// of the load stay.
  void set_interaction_points(int points);

  /// Sets whether a state that another scene's quasi-static run left keeps the rate of its last step as velocity when
  /// transfer() loads it. By default it is at rest: the rate is that of the load, and no velocity of an equilibrium.
  void keep_static_rates(bool keep) { keeps_static_rates_ = keep; }
  /// Returns by how much the velocity of prescribed displacements jumped when transfer() loaded the state of another
  /// scene [L0/T0]; 0 if there was none.
  double resumed_jump() const { return resumed_jump_; }

  /// Returns the longest step from here that is stable and no longer than `wanted`: `wanted` itself for implicit
  /// schemes. step() does not call it. Collective.
  double stable_step(double wanted);

  /// Has a function called for each iterate of Newton's method, on every rank; an empty one ends that. It must not
  /// change the integrator or throw.
  void watch(std::function<void(const NewtonIterate&)> function) { watch_ = std::move(function); }

  const Model& model() const { return model_; }
  const Table& table() const { return table_; }
  const State& state() const { return states_.front(); }
  /// Returns the end of the attempted step, without histories; throws std::logic_error if there is none.
  const State& attempted() const;
  double time() const { return states_.front().time; }
  /// Returns the number of operators and preconditioners that the stages share.
  std::size_t tangents() const { return solvers_.size(); }
  /// Returns a local array of accelerations of the present state; momentum-form schemes solve for it at the first
  /// request.
  const std::vector<double>& acceleration();
  /// Returns the work of the damping, and of loads and reactions, since initialize() [E0 L0^D].
  double dissipated_energy() const { return dissipated_; }
  double external_work() const { return external_work_; }
  Works works() const { return {dissipated_, external_work_}; }
  /// Returns the dissipated energy by source, parallel to Model::dissipation_names(), since initialize() or a restart
  /// in another scene.
  const std::vector<double>& dissipations() const { return dissipations_; }
  /// Returns what was dissipated before that restart.
  double dissipated_before() const { return dissipated_before_; }

  /// Writes or reads, for checkpoints and snapshots (see Snapshot), everything that later steps depend on, to the last
  /// bit. Discards an attempt that waits to be accepted. Loading onto another partition leaves out the state of the
  /// linear solvers. Loading into another scene resumes from displacements, velocities, time and sums alone; it throws
  /// InputError if they are inadmissible there, or a prescribed displacement would jump. Collective.
  void transfer(Record& record);

 private:
  /// Stages with like tangents take turns in one, and so in one preconditioner.
  struct StageSolver {
    StageSolver(const Integrator& integrator, const Table& table, bool matrix_free);
    StageProblem problem;
    NewtonSolver newton;
  };

  void make_solvers();
  void follow_slots();
  /// Lets the model couple the nodes of bodies that have come near each other, and renews solvers if its matrices have
  /// changed.
  void follow_couplings();
  StageSolver& solver(std::size_t stage) const { return *solvers_[solver_of_[stage]]; }
  StepResult advance(double dt);
  void begin_at(std::vector<double> u, std::vector<double> v, double time);
  void discard_past();
  /// Returns the present state, on the way of the step if one is under way.
  Place place() const;
  Segment way() const;
  void check_attempt() const;
  void find_forces();
  bool know_acceleration();
  Predictor usable(Predictor predictor) const;
  void look_ahead(Predictor predictor, std::size_t stage, double h, std::vector<double>& guess) const;
  void predict(Predictor predictor, std::size_t stage, double dt, std::vector<double>& guess) const;
  void look_back(double dt);
  NewtonResult solve_stage(std::size_t stage, double dt, std::vector<double>& u);
  NewtonResult solve_from_nearby(std::size_t stage, double dt, std::vector<double>& u);
  void close_stage(std::size_t stage, double dt, std::vector<double>&& u);
  bool driving_is_defined(const Stage& stage, double dt, std::string& reason) const;
  bool take_explicit_step(double dt, std::string& reason);
  bool transfer_kind(Record& record);
  void transfer_derived(Record& record);
  void check_whole(const char* name, const std::vector<double>& field, Extent extent) const;
  void refuse_jump() const;
  double velocity_jump() const;

  Model& model_;
  Table table_;
  std::shared_ptr<const LinearSolverFactory> linear_solver_;
  bool keeps_static_rates_ = false;
  bool needs_acceleration_ = false;  ///< some row of the table uses a_n, or the predictor does
  bool has_external_ = false;        ///< the model has loads or constraints on some rank
  bool in_step_ = false;             ///< the memories are of the step from the present state
  double resumed_jump_ = 0;
  std::vector<std::unique_ptr<StageSolver>> solvers_;
  std::vector<std::size_t> solver_of_;  ///< by stage
  NewtonOptions newton_;
  std::function<void(const NewtonIterate&)> watch_;
  Acceleration balance_;
  long version_ = 0;                         ///< of the discretization that the solvers are for
  std::unique_ptr<StableStep> stable_step_;  ///< explicit schemes

  std::vector<State> states_;  ///< the present state, then the ends of the stages
  StepMemories memories_;
  std::size_t slots_ = 0;      ///< of the memories
  std::vector<double> known_;  ///< scratch
  double time_carry_ = 0;
  double dissipated_ = 0;
  std::vector<double> dissipations_;  ///< by source
  double dissipated_before_ = 0;
  double external_work_ = 0;
  // Displacements at the start of the step before, and of the step before that, and the length of the latter (0: there
  // was none), for predictors that look back; and the predictor that was nearest to the end of the last step.
  std::vector<double> previous_u_, earlier_u_;
  double earlier_dt_ = 0;
  Predictor nearest_ = Predictor::LastDisplacement;
  PreviousVelocity previous_;  ///< v only if steps are judged
  bool judged_ = false;
  double attempted_dt_ = 0;  ///< 0 if no attempt waits to be accepted
  bool acceleration_known_ = false;
  Teuchos::RCP<Vector> unknown_;
};

}  // namespace ixos
