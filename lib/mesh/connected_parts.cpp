#include "mesh/connected_parts.hpp"

#include "base/disjoint_sets.hpp"

namespace ixos {

std::vector<int> connected_parts(const Mesh& mesh) {
  DisjointSets sets(mesh.nodes());
  for (const ElementBlock& block : mesh.blocks) {
    const int all = nodes_per_cell(block.type);
    for (int cell = 0; cell < block.cells(); ++cell)
      for (int a = 1; a < all; ++a)
        sets.join(block.nodes[cell_entry(cell, all, 0)], block.nodes[cell_entry(cell, all, a)]);
  }
  for (const Tie& tie : mesh.ties)
    for (const int master : tie.masters) sets.join(tie.node, master);
  std::vector<int> parts(static_cast<std::size_t>(mesh.nodes()));
  for (int node = 0; node < mesh.nodes(); ++node) parts[static_cast<std::size_t>(node)] = sets.of(node);
  return parts;
}

}  // namespace ixos
