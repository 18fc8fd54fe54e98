#include "mesh/contact_nodes.hpp"

#include <algorithm>
#include <set>

namespace ixos {

std::vector<int> side_corners(const Mesh& mesh, const Side& side) {
  const ElementBlock& block = mesh.blocks[static_cast<std::size_t>(side.block)];
  std::vector<int> corners;
  for (int a : side_nodes(block.type, side.side))
    corners.push_back(block.nodes[cell_entry(side.cell, nodes_per_cell(block.type), a)]);
  return corners;
}

int add_node(Mesh& mesh, const std::vector<double>& x, int derivative_of) {
  mesh.coordinates.insert(mesh.coordinates.end(), x.begin(), x.end());
  if (!mesh.derivative_of.empty()) mesh.derivative_of.push_back(derivative_of);
  return mesh.nodes() - 1;
}

void complete_node_sets(Mesh& mesh, const std::vector<Between>& added) {
  for (NodeSet& set : mesh.node_sets) {
    const std::set<int> members(set.nodes.begin(), set.nodes.end());
    const auto is_member = [&](int node) { return members.count(node) != 0; };
    std::set<int> further;
    for (const Between& between : added)
      if (std::all_of(between.corners.begin(), between.corners.end(), is_member))
        further.insert(between.nodes.begin(), between.nodes.end());
    set.nodes.insert(set.nodes.end(), further.begin(), further.end());
  }
}

}  // namespace ixos
