#include "time/acceleration.hpp"

#include "base/dense_solve.hpp"
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
  if (!model_.driven_globals().empty() && mass == nullptr) find_reactions(at);
  if (!admissible || mass == nullptr) return admissible;
  if (!model_.rigid_bodies().empty()) {
    reactions_ = solve_body_accelerations(model_, at.u, at.v, balance_.data(), a.data());
    drive_bodies(model_, time, nullptr, nullptr, a.data());
  }
  if (!model_.carried_nodes().empty()) return solve_with_grips(at, a);
  if (!mass->is_lumped()) return solve_consistent(time, a);
  mass->divide(balance_.data(), a.data());
  double worst = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(model_.space().owned()); ++i)
    if (!std::isfinite(a[i])) worst = 1;
  model_.space().update_ghosts(a.data());
  model_.set_prescribed(time, nullptr, nullptr, a.data());
  return model_.space().maximum(worst) == 0;
}

/// The accelerations of bodies and of the nodes that they carry depend on each other. The balance of the bodies is
/// linear in those of the bodies: one solve for each, and one with the solution.
bool Acceleration::solve_with_grips(const Place& at, std::vector<double>& a) {
  const std::vector<int>& free = model_.space().globals().free;
  const auto first = static_cast<std::size_t>(model_.space().first_global());
  const std::vector<double> of_bodies_alone = reactions_;
  bool solved = true;
  // Sets the accelerations for those of the bodies; returns what the balance of the bodies lacks.
  const auto lack = [&](const std::vector<double>& of_bodies) {
    std::fill(a.begin(), a.end(), 0.0);
    for (std::size_t k = 0; k < free.size(); ++k) a[first + static_cast<std::size_t>(free[k])] = of_bodies[k];
    drive_bodies(model_, at.time, nullptr, nullptr, a.data());
    for (const CarriedNodes& nodes : model_.carried_nodes()) nodes.accelerate(at.u, at.v, a.data());
    solved = solve_consistent(at.time, a) && solved;
    reactions_ = of_bodies_alone;
    grip_forces(at, a);
    std::vector<double> sums(reactions_.size(), 0.0);
    for (std::size_t i = 0; i < model_.rigid_bodies().size(); ++i)
      model_.rigid_bodies()[i].add_inertia(1, &a[model_.first_number(i)], &sums[RigidBodies::first(i)]);
    std::vector<double> result;
    result.reserve(free.size());
    for (const int k : free)
      result.push_back(sums[static_cast<std::size_t>(k)] - reactions_[static_cast<std::size_t>(k)]);
    return result;
  };
  const std::size_t n = free.size();
  std::vector<double> none(n, 0.0), matrix(n * n);
  std::vector<double> start = lack(none);
  for (std::size_t k = 0; k < n; ++k) {
    std::vector<double> unit(n, 0.0);
    unit[k] = 1;
    const std::vector<double> end = lack(unit);
    for (std::size_t i = 0; i < n; ++i) matrix[i * n + k] = end[i] - start[i];
  }
  for (double& value : start) value = -value;
  const std::vector<double> solution = dense_solve(matrix, start);
  if (solution.empty() && n > 0) return false;
  lack(solution);
  return solved;
}

/// Without inertia: what is left over of the balance of globals, grips included.
void Acceleration::find_reactions(const Place& at) {
  const auto first = static_cast<std::ptrdiff_t>(model_.space().first_global());
  reactions_.assign(balance_.begin() + first, balance_.end());
  model_.space().sum(reactions_.data(), static_cast<int>(reactions_.size()));
  grip_forces(at, {});
}

/// Subtracts the forces of carried nodes from the sums on globals; a: the accelerations, empty without inertia.
void Acceleration::grip_forces(const Place& at, const std::vector<double>& a) {
  if (model_.carried_nodes().empty()) return;
  const auto owned = static_cast<std::size_t>(model_.space().owned());
  const auto first = static_cast<std::size_t>(model_.space().first_global());
  std::vector<double> force(owned), sums(reactions_.size(), 0.0);
  if (!a.empty()) model_.mass()->multiply(a.data(), force.data());
  for (std::size_t i = 0; i < owned; ++i) force[i] -= balance_[i];
  for (const CarriedNodes& nodes : model_.carried_nodes())
    nodes.add_forces(nodes.sight(nullptr, at.u), force.data(), &sums[nodes.first() - first]);
  model_.space().sum(sums.data(), static_cast<int>(sums.size()));
  for (std::size_t i = 0; i < sums.size(); ++i) reactions_[i] -= sums[i];
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
