#include "time/body_stage.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "rigid/cayley.hpp"

namespace ixos {

BodyStage::BodyStage(const Model& model)
    : model_(model),
      first_(static_cast<std::size_t>(model.space().first_global())),
      has_inertia_(model.mass() != nullptr),
      velocity_(static_cast<std::size_t>(model.rigid_bodies().numbers())),
      acceleration_(velocity_.size()),
      start_spin_(model.rigid_bodies().size()) {
  const LocalMesh& mesh = model.mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  for (const RigidBody& body : model.rigid_bodies())
    for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.owned_nodes) && body.turns(); ++node) {
      Triple arm{};
      for (std::size_t i = 0; i < d && !mesh.is_derivative(node); ++i)
        arm[i] = mesh.coordinates[node * d + i] - body.centre()[i];
      reach_ = std::max(reach_, std::sqrt(dot(arm, arm)) / body.length());
    }
  reach_ = model.space().maximum(reach_);
}

void BodyStage::arm(const Table& table, std::size_t stage, const std::vector<KnownState>& known, double dt) {
  stage_ = &table.stages[stage];
  momentum_ = table.closing == Closing::Collocate;
  dt_ = dt;
  start_share_ = stage_->elastic.kept_weight;
  if (!has_inertia_) return;
  std::vector<KnownState> numbers(known);
  for (KnownState& state : numbers)
    for (const double** const array : {&state.u, &state.v, &state.a})
      if (*array != nullptr) *array += first_;
  evaluate_known(stage_->velocity, numbers, dt, velocity_);
  if (!momentum_) evaluate_known(stage_->acceleration, numbers, dt, acceleration_);
  for (std::size_t i = 0; i < start_spin_.size(); ++i)
    start_spin_[i] = model_.rigid_bodies()[i].spin(numbers[0].v + RigidBodies::first(i));
}

/// Returns the force on w beyond J times the bracket.
template <class T>
std::array<T, 3> BodyStage::turning(std::size_t number, const std::array<T, 3>& w) const {
  const RigidBody& body = model_.rigid_bodies()[number];
  const std::size_t first = RigidBodies::first(number) + RigidBody::turning;
  const auto from_row = [&](const Row& row, const std::vector<double>& known, double unit) {
    std::array<T, 3> result;
    for (std::size_t i = 0; i < 3; ++i)
      result[i] = (row.unknown * w[i] + known[first + i] / body.length()) * (1 / unit);
    return result;
  };
  const std::array<T, 3> rate = from_row(stage_->velocity, velocity_, dt_);
  std::array<T, 3> start;
  for (std::size_t i = 0; i < 3; ++i) start[i] = start_spin_[number][i];
  std::array<T, 3> result;
  if (momentum_) {
    const Small<T, 3> turn = cayley_turn(w);
    const std::array<T, 3> at_end = body.times_inertia(rate), at_start = body.times_inertia(start);
    const std::array<T, 3> forward = times(turn, at_end), back = transposed_times(turn, at_start);
    std::array<T, 3> mean;
    for (std::size_t i = 0; i < 3; ++i) mean[i] = 0.5 * (at_end[i] + 0.5 * forward[i] + at_start[i] + 0.5 * back[i]);
    result = cross(w, mean);
    for (T& value : result) value *= 1 / dt_;
    return result;
  }
  const std::array<T, 3> acceleration = from_row(stage_->acceleration, acceleration_, dt_ * dt_);
  const std::array<T, 3> spin = cayley_spin(w, rate);
  const std::array<T, 3> inertia = body.times_inertia(cayley_spin_rate(w, rate, acceleration));
  const std::array<T, 3> gyration = cross(spin, body.times_inertia(spin));
  std::array<T, 3> moment;
  for (std::size_t i = 0; i < 3; ++i) moment[i] = inertia[i] + gyration[i];
  const std::array<T, 3> whole = cayley_force(w, moment), linear = body.times_inertia(acceleration);
  const std::array<T, 3> at_start = cross(start, body.times_inertia(start));
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = (1 - start_share_) * (whole[i] - linear[i]) + start_share_ * at_start[i];
  return result;
}

