#include "time/acceleration.hpp"

#include "time/body_steps.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ixos {

Acceleration::Acceleration(const Model& model, std::shared_ptr<const LinearSolverFactory> linear_solver)
    : model_(model), mass_(model, std::move(linear_solver)), forces_(model) {}

bool Acceleration::balance(const Place& at) {
  const auto local = static_cast<std::size_t>(model_.space().local());
  const Rule rule = end_rule();
  const Segment here = segment_at(at);
  const BalancePoint point{here, here, &rule, &rule, nullptr, 1, Rates::State, at.v};
  const bool is_loaded = !model_.loads().empty();
  if (is_loaded) {
    load_.assign(local, 0.0);
    model_.loads().add_force(at.time, -1.0, load_.data());
  }
  const bool admissible = forces_.evaluate(point);
  balance_.resize(local);
  forces_.sum(point, is_loaded ? load_.data() : nullptr, balance_.data());
  std::copy(forces_.global_forces().begin(), forces_.global_forces().end(),
            balance_.begin() + model_.space().first_global());
  for (double& value : balance_) value = 0.0 - value;
  return model_.space().minimum(admissible ? 1 : 0) > 0;
}

bool Acceleration::solve(const Place& at, std::vector<double>& a) {
  const bool admissible = balance(at);
  const double time = at.time;
  a.assign(static_cast<std::size_t>(model_.space().local()), 0.0);
  const Mass* mass = model_.mass();
  if (!admissible || mass == nullptr) return admissible;
  if (!model_.rigid_bodies().empty()) {
    reactions_ = solve_body_accelerations(model_, at.u, at.v, balance_.data(), a.data());
    drive_bodies(model_, time, nullptr, nullptr, a.data());
  }
  if (!mass->is_lumped()) return solve_consistent(time, a);
  mass->divide(balance_.data(), a.data());
  double worst = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(model_.space().owned()); ++i)
    if (!std::isfinite(a[i])) worst = 1;
  model_.space().update_ghosts(a.data());
  model_.set_prescribed(time, nullptr, nullptr, a.data());
  return model_.space().maximum(worst) == 0;
}

bool Acceleration::solve_consistent(double time, std::vector<double>& a) {
  const auto owned = static_cast<std::size_t>(model_.space().owned());
  std::vector<double> rhs_values(balance_.begin(), balance_.begin() + static_cast<std::ptrdiff_t>(owned));
  if (!model_.constraints().empty()) {
    // M_ff a_f = ... - M_fp a_p, a_p the motion's.
    std::vector<double> product(owned);
    model_.set_prescribed(time, nullptr, nullptr, a.data());
    model_.mass()->multiply(a.data(), product.data());
    for (std::size_t i = 0; i < owned; ++i) rhs_values[i] -= product[i];
    model_.constraints().planes().project(rhs_values.data(), model_.mesh().owned_nodes);
    for (int dof : model_.constraints().dofs()) {
      const auto i = static_cast<std::size_t>(dof);
      if (i < owned) rhs_values[i] = a[i];
    }
  }
  return mass_.solve(std::move(rhs_values), a.data());
}

void Acceleration::record_driving_forces(State& state) const {
  if (model_.driven_globals().empty() || reactions_.empty()) return;
  const auto first = static_cast<std::size_t>(model_.space().first_global());
  state.load_on_globals.resize(reactions_.size(), 0.0);
  std::vector<double> inertia(reactions_.size(), 0.0);
  for (std::size_t i = 0; i < model_.rigid_bodies().size(); ++i)
    model_.rigid_bodies()[i].add_inertia(1, &state.a[model_.first_number(i)], &inertia[RigidBodies::first(i)]);
  for (const DrivenGlobal& driven : model_.driven_globals())
    state.load_on_globals[driven.place - first] += inertia[driven.place - first] - reactions_[driven.place - first];
}

void Acceleration::record_forces(State& state) const {
  const auto owned = static_cast<std::size_t>(model_.space().owned());
  if (!model_.loads().empty()) {
    state.load.assign(state.u.size(), 0.0);
    model_.loads().add_force(state.time, 1.0, state.load.data());
    state.load_on_globals.assign(state.load.begin() + model_.space().first_global(), state.load.end());
    state.load.resize(owned);
  }
  record_driving_forces(state);
  if (model_.constraints().empty()) return;
  std::vector<double> inertia(owned, 0.0);
  if (model_.mass() != nullptr) model_.mass()->multiply(state.a.data(), inertia.data());
  state.reaction.assign(owned, 0.0);
  for (int dof : model_.constraints().dofs()) {
    const auto i = static_cast<std::size_t>(dof);
    if (i < owned) state.reaction[i] = inertia[i] - balance_[i];
  }
  if (model_.constraints().planes().empty()) return;
  for (std::size_t i = 0; i < owned; ++i) inertia[i] -= balance_[i];
  model_.constraints().planes().add_across(1, inertia.data(), state.reaction.data(), model_.mesh().owned_nodes);
}

}  // namespace ixos
