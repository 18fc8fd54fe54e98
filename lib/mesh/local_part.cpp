// Parts of whole meshes that a program provides.
#include <fmt/format.h>

#include "base/agreement.hpp"
#include "mesh/generators/given.hpp"
#include "mesh/local_mesh.hpp"
#include "mesh/partition.hpp"
#include "mesh/quality.hpp"
#include "mesh/soundness.hpp"

namespace ixos {
namespace {

void check_whole(const Mesh& mesh) {
  if (mesh.plain_nodes < 0) {
    check_arrays(mesh);
    refuse_repeated_cells(mesh);
  }
  check_cells(mesh);
}

void check_owners(const Mesh& mesh, const std::vector<int>& owner, int ranks) {
  if (owner.size() != static_cast<std::size_t>(mesh.nodes()))
    throw InputError(fmt::format("{} nodes have owners, but the mesh has {} nodes", owner.size(), mesh.nodes()));
  for (std::size_t node = 0; node < owner.size(); ++node)
    if (owner[node] < 0 || owner[node] >= ranks)
      throw InputError(fmt::format("node {} is owned by rank {}; the ranks are 0 to {}", node, owner[node], ranks - 1));
}

}  // namespace

LocalMesh local_part(const Mesh& mesh, const Comm& comm) {
  together<InputError>(comm, [&] { check_whole(mesh); });
  return localize(mesh, partition_nodes(mesh, comm->getSize()), comm->getRank(), comm->getSize());
}

LocalMesh local_part(const Mesh& mesh, const std::vector<int>& node_owner, const Comm& comm) {
  together<InputError>(comm, [&] {
    check_whole(mesh);
    check_owners(mesh, node_owner, comm->getSize());
  });
  return localize(mesh, node_owner, comm->getRank(), comm->getSize());
}

}  // namespace ixos
