#include "time/equilibrium.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/traits.hpp"

namespace ixos {
namespace {

/// Returns the sum of the magnitudes of nodal forces over all ranks. Collective.
double magnitude(const Model& model, const std::vector<double>& forces) {
  const LocalMesh& mesh = model.mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  double sum = 0;
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.owned_nodes) && !forces.empty(); ++node) {
    if (mesh.is_derivative(node)) continue;
    double square = 0;
    for (std::size_t i = 0; i < d; ++i) square += forces[node * d + i] * forces[node * d + i];
    sum += std::sqrt(square);
  }
  model.space().sum(&sum, 1);
  return sum;
}

}  // namespace

bool load_grows(const Model& model, const State& start, double dt) {
  // The forces by which springs are driven are loads to the model, but displacements to the user.
  if (has_springs(model)) return false;
  std::vector<double> change(static_cast<std::size_t>(model.space().local()), 0.0);
  model.loads().add_force(start.time + dt, 1, change.data());
  const double found = magnitude(model, start.load), next = magnitude(model, change);
  for (std::size_t i = 0; i < start.load.size(); ++i) change[i] -= start.load[i];
  return magnitude(model, change) > 1e-9 * std::max(found, next);
}

std::string no_equilibrium(const Model& model, const State& start, double dt, const std::string& detail) {
  const double time = start.time, found = magnitude(model, start.load);
  const bool grows = load_grows(model, start, dt);
  const bool driven = has_springs(model) || model.space().maximum(model.constraints().driven() ? 1 : 0) > 0;
  if (!grows && (driven || found == 0))
    return fmt::format("no equilibrium found beyond t = {:.6g} T0; use shorter steps, or a dynamic scheme: {}", time,
                       detail);
  return fmt::format(
      "no equilibrium found {} a load of {:.6g} {}, reached at t = {:.6g} T0; control the displacement, or use a "
      "dynamic scheme: {}",
      grows ? "beyond" : "under", found, model.mesh().body_dimension() == 3 ? "E0 L0^2" : "E0 L0", time, detail);
}

}  // namespace ixos
