#include "run/set_reactions.hpp"

namespace ixos {

std::vector<double> set_reactions(const Simulation& simulation, const std::vector<std::size_t>& sets) {
  const LocalMesh& mesh = simulation.model().mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  const std::vector<double>& reaction = simulation.integrator().state().reaction;
  std::vector<double> sums(sets.size() * d, 0.0);
  for (std::size_t s = 0; s < sets.size(); ++s)
    for (const int node : mesh.node_sets[sets[s]])
      for (std::size_t i = 0; i < d; ++i) {
        const std::size_t dof = static_cast<std::size_t>(node) * d + i;
        if (dof < reaction.size() && !mesh.is_derivative(static_cast<std::size_t>(node)))
          sums[s * d + i] += reaction[dof];
      }
  simulation.model().space().sum(sums.data(), static_cast<int>(sums.size()));
  return sums;
}

}  // namespace ixos
