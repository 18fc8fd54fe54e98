// The reaction of a grip.
#include "model/grips.hpp"
#include "model/nodal_moment.hpp"
#include "term/support/springs.hpp"

namespace ixos {
namespace {

/// Adds to f the forces of springs and dashpots on the nodes.
void add_support_force(const Grip& grip, double time, const std::vector<double>& u, const std::vector<double>& v,
                       std::vector<double>& f) {
  const auto add = [&](const DrivenEnds& ends, const std::vector<double>& to, const std::vector<double>& from) {
    for (std::size_t k = 0; k < ends.dofs.size(); ++k) {
      const auto i = static_cast<std::size_t>(ends.dofs[k]);
      f[i] += ends.coefficients[k] * (to[i] - from[i]);
    }
  };
  if (grip.springs != nullptr) add(grip.springs->ends(), places_of(grip.springs->ends(), time, u.size()), u);
  if (grip.dashpots != nullptr) add(grip.dashpots->ends(), rates_of(grip.dashpots->ends(), time, v.size()), v);
}

}  // namespace

GripReaction grip_reaction(const Model& model, const Grip& grip, double time, const std::vector<double>& u,
                           const std::vector<double>& v, const std::vector<double>& reactions) {
  const LocalMesh& mesh = model.mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  std::vector<double> supports;
  if (!grip.rigid) {
    supports.assign(u.size(), 0.0);
    add_support_force(grip, time, u, v, supports);
  }
  const std::vector<double>& forces = grip.rigid ? reactions : supports;
  std::array<double, 3> point = grip.motion.point_at(time);
  if (grip.carrier >= 0) {
    const auto body = static_cast<std::size_t>(grip.carrier);
    point = sum(model.rigid_bodies()[body].centre(), RigidBody::triple(&u[model.first_number(body)]));
  }
  std::vector<double> sums(6, 0.0);
  for (const int node : mesh.node_sets[grip.node_set]) {
    if (node >= mesh.owned_nodes) continue;
    std::array<double, 3> force{};
    for (std::size_t i = 0; i < d; ++i) {
      force[i] = forces[static_cast<std::size_t>(node) * d + i];
      if (!mesh.is_derivative(static_cast<std::size_t>(node))) sums[i] += force[i];
    }
    add_nodal_moment(mesh, static_cast<std::size_t>(node), u.data(), force, point, &sums[3]);
  }
  model.space().sum(sums.data(), 6);
  const auto middle = sums.begin() + 3;
  GripReaction result{{sums.begin(), sums.begin() + static_cast<std::ptrdiff_t>(d)}, {}};
  // The moments around a ring cancel.
  if (!mesh.axisymmetric) result.moment.assign(d == 2 ? middle + 2 : middle, sums.end());
  return result;
}

}  // namespace ixos
