#include "time/body_steps.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "rigid/cayley.hpp"

namespace ixos {
namespace {

using Triple = std::array<double, 3>;

/// Calls visit(body, the place of its first number in local arrays).
template <class Visit>
void for_each_body(const Model& model, const Visit& visit) {
  const RigidBodies& bodies = model.rigid_bodies();
  for (std::size_t i = 0; i < bodies.size(); ++i) visit(bodies[i], model.first_number(i));
}

void set_triple(const Triple& values, double factor, double* to) {
  for (std::size_t i = 0; i < 3; ++i) to[i] = factor * values[i];
}

}  // namespace

void keep_attitudes(const Model& model, const std::vector<double>& start, std::vector<double>& guess) {
  for_each_body(model, [&](const RigidBody&, std::size_t first) {
    for (std::size_t i = RigidBody::attitude; i < RigidBody::numbers; ++i) guess[first + i] = start[first + i];
  });
}

void drive_bodies(const Model& model, double time, double* u, double* v, double* a) {
  for (const DrivenGlobal& driven : model.driven_globals()) {
    const TimeValue value = driven.motion->at(time);
    if (u != nullptr) u[driven.place] = value.value;
    if (v != nullptr) v[driven.place] = value.rate;
    if (a != nullptr) a[driven.place] = value.acceleration;
  }
}

bool bodies_are_finite(const Model& model, double time) {
  return std::all_of(model.driven_globals().begin(), model.driven_globals().end(), [time](const DrivenGlobal& driven) {
    const TimeValue value = driven.motion->at(time);
    return std::isfinite(value.value) && std::isfinite(value.rate) && std::isfinite(value.acceleration);
  });
}

void carry_nodes(const Model& model, double* u, double* v) {
  model.carry(u);
  if (model.carried_nodes().empty() || model.mass() == nullptr) return;
  for (const CarriedNodes& nodes : model.carried_nodes()) nodes.move(u, v);
  model.space().interpolate_tied(v);
}

void begin_body_steps(const Model& model, bool rates, State& end, const std::vector<std::vector<double>*>& past) {
  for_each_body(model, [&](const RigidBody& body, std::size_t first) {
    if (!body.turns()) return;
    const std::size_t turning = first + RigidBody::turning;
    const Triple w = body.rotation(&end.u[first]), rate = body.spin(&end.v[first]);
    for (std::vector<double>* const u : past)
      for (std::size_t i = 0; i < 3 && !u->empty(); ++i) (*u)[turning + i] -= end.u[turning + i];
    if (rates) {
      const Triple acceleration = body.spin(&end.a[first]);
      set_triple(cayley_spin(w, rate), body.length(), &end.v[turning]);
      set_triple(cayley_spin_rate(w, rate, acceleration), body.length(), &end.a[turning]);
    }
    body.begin_step(&end.u[first]);
  });
}

std::vector<double> solve_body_accelerations(const Model& model, const double* u, const double* v, const double* forces,
                                             double* a) {
  const auto count = static_cast<std::size_t>(model.rigid_bodies().numbers());
  const auto start = static_cast<std::size_t>(model.space().first_global());
  std::vector<double> sums(forces + start, forces + start + count);
  model.space().sum(sums.data(), static_cast<int>(count));
  for_each_body(model, [&](const RigidBody& body, std::size_t first) {
    double* const own = &sums[first - start];
    if (body.turns()) {
      const Triple spin = body.spin(v + first), w = body.rotation(u + first);
      const Triple force = scaled(body.length(), RigidBody::triple(own + RigidBody::turning));
      const Triple moment = sum(cayley_moment(w, force), cross(spin, body.times_inertia(spin)), -1);
      set_triple(moment, 1 / body.length(), own + RigidBody::turning);
    }
    body.solve_inertia(own, a + first);
  });
  return sums;
}

}  // namespace ixos
