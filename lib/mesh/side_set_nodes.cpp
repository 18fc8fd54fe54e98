#include "mesh/side_set_nodes.hpp"

#include "mesh/cell_sides.hpp"

namespace ixos {

std::set<int> nodes_of(const Mesh& mesh, const SideSet& set) {
  std::set<int> nodes;
  for (const Side& side : set.sides) {
    const std::vector<int> own = nodes_of_side(mesh, side);
    nodes.insert(own.begin(), own.end());
  }
  return nodes;
}

SetPairs sets_of_sides(const Mesh& mesh) {
  SetPairs pairs;
  for (std::size_t n = 0; n < mesh.node_sets.size(); ++n)
    for (std::size_t s = 0; s < mesh.side_sets.size(); ++s) {
      const NodeSet& set = mesh.node_sets[n];
      if (set.name == mesh.side_sets[s].name &&
          std::set<int>(set.nodes.begin(), set.nodes.end()) == nodes_of(mesh, mesh.side_sets[s]))
        pairs.emplace_back(n, s);
    }
  return pairs;
}

void renew_sets_of_sides(Mesh& mesh, const SetPairs& pairs) {
  for (const auto& [node_set, side_set] : pairs) {
    const std::set<int> nodes = nodes_of(mesh, mesh.side_sets[side_set]);
    mesh.node_sets[node_set].nodes.assign(nodes.begin(), nodes.end());
  }
}

}  // namespace ixos
