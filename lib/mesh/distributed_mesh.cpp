#include "mesh/distributed_mesh.hpp"

#include <fmt/format.h>

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "fem/cell_info.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/distributed_cells.hpp"
#include "mesh/given_sets.hpp"
#include "mesh/meridian.hpp"
#include "mesh/node_directory.hpp"
#include "mesh/quality.hpp"

namespace ixos {
namespace {

void check_nodes(const DistributedMesh& mesh) {
  if (mesh.dimension != 2 && mesh.dimension != 3)
    throw InputError(fmt::format("the mesh has {} dimensions; 2 or 3 are allowed", mesh.dimension));
  if (mesh.order != 1 && mesh.order != 2)
    throw InputError(fmt::format("the mesh's cells have order {}; 1 or 2 are allowed", mesh.order));
  const auto d = static_cast<std::size_t>(mesh.dimension);
  if (mesh.coordinates.size() != mesh.nodes.size() * d)
    throw InputError(fmt::format("{} coordinates are not those of {} nodes in {} dimensions", mesh.coordinates.size(),
                                 mesh.nodes.size(), d));
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    if (mesh.nodes[i] < 0) throw InputError(fmt::format("a node has the id {}; ids are at least 0", mesh.nodes[i]));
    for (std::size_t k = 0; k < d; ++k)
      if (const double x = mesh.coordinates[i * d + k]; !std::isfinite(x))
        throw InputError(fmt::format("node {} has the coordinate {}; it must be finite", mesh.nodes[i], x));
  }
}

/// Checks what one rank can see.
void check_share(const DistributedMesh& mesh) {
  check_nodes(mesh);
  check_names(mesh.blocks, "block");
  check_names(mesh.side_sets, "side set");
  check_names(mesh.node_sets, "node set");
  if (mesh.blocks.empty()) throw InputError("the mesh has no blocks; at least one is needed");
  const int n = nodes_per_cell(cell_type(mesh));
  std::vector<SideLimits> limits;
  limits.reserve(mesh.blocks.size());
  for (const DistributedBlock& block : mesh.blocks) {
    limits.push_back({block.nodes.size() / static_cast<std::size_t>(n), sides_per_cell(cell_type(mesh))});
    if (block.nodes.size() % static_cast<std::size_t>(n) != 0)
      throw InputError(fmt::format("block \"{}\": {} node numbers are not those of cells with {} nodes", block.name,
                                   block.nodes.size(), n));
  }
  for (const SideSet& set : mesh.side_sets) check_sides(set, limits, " on this rank");
}

/// The ranks must agree on the lists that they go through together.
void check_agreement(const DistributedMesh& mesh, const Comm& comm) {
  std::string names = fmt::format("{} dimensions{}{}", mesh.dimension, mesh.axisymmetric ? ", axisymmetric" : "",
                                  mesh.order == 2 ? ", cells of order 2" : "");
  for (const DistributedBlock& block : mesh.blocks) names += ", block \"" + block.name + "\"";
  for (const SideSet& set : mesh.side_sets) names += ", side set \"" + set.name + "\"";
  for (const DistributedNodeSet& set : mesh.node_sets) names += ", node set \"" + set.name + "\"";
  const std::string first = from_first_rank(comm, names);
  together<InputError>(comm, [&] {
    if (names != first)
      throw InputError(
          fmt::format("all ranks must list the same blocks and sets in the same order: rank 0 has {}; "
                      "rank {} has {}",
                      first, comm->getRank(), names));
  });
}

/// Fills in the nodes: this rank's own in their order, then the ghosts in the order of their global numbers.
void add_nodes(const DistributedMesh& mesh, const TouchingCells& touching, const NodeDirectory& directory,
               const Comm& comm, LocalMesh& local) {
  std::set<long long> ghosts;
  ghosts.insert(touching.nodes.begin(), touching.nodes.end());
  std::vector<NodeEntry> entries = directory.find(mesh.nodes);
  together<InputError>(comm, [&] {
    for (const long long id : mesh.nodes)
      if (ghosts.erase(id) == 0) throw InputError(fmt::format("node {} belongs to no cell; remove it", id));
  });
  std::vector<long long> owned(static_cast<std::size_t>(comm->getSize())), first(owned.size(), 0);
  const auto mine = static_cast<long long>(mesh.nodes.size());
  Teuchos::gatherAll(*comm, 1, &mine, comm->getSize(), owned.data());
  for (std::size_t r = 1; r < first.size(); ++r) first[r] = first[r - 1] + owned[r - 1];
  const auto global = [&](const NodeEntry& entry) {
    return first[static_cast<std::size_t>(entry.owner)] + entry.place;
  };
  std::vector<NodeEntry> others = directory.find({ghosts.begin(), ghosts.end()});
  std::sort(others.begin(), others.end(),
            [&](const NodeEntry& a, const NodeEntry& b) { return global(a) < global(b); });
  entries.insert(entries.end(), others.begin(), others.end());
  local.owned_nodes = static_cast<int>(mine);
  for (const NodeEntry& entry : entries) {
    local.global_ids.push_back(global(entry));
    local.original_ids.push_back(static_cast<int>(entry.number));
    local.program_ids.push_back(entry.id);
    for (int k = 0; k < mesh.dimension; ++k) local.coordinates.push_back(entry.x[static_cast<std::size_t>(k)]);
  }
}

/// A cell's number over all ranks, by block, and its place here.
using CellPlaces = std::map<std::pair<int, int>, int>;

CellPlaces add_cells(const DistributedMesh& mesh, const TouchingCells& touching, LocalMesh& local) {
  std::map<long long, int> places;  // of nodes
  for (std::size_t i = 0; i < local.program_ids.size(); ++i) places[local.program_ids[i]] = static_cast<int>(i);
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    LocalBlock& block = local.blocks.emplace_back();
    block.name = mesh.blocks[b].name;
    block.type = cell_type(mesh);
    block.global_cells = touching.global_cells[b];
    block.number = static_cast<int>(b);
    local.global_cells += block.global_cells;
  }
  CellPlaces cells;
  for (const SentCell& sent : touching.cells) {
    LocalBlock& block = local.blocks[static_cast<std::size_t>(sent.block)];
    cells[{sent.block, sent.number}] = block.cells();
    const long long* nodes = touching.nodes_of(sent);
    for (int a = 0; a < nodes_per_cell(block.type); ++a) block.nodes.push_back(places.at(nodes[a]));
    block.owned.push_back(places.at(nodes[0]) < local.owned_nodes ? 1 : 0);
    block.original_cells.push_back(sent.number);
  }
  return cells;
}

