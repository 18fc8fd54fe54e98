#include "model/carried_nodes.hpp"

#include <algorithm>

#include "rigid/cayley.hpp"

namespace ixos {

CarriedNodes::CarriedNodes(const LocalMesh& mesh, const RigidBody& body, std::size_t first,
                           const std::vector<int>& nodes)
    : body_(&body), first_(first), d_(static_cast<std::size_t>(mesh.dimension)) {
  for (const int number : nodes) {
    const auto n = static_cast<std::size_t>(number);
    Node node{n * d_, mesh.owns(number), mesh.is_derivative(n), {}};
    std::copy_n(&mesh.coordinates[n * d_], d_, node.arm.begin());
    if (!node.derivative) node.arm = sum(node.arm, body.centre(), -1);
    nodes_.push_back(node);
  }
}

/// Sets what each node has: what its arm makes of it, and the body's own.
template <class OfArm>
void CarriedNodes::set(const Triple& of_body, const OfArm& of_arm, double* to) const {
  for (const Node& node : nodes_) {
    Triple own = of_arm(node.arm);
    if (!node.derivative) own = sum(own, of_body);
    std::copy_n(own.begin(), d_, to + node.place);
  }
}

void CarriedNodes::place(double* u) const {
  const Turn turn = body_->turn(u + first_);
  set(
      RigidBody::triple(u + first_), [&](const Triple& arm) { return times(turn, arm); }, u);
}

void CarriedNodes::move(const double* u, double* v) const {
  const Turn turn = body_->turn(u + first_);
  const Triple velocity = RigidBody::triple(v + first_), spin = body_->spin_in_space(u + first_, v + first_);
  set(
      velocity, [&](const Triple& arm) { return cross(spin, turned(turn, arm)); }, v);
}

void CarriedNodes::accelerate(const double* u, const double* v, double* a) const {
  const Turn turn = body_->turn(u + first_);
  const Triple acceleration = RigidBody::triple(a + first_);
  const Triple spin = body_->spin_in_space(u + first_, v + first_);
  const Triple rate = turned(turn, body_->spin(a + first_));  // R s' is the rate of R s
  const auto of_arm = [&](const Triple& arm) {
    const Triple now = turned(turn, arm);
    return sum(cross(rate, now), cross(spin, cross(spin, now)));
  };
  set(acceleration, of_arm, a);
}

void CarriedNodes::direct(const double* u, double* direction) const {
  const Turn turn = body_->turn(u + first_);
  const Triple way = RigidBody::triple(direction + first_);
  const Triple turning = turned(turn, cayley_spin(body_->rotation(u + first_), body_->rotation(direction + first_)));
  set(
      way, [&](const Triple& arm) { return cross(turning, turned(turn, arm)); }, direction);
}

BodySight CarriedNodes::sight(const double* start, const double* u) const {
  const Turn end = body_->turn(u + first_);
  const Triple step = body_->rotation(u + first_);
  return start == nullptr ? BodySight::at(end, step, 1) : BodySight::between(body_->turn(start + first_), end, step);
}

void CarriedNodes::add_forces(const BodySight& sight, const double* f, double* sums) const {
  Triple force{}, moment{};
  for (const Node& node : nodes_) {
    if (!node.owned) continue;
    Triple own{};
    std::copy_n(f + node.place, d_, own.begin());
    if (!node.derivative) force = sum(force, own);
    moment = sum(moment, cross(arm(sight, node), own));
  }
  for (std::size_t i = 0; i < 3; ++i) sums[i] += force[i];
  if (!body_->turns()) return;
  const Triple turning = sight.to_rotation(moment);
  for (std::size_t i = 0; i < 3; ++i) sums[RigidBody::turning + i] += turning[i] / body_->length();
}

std::vector<CarriedNodes::Share> CarriedNodes::shares(const BodySight& sight) const {
  std::array<Triple, 3> spins{};
  for (std::size_t k = 0; k < 3 && body_->turns(); ++k) spins[k] = sight.turning(k);
  const Small<double, 3> rows = sight.matrix();
  std::vector<Share> all;
  for (const Node& node : nodes_) {
    Share share{node.place, node.owned, {}, {}};
    const Triple end = turned(sight.pose(), node.arm), mean = arm(sight, node);
    for (std::size_t k = 0; k < 3; ++k) {
      share.motions[k] = share.moments[k] = node.derivative ? Triple{} : basis_vector(k);
      if (!body_->turns()) continue;
      share.motions[3 + k] = scaled(1 / body_->length(), cross(spins[k], end));
      share.moments[3 + k] = scaled(1 / body_->length(), cross(rows[k], mean));
    }
    all.push_back(share);
  }
  return all;
}

Small<double, 6> CarriedNodes::turning(const BodySight& sight, const double* f) const {
  Small<double, 6> result{};
  if (!body_->turns()) return result;
  const double square = body_->length() * body_->length();
  for (std::size_t k = 0; k < 3; ++k) {
    const Triple spin = scaled(sight.is_mean() ? 0.5 : 1, sight.turning(k));
    Triple moment{}, change{};
    for (const Node& node : nodes_) {
      if (!node.owned) continue;
      Triple own{};
      std::copy_n(f + node.place, d_, own.begin());
      moment = sum(moment, cross(arm(sight, node), own));
      change = sum(change, cross(cross(spin, turned(sight.pose(), node.arm)), own));
    }
    const Triple whole = sum(sight.to_rotation_by(k, moment), sight.to_rotation(change));
    for (std::size_t i = 0; i < 3; ++i) result[3 + i][3 + k] = whole[i] / square;
  }
  return result;
}

}  // namespace ixos
