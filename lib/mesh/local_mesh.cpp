#include "mesh/local_mesh.hpp"

#include <algorithm>

#include "base/closest_name.hpp"
#include "base/error.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/curved_cells.hpp"
#include "mesh/level_width.hpp"
#include "mesh/meridian.hpp"
#include "mesh/selection.hpp"
#include "mesh/tied_nodes.hpp"

namespace ixos {
namespace {

std::size_t index_of(const std::string& name, const std::vector<std::string>& names, const char* what) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw InputError(no_such_set(what, name, names));
  return static_cast<std::size_t>(found - names.begin());
}

/// Returns the nodes that no tie holds in the order in which a rank keeps its own: that of the mesh; in a mesh with
/// ties that of their first cells. Nodes that a refinement adds stand last in the mesh, far from their neighbours in
/// memory.
std::vector<int> order_of_nodes(const Mesh& mesh, const std::vector<const Tie*>& tie) {
  std::vector<int> order;
  std::vector<char> has_place(tie.size(), 0);
  const auto place = [&](int node) {
    const auto n = static_cast<std::size_t>(node);
    if (tie[n] == nullptr && has_place[n] == 0) order.push_back(node);
    has_place[n] = 1;
  };
  if (!mesh.ties.empty())
    for (const ElementBlock& block : mesh.blocks) std::for_each(block.nodes.begin(), block.nodes.end(), place);
  for (int node = 0; node < mesh.nodes(); ++node) place(node);
  return order;
}

/// Numbers the nodes so that each rank's are consecutive, in this order within a rank.
/// Tied nodes get the numbers behind all others.
std::vector<long long> number_by_rank(const std::vector<int>& order, const std::vector<int>& owner, int ranks) {
  std::vector<long long> next(static_cast<std::size_t>(ranks) + 1, 0);
  const auto owner_of = [&](int node) { return static_cast<std::size_t>(owner[static_cast<std::size_t>(node)]); };
  for (const int node : order) ++next[owner_of(node) + 1];
  for (std::size_t rank = 1; rank < next.size(); ++rank) next[rank] += next[rank - 1];
  std::vector<long long> number(owner.size(), -1);
  for (const int node : order) number[static_cast<std::size_t>(node)] = next[owner_of(node)]++;
  long long behind = next.back();
  for (long long& each : number)
    if (each < 0) each = behind++;
  return number;
}

/// Returns each node's tie, null if it has none.
std::vector<const Tie*> ties_of_nodes(const Mesh& mesh, const std::vector<Tie>& ties) {
  std::vector<const Tie*> result(static_cast<std::size_t>(mesh.nodes()), nullptr);
  for (const Tie& tie : ties) result[static_cast<std::size_t>(tie.node)] = &tie;
  return result;
}

/// Returns whether the rank owns one of a node's masters, or the node if it is not tied.
bool touches(const Tie* tie, int node, const std::vector<int>& owner, int rank) {
  const auto own = [&](int n) { return owner[static_cast<std::size_t>(n)] == rank; };
  return tie == nullptr ? own(node) : std::any_of(tie->masters.begin(), tie->masters.end(), own);
}

/// Returns, for each block, which cells touch a node of this rank.
std::vector<std::vector<int>> touching_cells(const Mesh& mesh, const std::vector<int>& owner,
                                             const std::vector<const Tie*>& tie, int rank) {
  std::vector<std::vector<int>> result;
  for (const ElementBlock& block : mesh.blocks) {
    const int n = nodes_per_cell(block.type);
    result.emplace_back();
    for (int cell = 0; cell < block.cells(); ++cell) {
      const int* nodes = &block.nodes[cell_entry(cell, n)];
      if (std::any_of(nodes, nodes + n,
                      [&](int node) { return touches(tie[static_cast<std::size_t>(node)], node, owner, rank); }))
        result.back().push_back(cell);
    }
  }
  return result;
}

}  // namespace

