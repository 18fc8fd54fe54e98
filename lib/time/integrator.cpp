#include "time/integrator.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/error.hpp"
#include "time/row_on_states.hpp"
#include "time/work.hpp"

namespace ixos {
namespace {

/// Does some row use the acceleration of the step's start?
bool uses_acceleration(const Table& table) {
  for (const Stage& stage : table.stages)
    for (const Row* row : {&stage.velocity, &stage.inertia, &stage.damping})
      if (!row->known.empty() && row->known[0].a != 0) return true;
  return false;
}

void copy_owned(const std::vector<double>& local, Vector& owned) {
  const auto view = owned.getLocalViewHost(Tpetra::Access::OverwriteAll);
  std::copy_n(local.data(), view.extent(0), view.data());
}

}  // namespace

Integrator::Integrator(const Model& model, Table table, std::shared_ptr<const LinearSolverFactory> linear_solver,
                       const NewtonOptions& newton)
    : model_(model),
      table_(std::move(table)),
      linear_solver_(std::move(linear_solver)),
      needs_acceleration_(uses_acceleration(table_) || table_.predictor == Predictor::ConstantAcceleration ||
                          table_.predictor == Predictor::Newmark),
      newton_(newton),
      states_(table_.stages.size() + 1),
      unknown_(Teuchos::rcp(new Vector(model.space().owned_map()))) {
  check(table_);
  if (is_static(table_) != (model.mass() == nullptr))
    throw std::invalid_argument(
        "scheme \"" + table_.name +
        "\": " + (is_static(table_) ? "it has no inertia, but the model has" : "the model has no inertia"));
  has_external_ = model.space().maximum(model.loads().empty() && model.constraints().empty() ? 0 : 1) > 0;
  exact_rates_ = table_.closing == Closing::Kinematic && table_.driven_rates == DrivenRates::Exact;
  for (const Stage& stage : table_.stages) {
    problems_.push_back(std::make_unique<StageProblem>(model_, stage, exact_rates_));
    solvers_.push_back(std::make_unique<NewtonSolver>(*problems_.back(), *linear_solver_, newton));
  }
}

void Integrator::initialize(std::vector<double> u, std::vector<double> v, double time) {
  time_ = time;
  time_carry_ = 0;
  dissipated_ = 0;
  external_work_ = 0;
  previous_dt_ = 0;
  acceleration_known_ = false;
  State& start = states_.front();
  start = {std::move(u), std::move(v), {}, {}, {}};
  if (model_.mass() == nullptr) std::fill(start.v.begin(), start.v.end(), 0.0);
  model_.constraints().set(time, start.u.data(), start.v.data(), nullptr);
  std::vector<double> sum;
  if (needs_acceleration_ || table_.closing == Closing::Kinematic || has_external_)
    acceleration();
  else if (!balance(start.u, start.v, sum))
    throw InputError("a gap is not positive, or an element is inverted");
  if (has_external_) record_initial_forces();
}

const std::vector<double>& Integrator::acceleration() {
  State& state = states_.front();
  if (!acceleration_known_ && !solve_acceleration(state.u, state.v, state.a))
    throw InputError(
        "the acceleration cannot be solved for: a gap is not positive, an element is inverted, the mass "
        "matrix is singular, or the linear solver cannot solve with it");
  acceleration_known_ = true;
  return state.a;
}

bool Integrator::balance(const std::vector<double>& u, const std::vector<double>& v, std::vector<double>& sum) const {
  const auto owned = static_cast<std::size_t>(model_.space().owned());
  const Segment here{nullptr, nullptr, u.data()};
  std::vector<double> force(u.size());
  sum.assign(u.size(), 0.0);
  model_.loads().add_force(time_, 1.0, sum.data());
  bool admissible = model_.elastic_force(here, end_rule(), force.data());
  for (std::size_t i = 0; i < owned; ++i) sum[i] -= force[i];
  if (model_.has_interactions()) {
    admissible = model_.interaction_force(here, end_rule(), force.data()) && admissible;
    for (std::size_t i = 0; i < owned; ++i) sum[i] -= force[i];
  }
  if (model_.damping() != nullptr) model_.damping()->multiply_add(-1.0, v.data(), sum.data());
  return model_.space().minimum(admissible ? 1 : 0) > 0;
}

bool Integrator::solve_acceleration(const std::vector<double>& u, const std::vector<double>& v,
                                    std::vector<double>& a) {
  const auto owned = static_cast<std::size_t>(model_.space().owned());
  std::vector<double> sum;
  const bool admissible = balance(u, v, sum);
  a.assign(u.size(), 0.0);
  if (!admissible || model_.mass() == nullptr) return admissible;
  if (!model_.constraints().empty()) {
    // M_ff a_f = ... - M_fp a_p, a_p the motion's.
    std::vector<double> product(owned);
    model_.constraints().set(time_, nullptr, nullptr, a.data());
    model_.mass()->multiply(a.data(), product.data());
    for (std::size_t i = 0; i < owned; ++i) sum[i] -= product[i];
    for (int dof : model_.constraints().dofs()) sum[static_cast<std::size_t>(dof)] = a[static_cast<std::size_t>(dof)];
  }
  if (!mass_system_) {
    const auto matrix = model_.pattern().create_matrix(model_.space());
    double* values = matrix->getLocalMatrixHost().values.data();
    model_.mass()->add_to(1.0, values);
    model_.constrain_matrix(1.0, values);
    mass_system_ = std::make_unique<LinearSystem>(*linear_solver_, matrix);
  }
  Vector rhs(model_.space().owned_map());
  Vector solution(model_.space().owned_map());
  copy_owned(sum, rhs);
  if (!mass_system_->solve(rhs, solution) || !std::isfinite(solution.norm2())) return false;
  model_.space().import(solution, a.data());
  return true;
}

void Integrator::record_initial_forces() {
  const auto owned = static_cast<std::size_t>(model_.space().owned());
  State& start = states_.front();
  if (!model_.loads().empty()) {
    start.load.assign(start.u.size(), 0.0);
    model_.loads().add_force(time_, 1.0, start.load.data());
    start.load.resize(owned);
  }
  std::vector<double> sum, inertia(owned, 0.0);
  balance(start.u, start.v, sum);  // collective
  if (model_.constraints().empty()) return;
  if (model_.mass() != nullptr) model_.mass()->multiply(start.a.data(), inertia.data());
  start.reaction.assign(owned, 0.0);
  for (int dof : model_.constraints().dofs()) {
    const auto i = static_cast<std::size_t>(dof);
    if (i < owned) start.reaction[i] = inertia[i] - sum[i];
  }
}

void Integrator::predict(Predictor predictor, std::size_t stage, double dt, std::vector<double>& guess) const {
  const State& last = states_[stage];
  const double start = stage == 0 ? 0.0 : table_.stages[stage - 1].end;
  const double h = (table_.stages[stage].end - start) * dt;
  guess = last.u;
  if (predictor == Predictor::LastDisplacement) return;
  if (predictor == Predictor::Extrapolation) {
    if (previous_dt_ == 0) return;
    const State& first = states_.front();
    const double ratio = h / previous_dt_;
    for (std::size_t i = 0; i < guess.size(); ++i) guess[i] += ratio * (first.u[i] - previous_u_[i]);
  } else {
    for (std::size_t i = 0; i < guess.size(); ++i) guess[i] += h * last.v[i];
  }
  if (predictor == Predictor::ConstantAcceleration || predictor == Predictor::Newmark) {
    const double factor = predictor == Predictor::Newmark ? h * h / 4 : h * h / 2;
    for (std::size_t i = 0; i < guess.size(); ++i) guess[i] += factor * last.a[i];
  }
  problems_[stage]->clip(last.u, guess);
}

NewtonResult Integrator::solve_stage(std::size_t stage, double dt, std::vector<double>& u) {
  const auto solve_from = [&](Predictor predictor) {
    predict(predictor, stage, dt, u);
    copy_owned(u, *unknown_);
    return solvers_[stage]->solve(*unknown_);
  };
  NewtonResult result = solve_from(table_.predictor);
  const bool same_guess = table_.predictor == Predictor::LastDisplacement ||
                          (table_.predictor == Predictor::Extrapolation && previous_dt_ == 0);
  if (!result.converged && !same_guess) {
    const int spent = result.iterations;
    result = solve_from(Predictor::LastDisplacement);
    result.iterations += spent;
  }
  if (!result.converged && !table_.stages[stage].nearby.empty()) {
    const int spent = result.iterations;
    result = solve_from_nearby(stage, dt, u);
    result.iterations += spent;
  }
  if (result.converged) model_.space().import(*unknown_, u.data());
  return result;
}

NewtonResult Integrator::solve_from_nearby(std::size_t stage, double dt, std::vector<double>& u) {
  // Rare: the problem and its matrix live no longer than this.
  Stage other = table_.stages[stage];
  other.elastic = other.nearby[0];
  other.interaction = other.nearby[1];
  StageProblem problem(model_, other, exact_rates_);
  problem.arm(states_, time_, dt);
  predict(Predictor::LastDisplacement, stage, dt, u);
  copy_owned(u, *unknown_);
  NewtonResult result = NewtonSolver(problem, *linear_solver_, newton_).solve(*unknown_);
  if (!result.converged) return result;
  const int spent = result.iterations;
  result = solvers_[stage]->solve(*unknown_);
  result.iterations += spent;
  return result;
}

void Integrator::close_stage(std::size_t stage, double dt, std::vector<double>&& u) {
  const Stage& row = table_.stages[stage];
  State& end = states_[stage + 1];
  const auto derive = [&](const Row& form, double scale, std::vector<double>& result) {
    known_.resize(u.size());
    result.resize(u.size());
    evaluate_known(form, states_, dt, known_);
    evaluate(form, u, states_.front().u, known_, result);
    for (double& value : result) value /= scale;
  };
  derive(row.velocity, dt, end.v);
  if (table_.closing == Closing::Kinematic) {
    derive(row.acceleration, dt * dt, end.a);
    if (exact_rates_) model_.constraints().set(problems_[stage]->time(), nullptr, end.v.data(), end.a.data());
  }
  end.u = std::move(u);
  problems_[stage]->record_forces(end);
}

StepResult Integrator::step(double dt) {
  const long linear_before = linear_solver_->statistics().iterations;
  StepResult result = advance(dt);
  result.linear_iterations = linear_solver_->statistics().iterations - linear_before;
  return result;
}

StepResult Integrator::advance(double dt) {
  StepResult result;
  if (needs_acceleration_ && !acceleration_known_) {
    State& start = states_.front();
    if (!solve_acceleration(start.u, start.v, start.a)) {
      result.reason = "the acceleration cannot be solved for";
      return result;
    }
    acceleration_known_ = true;
  }
  for (std::size_t stage = 0; stage < problems_.size(); ++stage) {
    problems_[stage]->arm(states_, time_, dt);
    std::vector<double> u = std::move(states_[stage + 1].u);
    const NewtonResult newton = solve_stage(stage, dt, u);
    result.newton_iterations += newton.iterations;
    if (!newton.converged) {
      result.reason = newton.reason;
      states_[stage + 1].u = std::move(u);
      return result;
    }
    close_stage(stage, dt, std::move(u));
  }
  if (model_.damping() != nullptr) dissipated_ += work_of_damping(model_, table_, states_, dt);
  if (has_external_) external_work_ += work_of_external_forces(model_, table_, states_, dt);
  if (table_.predictor == Predictor::Extrapolation) {
    previous_u_ = states_.front().u;
    previous_dt_ = dt;
  }
  std::swap(states_.front(), states_.back());
  // Compensated (Kahan), so that a million steps end where they should.
  const double increment = dt - time_carry_;
  const double next = time_ + increment;
  time_carry_ = (next - time_) - increment;
  time_ = next;
  acceleration_known_ = table_.closing == Closing::Kinematic;
  result.converged = true;
  return result;
}

}  // namespace ixos
