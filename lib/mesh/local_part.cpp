// Parts of whole meshes that a program provides.
#include <fmt/format.h>

#include "base/agreement.hpp"
#include "base/digest.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/fingerprint.hpp"
#include "mesh/generators/given.hpp"
#include "mesh/local_mesh.hpp"
#include "mesh/partition.hpp"
#include "mesh/quality.hpp"
#include "mesh/refinement.hpp"
#include "mesh/soundness.hpp"

namespace ixos {
namespace {

void check_whole(const Mesh& mesh) {
  if (mesh.plain_nodes < 0) {
    check_arrays(mesh);
    refuse_repeated_cells(mesh);
  }
  require_one_order(mesh);
  refuse_split_faces(mesh);
  require_shared_middles(mesh);
  require_placed_bubbles(mesh);
  check_cells(mesh);
}

void check_owners(const Mesh& mesh, const std::vector<int>& owner, int ranks) {
  if (owner.size() != static_cast<std::size_t>(mesh.nodes()))
    throw InputError(fmt::format("{} nodes have owners, but the mesh has {} nodes", owner.size(), mesh.nodes()));
  for (std::size_t node = 0; node < owner.size(); ++node)
    if (owner[node] < 0 || owner[node] >= ranks)
      throw InputError(fmt::format("node {} is owned by rank {}; the ranks are 0 to {}", node, owner[node], ranks - 1));
}

/// Returns a checksum of all that ranks must have alike.
std::string digest_of(const Mesh& mesh, const std::vector<int>& owner) {
  Digest digest;
  digest.add_array(fingerprint(mesh));
  for (const ElementBlock& block : mesh.blocks) {
    digest.add_number(block.points);
    digest.add_number(block.tied);
  }
  for (const SideSet& set : mesh.side_sets) {
    digest.add_array(set.name);
    digest.add_array(set.sides);
  }
  for (const NodeSet& set : mesh.node_sets) {
    digest.add_array(set.name);
    digest.add_array(set.nodes);
  }
  digest.add_array(owner);
  return fmt::format("{:016x}{:016x}", digest.value()[0], digest.value()[1]);
}

/// Throws InputError, on all ranks, if they pass different arguments.
void refuse_different(const Mesh& mesh, const std::vector<int>& owner, const Comm& comm) {
  if (comm->getSize() == 1) return;
  const std::string mine = digest_of(mesh, owner), first = from_first_rank(comm, mine);
  together<InputError>(comm, [&] {
    if (mine != first)
      throw InputError(
          fmt::format("rank {} has another mesh, or other owners of its nodes, than rank 0; pass the same "
                      "whole mesh on all ranks, or each rank's share as a DistributedMesh",
                      comm->getRank()));
  });
}

LocalMesh part_with_coarse_cells(const Mesh& mesh, const std::vector<int>& owner, const Comm& comm,
                                 const std::vector<std::string>& whole) {
  LocalMesh local = localize(mesh, owner, comm->getRank(), comm->getSize(), whole);
  if (mesh.dimension == 3) add_coarse_cells(mesh, owner, comm->getRank(), comm->getSize(), local);
  return local;
}

}  // namespace

LocalMesh local_part(const Mesh& mesh, const Comm& comm, const std::vector<std::string>& whole) {
  refuse_different(mesh, {}, comm);
  together<InputError>(comm, [&] { check_whole(mesh); });
  return part_with_coarse_cells(mesh, partition_nodes(mesh, comm->getSize()), comm, whole);
}

LocalMesh local_part(const Mesh& mesh, const std::vector<int>& node_owner, const Comm& comm,
                     const std::vector<std::string>& whole) {
  refuse_different(mesh, node_owner, comm);
  together<InputError>(comm, [&] {
    check_whole(mesh);
    check_owners(mesh, node_owner, comm->getSize());
  });
  return part_with_coarse_cells(mesh, node_owner, comm, whole);
}

}  // namespace ixos
