#include "time/work.hpp"

#include <cmath>
#include <cstddef>
#include <limits>

#include "base/dot.hpp"
#include "model/term_sums.hpp"

namespace ixos {
namespace {

using Array = std::vector<double>;

Array difference(const Array& a, const Array& b) {
  Array result(a);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] -= b[i];
  return result;
}

/// Returns the product over owned entries, and over globals on the first rank, with the state's load and reaction, if
/// there are any.
double with_external(const Model& model, const Array& x, const State& state) {
  double sum = dot(x, state.load, state.load.size()) + dot(x, state.reaction, state.reaction.size());
  for (const int dof : model.constraints().entrusted())  // a body holds them: no external force
    if (const auto i = static_cast<std::size_t>(dof); i < state.reaction.size()) sum -= x[i] * state.reaction[i];
  if (model.space().comm()->getRank() == 0)
    sum += dot(x.data() + model.space().first_global(), state.load_on_globals.data(), state.load_on_globals.size());
  return sum;
}

/// Returns d . M dv + du . M e/dt on driven degrees of freedom.
double exact_rate_work(const Model& model, const State& start, const State& end, const Array& du, double dt) {
  const auto owned = static_cast<std::size_t>(model.space().owned());
  Array product(owned), e(du.size(), 0.0);
  model.mass()->multiply(difference(end.v, start.v).data(), product.data());
  double sum = 0;
  for (int dof : model.constraints().prescribed()) {
    const auto i = static_cast<std::size_t>(dof);
    e[i] = end.v[i] - start.v[i] - dt * (start.a[i] + end.a[i]) / 2;
    if (i < owned) sum += ((start.v[i] + end.v[i]) / 2 - du[i] / dt) * product[i];
  }
  model.mass()->multiply(e.data(), product.data());
  sum += dot(du, product, owned) / dt;
  if (model.space().comm()->getRank() > 0) return sum;
  for (const DrivenGlobal& driven : model.driven_globals()) {
    const std::size_t i = driven.place, first = static_cast<std::size_t>(model.space().first_global());
    const double mass = model.rigid_bodies()[(i - first) / RigidBody::numbers].mass();
    const double change = end.v[i] - start.v[i], error = change - dt * (start.a[i] + end.a[i]) / 2;
    sum += mass * (((start.v[i] + end.v[i]) / 2 - du[i] / dt) * change + du[i] * error / dt);
  }
  return sum;
}

}  // namespace

double work_of_external_forces(const Model& model, const Table& table, const std::vector<State>& states, double dt) {
  const State& start = states.front();
  const State& end = states.back();
  const Array du = difference(end.u, start.u);
  double sum = 0;
  if (table.work.form == WorkSum::Form::Increment) {
    sum = with_external(model, du, end);
  } else if (table.work.form == WorkSum::Form::EndMean) {
    sum = (with_external(model, du, start) + with_external(model, du, end)) / 2;
    if (model.mass() != nullptr && (model.constraints().driven() || !model.driven_globals().empty()))
      sum += exact_rate_work(model, start, end, du, dt);
  } else {
    for (std::size_t i = 0; i < states.size(); ++i)
      sum += dt * table.work.weights[i] * with_external(model, states[i].v, states[i]);
  }
  model.space().sum(&sum, 1);
  return sum;
}

double unbalanced_work(const Model& model, double residual, double force, const std::vector<double>& u0,
                       const std::vector<double>& u1) {
  const auto owned = static_cast<std::size_t>(model.space().owned());
  double squares[2] = {0, dot(u1, u1, owned)};
  for (std::size_t i = 0; i < owned; ++i) squares[0] += (u1[i] - u0[i]) * (u1[i] - u0[i]);
  model.space().sum(squares, 2);
  return residual * std::sqrt(squares[0]) + 16 * std::numeric_limits<double>::epsilon() * force * std::sqrt(squares[1]);
}

double work_of_obstacles(const Model& model, const Table& table, const std::vector<State>& states, double dt,
                         const StepMemories& step) {
  const TermSums terms(model);
  const State& start = states.front();
  const TermHistories* const kept = &start.histories;
  if (table.work.form == WorkSum::Form::Increment) {
    const Rule& rule = table.stages.back().interaction;
    Array path_velocity;
    if (rule.uses_velocity()) path_velocity = start.v;
    for (double& value : path_velocity) value *= dt;
    return terms.obstacle_work({start.u.data(), path_velocity.empty() ? nullptr : path_velocity.data(),
                                states.back().u.data(), start.time, dt, kept, &step},
                               rule);
  }
  double sum = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const bool at_end = i == 0 || i + 1 == states.size();
    const double weight = table.work.form == WorkSum::Form::Stages ? table.work.weights[i] : at_end ? 0.5 : 0.0;
    const double when = i == 0 ? 0.0 : table.stages[i - 1].end;
    if (weight != 0)
      sum += terms.obstacle_work({nullptr, nullptr, states[i].u.data(), start.time, dt, kept, &step},
                                 {{{weight, 0, 0, 1, when}}, 0});
  }
  return sum;
}

}  // namespace ixos
