/// Time integration: one engine for every table.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "checkpoint/record.hpp"
#include "model/model.hpp"
#include "solve/linear_solver.hpp"
#include "solve/newton.hpp"
#include "time/acceleration.hpp"
#include "time/stable_step.hpp"
#include "time/stage_problem.hpp"
#include "time/state.hpp"
#include "time/step_error.hpp"
#include "time/table.hpp"

namespace ixos {

/// How a step ended.
struct StepResult {
  bool converged = false;
  int newton_iterations = 0;
  long linear_iterations = 0;  ///< of iterative linear solvers
  std::string reason;          ///< of a failure, for a person
};

/// Advances a model in time. The model must outlive it. Collective.
class Integrator {
 public:
  /// Throws std::invalid_argument where the table is inconsistent (see check), or has inertia and the model has not, or
  /// the other way round.
  Integrator(const Model& model, Table table, std::shared_ptr<const LinearSolverFactory> linear_solver,
             const NewtonOptions& newton);
  Integrator(const Integrator&) = delete;
  Integrator& operator=(const Integrator&) = delete;

  /// Sets the state at `time`: u and v local arrays (ghosts set too); a is solved for, M a = f_ext - C v - f.
  /// Constrained degrees of freedom take their motion's values. Throws InputError where the state is inadmissible.
  void initialize(std::vector<double> u, std::vector<double> v, double time);

  /// One step of length dt > 0. On failure nothing has changed: state, time and sums are those before the call.
  StepResult step(double dt);
  /// The same in two parts: what an attempt found may be judged, and accepted or attempted anew with another length.
  StepResult attempt(double dt);
  void accept();
  /// Of the attempted step: see local_error() and Model::gap_ratio(). From the first call on a velocity is kept.
  double error();
  double gap_ratio() const;
  /// Changes the number of points in time of the interaction, where the table allows it (Table::interaction_points);
  /// those of the load stay.
  void set_interaction_points(int points);

  /// The longest step from here that is stable and no longer than `wanted`: `wanted` itself of implicit schemes. step()
  /// does not ask. Collective.
  double stable_step(double wanted);

  const Model& model() const { return model_; }
  const Table& table() const { return table_; }
  const State& state() const { return states_.front(); }
  double time() const { return time_; }
  /// Operators and preconditioners that the stages share.
  std::size_t tangents() const { return solvers_.size(); }
  /// Local array of accelerations of the present state; momentum-form schemes solve for it at the first request.
  const std::vector<double>& acceleration();
  /// Work of the damping, and of loads and reactions, since initialize() [E0 L0^D].
  double dissipated_energy() const { return dissipated_; }
  double external_work() const { return external_work_; }

  /// For checkpoints, between steps: everything that later steps depend on, to the last bit. Loading onto another
  /// partition leaves out what the linear solvers keep; loading into another scene goes on from displacements,
  /// velocities, time and sums alone; throws InputError where they are inadmissible there, or a prescribed displacement
  /// would jump. Collective.
  void transfer(Record& record);

 private:
  /// Stages with like tangents take turns in one, and so in one preconditioner.
  struct StageSolver {
    StageSolver(const Integrator& integrator, const Table& table, bool matrix_free);
    StageProblem problem;
    NewtonSolver newton;
  };

  StageSolver& solver(std::size_t stage) const { return *solvers_[solver_of_[stage]]; }
  StepResult advance(double dt);
  bool know_acceleration();
  void predict(Predictor predictor, std::size_t stage, double dt, std::vector<double>& guess) const;
  NewtonResult solve_stage(std::size_t stage, double dt, std::vector<double>& u);
  NewtonResult solve_from_nearby(std::size_t stage, double dt, std::vector<double>& u);
  void close_stage(std::size_t stage, double dt, std::vector<double>&& u);
  bool driving_is_defined(const Stage& stage, double dt, std::string& reason) const;
  bool take_explicit_step(double dt, std::string& reason);
  void transfer_derived(Record& record);
  void check_whole(const char* name, const std::vector<double>& field, Extent extent) const;
  void refuse_jump() const;

  const Model& model_;
  Table table_;
  std::shared_ptr<const LinearSolverFactory> linear_solver_;
  bool needs_acceleration_ = false;  ///< some row of the table uses a_n, or the predictor does
  bool has_external_ = false;        ///< the model has loads or constraints on some rank
  std::vector<std::unique_ptr<StageSolver>> solvers_;
  std::vector<std::size_t> solver_of_;  ///< by stage
  NewtonOptions newton_;
  Acceleration balance_;
  std::unique_ptr<StableStep> stable_step_;  ///< explicit schemes

  std::vector<State> states_;  ///< the present state, then the ends of the stages
  std::vector<double> known_;  ///< scratch
  double time_ = 0;
  double time_carry_ = 0;
  double dissipated_ = 0;
  double external_work_ = 0;
  std::vector<double> previous_u_;  ///< at the start of the step before, for Predictor::Extrapolation
  PreviousVelocity previous_;       ///< v only where steps are judged
  bool judged_ = false;
  double attempted_dt_ = 0;  ///< 0 where no attempt waits to be accepted
  bool acceleration_known_ = false;
  Teuchos::RCP<Vector> unknown_;
};

}  // namespace ixos
