#include "time/integrator.hpp"

#include <fmt/format.h>

#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "base/error.hpp"
#include "model/crossing.hpp"
#include "model/edge_change.hpp"
#include "model/term_sums.hpp"
#include "model/traits.hpp"
#include "rule/row_on_states.hpp"
#include "time/body_steps.hpp"
#include "time/compatibility.hpp"
#include "time/displacement_error.hpp"
#include "time/equilibrium.hpp"
#include "time/work.hpp"

namespace ixos {
namespace {

/// Returns whether some row uses the acceleration of the step's start.
bool uses_acceleration(const Table& table) {
  for (const Stage& stage : table.stages)
    for (const Row* row : {&stage.velocity, &stage.inertia, &stage.damping})
      if (!row->known.empty() && row->known[0].a != 0) return true;
  return false;
}

}  // namespace

Integrator::Integrator(Model& model, Table table, std::shared_ptr<const LinearSolverFactory> linear_solver,
                       const NewtonOptions& newton)
    : model_(model),
      table_(std::move(table)),
      linear_solver_(std::move(linear_solver)),
      needs_acceleration_(uses_acceleration(table_) || table_.predictor == Predictor::ConstantAcceleration ||
                          table_.predictor == Predictor::Newmark),
      newton_(newton),
      balance_(model, linear_solver_),
      version_(model.discretization().version()),
      states_(table_.stages.size() + 1),
      unknown_(Teuchos::rcp(new Vector(model.space().unknown_map()))) {
  check(table_);
  check_compatible(model, table_);
  if (is_static(table_) != (model.mass() == nullptr))
    throw std::invalid_argument("scheme \"" + table_.name + "\": " +
                                (is_static(table_) ? "it has no inertia, but the model has a mass"
                                                   : "it needs inertia, but the model has no mass"));
  if (model.mass() != nullptr && model.mass()->is_lumped() != (table_.mass == Inertia::Lumped))
    throw std::invalid_argument("scheme \"" + table_.name +
                                "\": it needs a lumped mass and the model has a consistent one, or the reverse");
  model.close();
  states_.front().histories = model.create_histories();
  // Reactions that do work are those before a correction: it would move the balance as much as it mends.
  newton_.corrects = table_.energy_promise > 0 && model.space().maximum(model.constraints().driven() ? 1 : 0) == 0;
  if (is_static(table_)) newton_.maximum_iterations += newton_.snap_iterations;
  newton_.watch = [this, given = newton.watch](const NewtonIterate& iterate) {
    if (given) given(iterate);
    if (watch_) watch_(iterate);
  };
  has_external_ = model.space().maximum(model.loads().empty() && model.constraints().empty() ? 0 : 1) > 0 ||
                  !model.driven_globals().empty();
  if (is_explicit(table_)) {
    stable_step_ = std::make_unique<StableStep>(model_, table_.safety);
    return;
  }
  make_solvers();
}

/// Makes operators and preconditioners for the present version of the discretization.
void Integrator::make_solvers() {
  solvers_.clear();
  solver_of_.clear();
  std::vector<const Stage*> first;  // of each solver
  for (const Stage& stage : table_.stages) {
    const auto like =
        std::find_if(first.begin(), first.end(), [&](const Stage* other) { return have_like_tangents(*other, stage); });
    solver_of_.push_back(static_cast<std::size_t>(like - first.begin()));
    if (like != first.end()) continue;
    first.push_back(&stage);
    solvers_.push_back(std::make_unique<StageSolver>(*this, table_, linear_solver_->matrix_free()));
  }
}

void Integrator::follow_couplings() {
  if (!is_explicit(table_)) model_.update_couplings(states_.front().u.data());
  if (version_ == model_.discretization().version()) return;
  balance_.renew();
  if (!is_explicit(table_)) make_solvers();
  version_ = model_.discretization().version();
}

Integrator::StageSolver::StageSolver(const Integrator& integrator, const Table& table, bool matrix_free)
    : problem(integrator.model_, table, matrix_free, allows_mixed_steps(integrator.newton_)),
      newton(problem, *integrator.linear_solver_, integrator.newton_) {}

void Integrator::initialize(std::vector<double> u, std::vector<double> v, double time) {
  begin_at(std::move(u), std::move(v), time);
  find_forces();
}

void Integrator::await_state(double time) {
  const std::vector<double> zero(static_cast<std::size_t>(model_.space().local()), 0.0);
  begin_at(zero, zero, time);
}

/// Sets the state, discards what earlier steps left, and begins the terms' histories.
void Integrator::begin_at(std::vector<double> u, std::vector<double> v, double time) {
  discard_past();
  State& start = states_.front();
  const State given{std::move(u), std::move(v), {}};
  start = given;  // a copy: the arrays keep their memory, so that views of them stay valid
  start.time = time;
  start.histories = model_.create_histories();
  if (model_.mass() == nullptr) std::fill(start.v.begin(), start.v.end(), 0.0);
  model_.set_prescribed(time, start.u.data(), start.v.data(), nullptr);
  drive_bodies(model_, time, start.u.data(), start.v.data(), nullptr);
  carry_nodes(model_, start.u.data(), start.v.data());
  model_.initialize(known_states(states_, 1).front(), start.histories);
}

void Integrator::discard_past() {
  in_step_ = false;
  time_carry_ = 0;
  dissipated_ = 0;
  external_work_ = 0;
  previous_ = {};
  earlier_dt_ = 0;
  nearest_ = Predictor::LastDisplacement;
  attempted_dt_ = 0;
  acceleration_known_ = false;
  dissipated_before_ = 0;
  dissipations_.assign(model_.dissipation_names().size(), 0.0);
}

void Integrator::resume(const State& state) {
  const auto local = static_cast<std::size_t>(model_.space().local());
  if (state.u.size() != local || state.v.size() != local)
    throw std::logic_error("the state is of another model, or of another part of its mesh");
  discard_past();
  State& start = states_.front();
  start = state;  // a copy, see begin_at()
  follow_slots();
  if (model_.mass() == nullptr) std::fill(start.v.begin(), start.v.end(), 0.0);
  model_.set_prescribed(start.time, start.u.data(), start.v.data(), nullptr);
  drive_bodies(model_, start.time, start.u.data(), start.v.data(), nullptr);
  carry_nodes(model_, start.u.data(), start.v.data());
  find_forces();
}

void Integrator::resume(const State& state, const Works& before) {
  resume(state);
  dissipated_ = dissipated_before_ = before.dissipated;
  external_work_ = before.external;
}

void Integrator::continue_works(const Integrator& before, double external) {
  dissipated_ = dissipated_before_ = before.dissipated_;
  external_work_ = before.external_work_ + external;
  if (before.time() == time()) time_carry_ = before.time_carry_;
  const std::vector<std::string>&mine = model_.dissipation_names(), &others = before.model_.dissipation_names();
  for (std::size_t i = 0; i < mine.size(); ++i) {
    const auto found = std::find(others.begin(), others.end(), mine[i]);
    if (found == others.end()) continue;
    dissipations_[i] = before.dissipations_[static_cast<std::size_t>(found - others.begin())];
    dissipated_before_ -= dissipations_[i];
  }
}

Place Integrator::place() const {
  Place here = states_.front().place();
  if (in_step_) here.step = &memories_;
  return here;
}

/// Returns the way of the attempted step.
Segment Integrator::way() const {
  const State& start = states_.front();
  const State& end = states_.back();
  return {start.u.data(), nullptr, end.u.data(), start.time, end.time - start.time, &start.histories, &memories_};
}

void Integrator::check_attempt() const {
  if (attempted_dt_ == 0) throw std::logic_error("there is no attempted step to judge");
}

/// Solves for the acceleration if a stage or an output needs it. Throws InputError if the state is not admissible.
void Integrator::find_forces() {
  follow_slots();
  if (needs_acceleration_ || table_.closing != Closing::Collocate || has_external_)
    acceleration();
  else if (!balance_.balance(place()))
    throw InputError("the state at the start is not admissible: a gap is not positive, or an element is inverted");
  if (const std::string crossed = crossing(model_, segment_at(place())); !crossed.empty())
    throw InputError("the state at the start is not admissible: " + crossed);
  if (has_external_) balance_.record_forces(states_.front());
}

/// Solves for the acceleration of the present state, unless it is known. Returns false if that fails.
bool Integrator::know_acceleration() {
  follow_slots();
  if (!acceleration_known_) acceleration_known_ = balance_.solve(place(), states_.front().a);
  return acceleration_known_;
}

const std::vector<double>& Integrator::acceleration() {
  if (!know_acceleration())
    throw InputError(
        "the acceleration cannot be solved for: a gap is not positive, an element is inverted, the mass "
        "matrix is singular, or the linear solver failed");
  return states_.front().a;
}

/// Expressions are sampled before a run (check_over). A value that the samples missed ends the step, not the program.
bool Integrator::driving_is_defined(const Stage& stage, double dt, std::string& reason) const {
  const double start = time(), end = start + stage.end * dt;
  bool defined = obstacles_are_finite(model_, end) && bodies_are_finite(model_, end);
  if (has_external_) {
    defined = defined && model_.constraints().are_finite(end) && model_.loads().are_finite(end);
    for (const TimePoint& point : stage.load) defined = defined && model_.loads().are_finite(start + point.time * dt);
    defined = model_.space().minimum(defined ? 1 : 0) > 0;
  }
  if (!defined)
    reason = fmt::format(
        "a prescribed motion, an obstacle's motion or a load is not a finite number between t = {:.10g} and {:.10g} T0",
        start, end);
  return defined;
}

bool Integrator::take_explicit_step(double dt, std::string& reason) {
  const Stage& row = table_.stages.front();
  const State& start = states_.front();
  State& end = states_.back();
  const std::size_t size = start.u.size();
  for (std::vector<double>* array : {&known_, &end.u, &end.v}) array->resize(size);
  const std::vector<KnownState> known = known_states(states_, 1);
  evaluate_known(row.inertia, known, dt, known_);
  for (std::size_t i = 0; i < size; ++i)
    end.u[i] = start.u[i] + (dt * dt * start.a[i] - known_[i]) / row.inertia.unknown;
  evaluate_known(row.velocity, known, dt, known_);
  for (std::size_t i = 0; i < size; ++i) end.v[i] = known_[i] / dt;
  const double time = start.time + dt;
  end.time = time;
  model_.set_prescribed(time, end.u.data(), end.v.data(), nullptr);
  if (!balance_.solve({end.u.data(), time, &start.histories, &memories_, end.v.data()}, end.a)) {
    reason = "in an explicit step a gap closes, an element inverts or a number overflows";
    return false;
  }
  for (std::size_t i = 0; i < size; ++i) end.v[i] = start.v[i] + dt / 2 * (start.a[i] + end.a[i]);
  model_.set_prescribed(time, nullptr, end.v.data(), nullptr);
  if (has_external_) balance_.record_forces(end);
  return true;
}

double Integrator::stable_step(double wanted) {
  return stable_step_ ? (*stable_step_)(states_.front(), wanted) : wanted;
}

StepResult Integrator::step(double dt) {
  StepResult result = attempt(dt);
  if (result.converged) accept();
  return result;
}

StepResult Integrator::attempt(double dt) {
  const long linear_before = linear_solver_->statistics().iterations;
  attempted_dt_ = 0;
  StepResult result = advance(dt);
  if (result.converged) attempted_dt_ = dt;
  result.linear_iterations = linear_solver_->statistics().iterations - linear_before;
  return result;
}

/// Makes room for what terms keep: at the first step, and after an interaction was added.
void Integrator::follow_slots() {
  TermHistories& histories = states_.front().histories;
  if (histories.size() < model_.slots()) histories.extend(model_.create_histories());
  if (slots_ == model_.slots()) return;
  memories_ = model_.create_memories();
  slots_ = model_.slots();
}

StepResult Integrator::advance(double dt) {
  StepResult result;
  follow_couplings();
  follow_slots();
  model_.begin_step({known_states(states_, 1).front(), dt, &states_.front().histories}, memories_);
  in_step_ = true;
  if (needs_acceleration_ && !know_acceleration()) {
    result.reason = "the acceleration cannot be solved for";
    return result;
  }
  for (const Stage& stage : table_.stages)
    if (!driving_is_defined(stage, dt, result.reason)) return result;
  if (is_explicit(table_) && !take_explicit_step(dt, result.reason)) return result;
  for (std::size_t stage = 0; stage < solver_of_.size(); ++stage) {
    solver(stage).problem.arm(stage, states_, dt, memories_);
    std::vector<double> u = std::move(states_[stage + 1].u);
    const NewtonResult newton = solve_stage(stage, dt, u);
    result.newton_iterations += newton.iterations;
    if (!newton.converged) {
      result.ran_out = newton.ran_out;
      result.reason = is_static(table_) ? no_equilibrium(model_, states_.front(), dt, newton.reason) : newton.reason;
      states_[stage + 1].u = std::move(u);
      return result;
    }
    close_stage(stage, dt, std::move(u));
  }
  // The forces at quadrature points do not notice a node that has crossed an obstacle, nor a point that has jumped
  // through it.
  Segment whole = way();
  whole.length = dt;
  const std::string crossed = crossing(model_, whole);
  result.crossed = !crossed.empty();
  if (result.crossed) result.reason = crossed + "; allow Maximum Cuts, or use shorter steps or smaller faces";
  result.converged = !result.crossed;
  return result;
}

void Integrator::accept() {
  if (attempted_dt_ == 0) throw std::logic_error("there is no attempted step to accept");
  const double dt = std::exchange(attempted_dt_, 0.0);
  State& start = states_.front();
  // A restart interpolates tied nodes, too, and must find the same bits.
  for (std::vector<double>* const array : {&states_.back().u, &states_.back().v, &states_.back().a})
    if (!array->empty()) model_.space().interpolate_tied(array->data());
  // Before the terms accept: the force of the step is that of the history at its start.
  const double moved = has_moved_obstacles(model_) ? work_of_obstacles(model_, table_, states_, dt, memories_) : 0;
  const ModelWork work =
      model_.accept({known_states(states_, states_.size()), &table_.work, dt, &memories_}, start.histories);
  for (std::size_t i = 0; i < work.dissipated.size(); ++i) {
    dissipated_ += work.dissipated[i];
    dissipations_[i] += work.dissipated[i];
  }
  if (has_external_) external_work_ += work_of_external_forces(model_, table_, states_, dt);
  if (has_springs(model_)) external_work_ += work.driven;
  external_work_ += moved;
  look_back(dt);
  if (judged_) {
    previous_.v = states_.front().v;
    previous_.known = true;
  }
  previous_.dt = dt;
  if (!model_.rigid_bodies().empty())
    begin_body_steps(model_, table_.closing == Closing::Kinematic, states_.back(), {&previous_u_, &earlier_u_});
  // Compensated sum (Kahan), so that a million steps end at the right time.
  const double increment = dt - time_carry_;
  const double next = start.time + increment;
  time_carry_ = (next - start.time) - increment;
  TermHistories histories = std::move(start.histories);
  std::swap(states_.front(), states_.back());
  states_.front().time = next;
  states_.front().histories = std::move(histories);
  in_step_ = false;
  acceleration_known_ = table_.closing != Closing::Collocate;
}

double Integrator::error() {
  check_attempt();
  judged_ = true;
  if (!previous_.known && states_.size() == 2 && !know_acceleration()) return std::numeric_limits<double>::infinity();
  if (table_.closing == Closing::Collocate && states_.size() == 2 && earlier_dt_ > 0)
    return displacement_error(model_, table_, states_, attempted_dt_,
                              {previous_u_, earlier_u_, previous_.dt, earlier_dt_});
  return local_error(model_, table_, states_, attempted_dt_, previous_);
}

const State& Integrator::attempted() const {
  check_attempt();
  return states_.back();
}

double Integrator::gap_ratio() const {
  check_attempt();
  return TermSums(model_).gap_ratio(way());
}

double Integrator::edge_change() const {
  check_attempt();
  return ixos::edge_change(model_, states_.front().u.data(), states_.back().u.data());
}

double Integrator::unbalanced_work() const {
  check_attempt();
  const StageProblem& problem = solver(table_.stages.size() - 1).problem;
  return ixos::unbalanced_work(model_, problem.convergence_bound(newton_.tolerance), problem.force_scale(),
                               states_.front().u, states_.back().u);
}

void Integrator::set_interaction_points(int points) {
  if (table_.interaction_points == 0 || points == table_.interaction_points) return;
  table_.interaction_points = points;
  table_.stages.front().interaction = gauss_rule(points);
}

}  // namespace ixos
