#include "time/equilibrium.hpp"

#include <fmt/format.h>

#include <cmath>

namespace ixos {

std::string no_equilibrium(const Model& model, const State& start, double time, const std::string& detail) {
  // The forces by which springs are driven are loads to the model, but displacements to the user.
  const bool loaded = model.space().maximum(start.load.empty() ? 0.0 : 1.0) > 0 && !model.has_springs();
  if (!loaded)
    return fmt::format(
        "no equilibrium found beyond t = {:.6g} T0; use shorter steps (Maximum Cuts), or a dynamic scheme: {}", time,
        detail);
  const LocalMesh& mesh = model.mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  double sum = 0;
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.owned_nodes); ++node) {
    if (mesh.is_derivative(node)) continue;
    double square = 0;
    for (std::size_t i = 0; i < d; ++i) square += start.load[node * d + i] * start.load[node * d + i];
    sum += std::sqrt(square);
  }
  model.space().sum(&sum, 1);
  return fmt::format(
      "no equilibrium found beyond a load of {:.6g} {}, reached at t = {:.6g} T0; control the displacement, or use a "
      "dynamic scheme: {}",
      sum, mesh.body_dimension() == 3 ? "E0 L0^2" : "E0 L0", time, detail);
}

}  // namespace ixos
