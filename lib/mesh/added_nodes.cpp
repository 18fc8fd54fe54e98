#include "mesh/added_nodes.hpp"

#include <algorithm>
#include <set>

namespace ixos {

int add_node(Mesh& mesh, const std::vector<double>& x, int derivative_of) {
  if (derivative_of >= 0 && mesh.derivative_of.empty())
    mesh.derivative_of.assign(static_cast<std::size_t>(mesh.nodes()), -1);
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