void BodyStage::add_inertia(const double* u, const double* bracket, double* forces) const {
  if (!has_inertia_) return;
  for (std::size_t i = 0; i < start_spin_.size(); ++i) {
    const RigidBody& body = model_.rigid_bodies()[i];
    const std::size_t first = RigidBodies::first(i);
    body.add_inertia(1 / (dt_ * dt_), bracket + first_ + first, forces + first);
    if (!body.turns()) continue;
    const Triple more = turning(i, body.rotation(u + first_ + first));
    for (std::size_t k = 0; k < 3; ++k) forces[first + RigidBody::turning + k] += more[k] / body.length();
  }
}

template <class Visit>
void BodyStage::for_each_turning(const Visit& visit) const {
  for (std::size_t i = 0; i < model_.rigid_bodies().size() && !momentum_; ++i)
    if (const RigidBody& body = model_.rigid_bodies()[i]; body.turns()) visit(body, RigidBodies::first(i));
}

void BodyStage::add_moments(const double* u, const double* load, double* forces) const {
  for_each_turning([&](const RigidBody& body, std::size_t first) {
    const Triple w = body.rotation(u + first_ + first);
    const double quarter = dot(w, w) / 4;
    for (std::size_t k = first + RigidBody::turning; k < first + RigidBody::attitude; ++k)
      forces[k] += load[first_ + k] * quarter / (1 + quarter);
  });
}

void BodyStage::add_moments(const double* u, const double* load, Border& border) const {
  for_each_turning([&](const RigidBody& body, std::size_t first) {
    const Triple w = body.rotation(u + first_ + first);
    const double sum = 1 + dot(w, w) / 4;
    for (std::size_t k = 0; k < 3; ++k)
      if (const std::size_t place = first + RigidBody::turning + k; border.has(place))
        border.entry(place, place) += load[first_ + place] * w[k] / (2 * sum * sum * body.length());
  });
}

double BodyStage::moment_potential(const double* u, const double* load) const {
  double sum = 0;
  for_each_turning([&](const RigidBody& body, std::size_t first) {
    const Triple w = body.rotation(u + first_ + first);
    for (std::size_t k = 0; k < 3; ++k)
      sum += load[first_ + first + RigidBody::turning + k] * body.length() * (w[k] - 2 * std::atan(w[k] / 2));
  });
  return sum;
}

double BodyStage::square_of_inertia(const double* x) const {
  double square = 0;
  for (std::size_t i = 0; i < start_spin_.size(); ++i) {
    std::array<double, RigidBody::numbers> force{};
    model_.rigid_bodies()[i].add_inertia(1, x + first_ + RigidBodies::first(i), force.data());
    for (const double value : force) square += value * value;
  }
  return square;
}

void BodyStage::add_inertia(const double* u, Border& border) const {
  if (!has_inertia_) return;
  const double factor = stage_->inertia.unknown / (dt_ * dt_);
  constexpr double tiny = 1e-30;  // of a complex step, whose error is its square
  for (std::size_t i = 0; i < start_spin_.size(); ++i) {
    const RigidBody& body = model_.rigid_bodies()[i];
    const std::size_t first = RigidBodies::first(i);
    for (const std::size_t k : body.free()) {
      std::array<double, RigidBody::numbers> unit{}, force{};
      unit[k] = 1;
      body.add_inertia(factor, unit.data(), force.data());
      if (k >= RigidBody::turning) {
        const Triple w = body.rotation(u + first_ + first);
        std::array<std::complex<double>, 3> moved{w[0], w[1], w[2]};
        moved[k - RigidBody::turning] += std::complex<double>(0, tiny);
        const std::array<std::complex<double>, 3> more = turning(i, moved);
        const double square = body.length() * body.length();
        for (std::size_t j = 0; j < 3; ++j) force[RigidBody::turning + j] += more[j].imag() / tiny / square;
      }
      for (const std::size_t j : body.free()) border.entry(first + j, first + k) += force[j];
    }
  }
}

}  // namespace ixos