bool LocalMesh::has_row(int node) const {
  if (!is_tied(node)) return node < owned_nodes;
  return std::any_of(ties.begin(node), ties.end(node),
                     [this](const NodeTies::Share& share) { return share.master < owned_nodes; });
}

std::size_t LocalMesh::side_set(const std::string& name) const { return index_of(name, side_set_names, "side set"); }

std::size_t LocalMesh::node_set(const std::string& name) const { return index_of(name, node_set_names, "node set"); }

std::vector<std::size_t> LocalMesh::blocks_named(const std::string& name) const {
  std::vector<std::size_t> found;
  std::vector<std::string> names;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (blocks[b].name == name) found.push_back(b);
    if (std::find(names.begin(), names.end(), blocks[b].name) == names.end()) names.push_back(blocks[b].name);
  }
  if (found.empty()) throw InputError(no_such("block", name, names, "The mesh has"));
  return found;
}

LocalMesh localize(const Mesh& mesh, const std::vector<int>& given_owner, int rank, int ranks,
                   const std::vector<std::string>& whole) {
  const std::vector<Tie> ties = resolved_ties(mesh);
  const auto tie = ties_of_nodes(mesh, ties);
  std::vector<int> node_owner = given_owner;
  for (const Tie& own : ties)
    node_owner[static_cast<std::size_t>(own.node)] = given_owner[static_cast<std::size_t>(own.masters.front())];
  const std::vector<int> order = order_of_nodes(mesh, tie);
  const auto number = number_by_rank(order, node_owner, ranks);
  const auto cells = touching_cells(mesh, node_owner, tie, rank);

  LocalMesh local;
  local.dimension = mesh.dimension;
  local.axisymmetric = mesh.axisymmetric;
  local.largest_radius = largest_radius(mesh);
  local.linear_nodes = mesh.linear_nodes;
  local.plain_nodes = mesh.plain_nodes;
  local.level_width = mean_level_width(mesh);
  local.global_nodes = mesh.nodes() - static_cast<int>(mesh.ties.size());
  local.global_tied = static_cast<long long>(mesh.ties.size());
  local.global_cells = mesh.cells();
  for (const int node : order)
    if (node_owner[static_cast<std::size_t>(node)] == rank) local.original_ids.push_back(node);
  local.owned_nodes = static_cast<int>(local.original_ids.size());
  std::vector<int> ghosts, tied;
  const auto see = [&](int node) {
    const auto see_free = [&](int free) {
      if (node_owner[static_cast<std::size_t>(free)] != rank) ghosts.push_back(free);
    };
    const Tie* const own = tie[static_cast<std::size_t>(node)];
    if (own == nullptr) return see_free(node);
    tied.push_back(node);
    std::for_each(own->masters.begin(), own->masters.end(), see_free);
  };
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const int n = nodes_per_cell(mesh.blocks[b].type);
    for (int cell : cells[b])
      for (int a = 0; a < n; ++a) see(mesh.blocks[b].nodes[cell_entry(cell, n, a)]);
  }
  for (const std::string& name : whole)
    for (const Side& side : side_set_named(mesh, name).sides)
      for (const int node : nodes_of_side(mesh, side)) see(node);
  std::sort(ghosts.begin(), ghosts.end(),
            [&](int a, int b) { return number[static_cast<std::size_t>(a)] < number[static_cast<std::size_t>(b)]; });
  ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());
  local.original_ids.insert(local.original_ids.end(), ghosts.begin(), ghosts.end());
  std::sort(tied.begin(), tied.end());
  tied.erase(std::unique(tied.begin(), tied.end()), tied.end());
  local.ties = NodeTies(static_cast<int>(local.original_ids.size()));
  local.original_ids.insert(local.original_ids.end(), tied.begin(), tied.end());

  std::vector<int> to_local(static_cast<std::size_t>(mesh.nodes()), -1);
  const auto dim = static_cast<std::size_t>(mesh.dimension);
  for (std::size_t i = 0; i < local.original_ids.size(); ++i) {
    const auto node = static_cast<std::size_t>(local.original_ids[i]);
    to_local[node] = static_cast<int>(i);
    local.global_ids.push_back(number[node]);
    for (std::size_t d = 0; d < dim; ++d) local.coordinates.push_back(mesh.coordinates[node * dim + d]);
    if (!mesh.derivative_of.empty()) local.derivative.push_back(mesh.derivative_of[node] >= 0 ? 1 : 0);
  }

  for (const int node : tied) {
    const Tie& own = *tie[static_cast<std::size_t>(node)];
    std::vector<NodeTies::Share> shares;
    for (std::size_t k = 0; k < own.masters.size(); ++k)
      shares.push_back({to_local[static_cast<std::size_t>(own.masters[k])], own.weights[k]});
    local.ties.add(shares);
  }

  std::vector<std::vector<int>> local_cell;  // per block: number of the cell here, or -1
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const ElementBlock& block = mesh.blocks[b];
    const int n = nodes_per_cell(block.type);
    LocalBlock here;
    here.name = block.name;
    here.type = block.type;
    here.points = block.points;
    here.tied = block.tied;
    here.high_rule = needs_high_rule(mesh, block);
    here.original_cells = cells[b];
    here.global_cells = block.cells();
    here.number = static_cast<int>(b);
    local_cell.emplace_back(static_cast<std::size_t>(block.cells()), -1);
    for (int cell : cells[b]) {
      local_cell[b][static_cast<std::size_t>(cell)] = here.cells();
      const int first = block.nodes[cell_entry(cell, n)];
      here.owned.push_back(node_owner[static_cast<std::size_t>(first)] == rank ? 1 : 0);
      for (int a = 0; a < n; ++a)
        here.nodes.push_back(to_local[static_cast<std::size_t>(block.nodes[cell_entry(cell, n, a)])]);
      for (int a = nodes_per_cell(corner_type(block.type)); a < n && is_hermite(block.type); ++a)
        here.derivative_scale.push_back(node_scale(block, cell, a));
    }
    local.blocks.push_back(std::move(here));
  }

  for (const SideSet& set : mesh.side_sets) {
    local.side_set_names.push_back(set.name);
    local.side_sets.emplace_back();
    for (const Side& side : set.sides) {
      const auto b = static_cast<std::size_t>(side.block);
      const int cell = local_cell[b][static_cast<std::size_t>(side.cell)];
      if (cell < 0) continue;
      const LocalBlock& block = local.blocks[b];
      LocalSide here{side.block, cell, side.side, {}, block.owned[static_cast<std::size_t>(cell)] != 0};
      for (int a : side_nodes(block.type, side.side))
        here.nodes.push_back(block.nodes[cell_entry(cell, nodes_per_cell(block.type), a)]);
      local.side_sets.back().push_back(std::move(here));
    }
  }
  for (const std::string& name : whole) {
    std::vector<LocalSide>& sides = local.whole_side_sets[name];
    if (!sides.empty()) continue;
    for (const Side& side : side_set_named(mesh, name).sides) {
      const auto b = static_cast<std::size_t>(side.block);
      const ElementBlock& block = mesh.blocks[b];
      const int cell = local_cell[b][static_cast<std::size_t>(side.cell)];
      const int first = block.nodes[cell_entry(side.cell, nodes_per_cell(block.type))];
      LocalSide here{side.block,
                     cell < 0 ? -1 - side.cell : cell,
                     side.side,
                     {},
                     node_owner[static_cast<std::size_t>(first)] == rank};
      for (const int node : nodes_of_side(mesh, side)) here.nodes.push_back(to_local[static_cast<std::size_t>(node)]);
      sides.push_back(std::move(here));
    }
  }
  for (const NodeSet& set : mesh.node_sets) {
    local.node_set_names.push_back(set.name);
    local.node_sets.emplace_back();
    for (int node : set.nodes)
      if (to_local[static_cast<std::size_t>(node)] >= 0)
        local.node_sets.back().push_back(to_local[static_cast<std::size_t>(node)]);
  }
  return local;
}

}  // namespace ixos
