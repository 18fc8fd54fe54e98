#include "model/tied_sets.hpp"

#include <fmt/format.h>

#include <set>

#include "base/agreement.hpp"
#include "base/error.hpp"

namespace ixos {

void refuse_half_tied(const Model& model, const std::string& node_set) {
  const LocalMesh& mesh = model.mesh();
  if (mesh.global_tied == 0) return;
  const std::vector<int>& nodes = mesh.node_sets[mesh.node_set(node_set)];
  const std::set<int> own(nodes.begin(), nodes.end());
  const auto number = [&mesh](int node) { return mesh.message_number(static_cast<std::size_t>(node)); };
  together<InputError>(model.space().comm(), [&] {
    for (const int node : nodes) {
      if (!mesh.is_tied(node)) continue;
      for (const NodeTies::Share* share = mesh.ties.begin(node); share != mesh.ties.end(node); ++share)
        if (own.count(share->master) == 0)
          throw InputError(
              fmt::format("the node set \"{}\" has node {} of the mesh, which is tied to node {}, but not that one; "
                          "add it to the set, or leave the tied node out",
                          node_set, number(node), number(share->master)));
    }
  });
}

}  // namespace ixos
