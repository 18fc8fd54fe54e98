// The solution of a step's stages: predictors, Newton's method, and the state at the stage's end.
#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <utility>

#include "rule/row_on_states.hpp"
#include "time/body_steps.hpp"
#include "time/guess_error.hpp"
#include "time/integrator.hpp"

namespace ixos {

/// Returns the predictor itself, or the one to use in its place.
Predictor Integrator::usable(Predictor predictor) const {
  if (predictor == Predictor::Nearest) return nearest_;
  if (predictor == Predictor::Quadratic && earlier_dt_ == 0) predictor = Predictor::Extrapolation;
  return predictor == Predictor::Extrapolation && previous_.dt == 0 ? Predictor::LastDisplacement : predictor;
}

/// Sets `guess` to the usable predictor's displacement at the time h after the latest state before the stage's end.
void Integrator::look_ahead(Predictor predictor, std::size_t stage, double h, std::vector<double>& guess) const {
  const State& last = states_[stage];
  guess = last.u;
  if (predictor == Predictor::LastDisplacement) return;
  if (predictor == Predictor::Extrapolation || predictor == Predictor::Quadratic) {
    // Newton's divided differences.
    const State& first = states_.front();
    const double rate = h / previous_.dt;
    for (std::size_t i = 0; i < guess.size(); ++i) guess[i] += rate * (first.u[i] - previous_u_[i]);
    if (predictor == Predictor::Extrapolation) return;
    const double bend = h * (h + previous_.dt) / (previous_.dt + earlier_dt_);
    for (std::size_t i = 0; i < guess.size(); ++i)
      guess[i] +=
          bend * ((first.u[i] - previous_u_[i]) / previous_.dt - (previous_u_[i] - earlier_u_[i]) / earlier_dt_);
    return;
  }
  for (std::size_t i = 0; i < guess.size(); ++i) guess[i] += h * last.v[i];
  if (predictor == Predictor::ConstantVelocity) return;
  const double factor = predictor == Predictor::Newmark ? h * h / 4 : h * h / 2;
  for (std::size_t i = 0; i < guess.size(); ++i) guess[i] += factor * last.a[i];
}

void Integrator::predict(Predictor predictor, std::size_t stage, double dt, std::vector<double>& guess) const {
  const double start = stage == 0 ? 0.0 : table_.stages[stage - 1].end;
  predictor = usable(predictor);
  look_ahead(predictor, stage, (table_.stages[stage].end - start) * dt, guess);
  const StageProblem& problem = solver(stage).problem;
  const std::vector<double>& last = states_[stage].u;
  keep_attitudes(model_, last, guess);
  drive_bodies(model_, problem.time(), guess.data(), nullptr, nullptr);
  std::vector<double> driven;  // obstacles are where the guess meets them
  if (!model_.driven_globals().empty()) {
    driven = last;
    drive_bodies(model_, problem.time(), driven.data(), nullptr, nullptr);
  }
  if (predictor != Predictor::LastDisplacement) problem.clip(driven.empty() ? last : driven, guess);
  model_.carry(guess.data());
  // Extrapolation would let the rounding across planes grow.
  model_.constraints().planes().project(guess.data(), model_.mesh().nodes());
}

/// Keeps what the next steps' predictors need of the step of length dt that is to be accepted.
void Integrator::look_back(double dt) {
  const bool nearest = table_.predictor == Predictor::Nearest;
  if (nearest) {
    // Where the last displacement is about as near as another guess, Newton's first iteration makes more of it.
    double least = 0;
    nearest_ = Predictor::LastDisplacement;
    for (Predictor candidate :
         {Predictor::LastDisplacement, Predictor::ConstantVelocity, Predictor::Extrapolation, Predictor::Quadratic}) {
      if (usable(candidate) != candidate) continue;
      look_ahead(candidate, 0, dt, known_);
      const double error = model_.space().maximum(guess_error(model_, known_, states_.back().u));
      if (candidate != Predictor::LastDisplacement && !(error < least)) continue;
      least = candidate == Predictor::LastDisplacement ? 0.7 * error : error;
      nearest_ = candidate;
    }
  }
  const bool both = nearest || table_.predictor == Predictor::Quadratic || judged_;
  if (both) {
    std::swap(earlier_u_, previous_u_);
    // A rank without nodes has empty arrays, too.
    earlier_dt_ = model_.space().maximum(earlier_u_.empty() ? 0.0 : 1.0) > 0 ? previous_.dt : 0;
  }
  if (both || table_.predictor == Predictor::Extrapolation) previous_u_ = states_.front().u;
}

NewtonResult Integrator::solve_stage(std::size_t stage, double dt, std::vector<double>& u) {
  const auto solve_from = [&](Predictor predictor) {
    predict(predictor, stage, dt, u);
    model_.space().take(u.data(), *unknown_);
    return solver(stage).newton.solve(*unknown_);
  };
  NewtonResult result = solve_from(table_.predictor);
  if (!result.converged && usable(table_.predictor) != Predictor::LastDisplacement) {
    const int spent = result.iterations;
    result = solve_from(Predictor::LastDisplacement);
    result.iterations += spent;
  }
  if (!result.converged && !table_.stages[stage].nearby.empty()) {
    const int spent = result.iterations;
    result = solve_from_nearby(stage, dt, u);
    result.iterations += spent;
  }
  if (result.converged) {
    model_.space().import(*unknown_, u.data());
    model_.carry(u.data());
  }
  return result;
}

NewtonResult Integrator::solve_from_nearby(std::size_t stage, double dt, std::vector<double>& u) {
  // Rare: the problem and its matrix live no longer than this.
  Table other = table_;
  other.stages[stage].elastic = other.stages[stage].nearby[0];
  other.stages[stage].interaction = other.stages[stage].nearby[1];
  StageSolver nearby(*this, other, false);
  nearby.problem.arm(stage, states_, dt, memories_);
  predict(Predictor::LastDisplacement, stage, dt, u);
  model_.space().take(u.data(), *unknown_);
  NewtonResult result = nearby.newton.solve(*unknown_);
  if (!result.converged) return result;
  const int spent = result.iterations;
  solver(stage).problem.arm(stage, states_, dt, memories_);  // memories have the stage that began last
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
    if (has_exact_rates(table_)) {
      const double time = solver(stage).problem.time();
      model_.set_prescribed(time, nullptr, end.v.data(), end.a.data());
      drive_bodies(model_, time, nullptr, end.v.data(), end.a.data());
    }
  }
  end.u = std::move(u);
  end.time = solver(stage).problem.time();
  solver(stage).problem.record_forces(end);
}

}  // namespace ixos