void add_sides(const DistributedMesh& mesh, const TouchingCells& touching, const CellPlaces& cells, LocalMesh& local) {
  for (const SideSet& set : mesh.side_sets) local.side_set_names.push_back(set.name);
  local.side_sets.resize(mesh.side_sets.size());
  for (const SentSide& sent : touching.sides) {
    const LocalBlock& block = local.blocks[static_cast<std::size_t>(sent.block)];
    const int cell = cells.at({sent.block, sent.cell});
    LocalSide side{sent.block, cell, sent.side, {}, block.owned[static_cast<std::size_t>(cell)] != 0};
    for (const int a : side_nodes(block.type, sent.side))
      side.nodes.push_back(block.nodes[cell_entry(cell, nodes_per_cell(block.type), a)]);
    local.side_sets[static_cast<std::size_t>(sent.set)].push_back(std::move(side));
  }
}

void add_node_sets(const DistributedMesh& mesh, const NodeDirectory& directory, const Comm& comm, LocalMesh& local) {
  std::vector<SetMember> members;
  std::vector<long long> ids;
  for (std::size_t set = 0; set < mesh.node_sets.size(); ++set) {
    local.node_set_names.push_back(mesh.node_sets[set].name);
    for (const long long id : mesh.node_sets[set].nodes) {
      members.push_back({id, static_cast<int>(set)});
      ids.push_back(id);
    }
  }
  const std::vector<NodeEntry> entries = directory.find(ids);
  together<InputError>(comm, [&] {
    for (std::size_t i = 0; i < entries.size(); ++i)
      if (entries[i].owner < 0)
        throw InputError(fmt::format("node set \"{}\" has node {}, which no rank owns",
                                     mesh.node_sets[static_cast<std::size_t>(members[i].set)].name, ids[i]));
  });
  local.node_sets = directory.find_members(members, mesh.node_sets.size(), local.program_ids);
}

}  // namespace

CellType cell_type(const DistributedMesh& mesh) { return cube_type(mesh.dimension, mesh.order == 2 ? 2 : 1); }

LocalMesh local_part(const DistributedMesh& mesh, const Comm& comm) {
  together<InputError>(comm, [&] { check_share(mesh); });
  check_agreement(mesh, comm);
  const NodeDirectory directory(mesh.nodes, mesh.coordinates, mesh.dimension, comm);
  if (directory.size() > std::numeric_limits<int>::max())
    throw InputError(fmt::format("the mesh has {} nodes; at most {} are allowed", directory.size(),
                                 std::numeric_limits<int>::max()));
  const TouchingCells touching = touching_cells(mesh, directory, comm);
  LocalMesh local;
  local.dimension = mesh.dimension;
  local.axisymmetric = mesh.axisymmetric;
  const double radius = largest_radius(mesh);
  Teuchos::reduceAll(*comm, Teuchos::REDUCE_MAX, 1, &radius, &local.largest_radius);
  local.global_nodes = directory.size();
  add_nodes(mesh, touching, directory, comm, local);
  add_sides(mesh, touching, add_cells(mesh, touching, local), local);
  add_node_sets(mesh, directory, comm, local);
  together<InputError>(comm, [&] {
    require_shared_middles(local);
    check_cells(local);
  });
  return local;
}

}  // namespace ixos
