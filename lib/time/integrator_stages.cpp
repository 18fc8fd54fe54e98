// The solution of a step's stages: predictors, Newton's method, and the state at the stage's end.
#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <utility>

#include "fem/row_on_states.hpp"
#include "time/integrator.hpp"

namespace ixos {
namespace {

void copy_owned(const std::vector<double>& local, Vector& owned) {
  const auto view = owned.getLocalViewHost(Tpetra::Access::OverwriteAll);
  std::copy_n(local.data(), view.extent(0), view.data());
}

}  // namespace

void Integrator::predict(Predictor predictor, std::size_t stage, double dt, std::vector<double>& guess) const {
  const State& last = states_[stage];
  const double start = stage == 0 ? 0.0 : table_.stages[stage - 1].end;
  const double h = (table_.stages[stage].end - start) * dt;
  guess = last.u;
  if (predictor == Predictor::LastDisplacement) return;
  if (predictor == Predictor::Extrapolation) {
    if (previous_.dt == 0) return;
    const State& first = states_.front();
    const double ratio = h / previous_.dt;
    for (std::size_t i = 0; i < guess.size(); ++i) guess[i] += ratio * (first.u[i] - previous_u_[i]);
  } else {
    for (std::size_t i = 0; i < guess.size(); ++i) guess[i] += h * last.v[i];
  }
  if (predictor == Predictor::ConstantAcceleration || predictor == Predictor::Newmark) {
    const double factor = predictor == Predictor::Newmark ? h * h / 4 : h * h / 2;
    for (std::size_t i = 0; i < guess.size(); ++i) guess[i] += factor * last.a[i];
  }
  solver(stage).problem.clip(last.u, guess);
}

NewtonResult Integrator::solve_stage(std::size_t stage, double dt, std::vector<double>& u) {
  const auto solve_from = [&](Predictor predictor) {
    predict(predictor, stage, dt, u);
    copy_owned(u, *unknown_);
    return solver(stage).newton.solve(*unknown_);
  };
  NewtonResult result = solve_from(table_.predictor);
  const bool same_guess = table_.predictor == Predictor::LastDisplacement ||
                          (table_.predictor == Predictor::Extrapolation && previous_.dt == 0);
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
  Table other = table_;
  other.stages[stage].elastic = other.stages[stage].nearby[0];
  other.stages[stage].interaction = other.stages[stage].nearby[1];
  StageSolver nearby(*this, other, false);
  nearby.problem.arm(stage, states_, time_, dt);
  predict(Predictor::LastDisplacement, stage, dt, u);
  copy_owned(u, *unknown_);
  NewtonResult result = nearby.newton.solve(*unknown_);
  if (!result.converged) return result;
  const int spent = result.iterations;
  if (model_.has_rates()) solver(stage).problem.arm(stage, states_, time_, dt);  // terms know the last one armed only
  result = solver(stage).newton.solve(*unknown_);
  result.iterations += spent;
  return result;
}

void Integrator::close_stage(std::size_t stage, double dt, std::vector<double>&& u) {
  const Stage& row = table_.stages[stage];
  State& end = states_[stage + 1];
  const std::vector<KnownState> known = known_states(states_, stage + 1);
  const auto derive = [&](const Row& form, double scale, std::vector<double>& result) {
    known_.resize(u.size());
    result.resize(u.size());
    evaluate_known(form, known, dt, known_);
    evaluate(form.unknown, u.data(), known[0].u, known_, result);
    for (double& value : result) value /= scale;
  };
  derive(row.velocity, dt, end.v);
  if (table_.closing == Closing::Kinematic) {
    derive(row.acceleration, dt * dt, end.a);
    if (has_exact_rates(table_))
      model_.constraints().set(solver(stage).problem.time(), nullptr, end.v.data(), end.a.data());
  }
  end.u = std::move(u);
  solver(stage).problem.record_forces(end);
}

}  // namespace ixos
