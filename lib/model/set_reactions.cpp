#include "model/set_reactions.hpp"

#include "base/error.hpp"

namespace ixos {

std::vector<double> set_reactions(const Model& model, const std::vector<double>& forces,
                                  const std::vector<std::size_t>& sets) {
  const LocalMesh& mesh = model.mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  std::vector<double> sums(sets.size() * d, 0.0);
  const NodePlanes& planes = model.constraints().planes();
  std::vector<double> across(planes.empty() ? 0 : static_cast<std::size_t>(model.space().owned()), 0.0);
  planes.add_across(1, forces.data(), across.data(), mesh.owned_nodes);
  for (std::size_t s = 0; s < sets.size(); ++s)
    for (const int node : mesh.node_sets[sets[s]]) {
      const auto n = static_cast<std::size_t>(node);
      if (node >= mesh.owned_nodes || mesh.is_derivative(n)) continue;
      for (std::size_t i = 0; i < d; ++i)
        if (model.constraints().holds(static_cast<int>(n * d + i)))
          sums[s * d + i] += forces[n * d + i];
        else if (!across.empty())
          sums[s * d + i] += across[n * d + i];
    }
  model.space().sum(sums.data(), static_cast<int>(sums.size()));
  return sums;
}

std::vector<double> set_reaction(const Model& model, const std::vector<double>& forces, const std::string& set) {
  return set_reactions(model, forces, {model.mesh().node_set(set)});
}

void check_held(const Model& model, const std::string& set) {
  const LocalMesh& mesh = model.mesh();
  double held = 0;
  for (const int node : mesh.node_sets[mesh.node_set(set)]) {
    held += static_cast<double>(model.constraints().planes().normals(node).size());
    for (int i = 0; i < mesh.dimension; ++i) held += model.constraints().holds(node * mesh.dimension + i) ? 1 : 0;
  }
  if (model.space().maximum(held) == 0)
    throw InputError("no displacement of the node set \"" + set + "\" is prescribed, so it has no reaction");
}

}  // namespace ixos
