// A rank's part of the parents of halved cells.
#include <algorithm>
#include <memory>

#include "mesh/halving.hpp"

namespace ixos {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// Returns the parents of the rank's fine cells, ascending.
std::vector<int> parents_of(const Halving& halving, const LocalMesh& fine) {
  std::vector<char> seen(index(halving.coarse.cells()), 0);
  for (std::size_t b = 0; b < fine.blocks.size(); ++b)
    for (const int cell : fine.blocks[b].original_cells) seen[index(halving.parent[b][index(cell)])] = 1;
  std::vector<int> parents;
  for (int cell = 0; cell < halving.coarse.cells(); ++cell)
    if (seen[index(cell)] != 0) parents.push_back(cell);
  return parents;
}

}  // namespace

LocalHalving localize(const Halving& halving, const std::vector<int>& node_owner, int rank, int ranks,
                      const LocalMesh& fine) {
  const Mesh& mesh = halving.coarse;
  const ElementBlock& block = mesh.blocks.front();
  const int n = nodes_per_cell(block.type);
  const auto owner = [&](int coarse) { return node_owner[index(halving.fine_node[index(coarse)])]; };
  std::vector<long long> next(index(ranks) + 1, 0), number;
  for (int node = 0; node < mesh.nodes(); ++node) ++next[index(owner(node)) + 1];
  for (std::size_t r = 1; r < next.size(); ++r) next[r] += next[r - 1];
  for (int node = 0; node < mesh.nodes(); ++node) number.push_back(next[index(owner(node))]++);

  LocalHalving result;
  LocalMesh& coarse = result.coarse;
  coarse.dimension = mesh.dimension;
  coarse.global_nodes = mesh.nodes();
  coarse.global_cells = mesh.cells();
  const std::vector<int> parents = parents_of(halving, fine);
  std::vector<int> ghosts;
  for (int node = 0; node < mesh.nodes(); ++node)
    if (owner(node) == rank) coarse.original_ids.push_back(node);
  coarse.owned_nodes = static_cast<int>(coarse.original_ids.size());
  for (const int parent : parents)
    for (int a = 0; a < n; ++a)
      if (const int node = block.nodes[cell_entry(parent, n, a)]; owner(node) != rank) ghosts.push_back(node);
  std::sort(ghosts.begin(), ghosts.end(), [&](int a, int b) { return number[index(a)] < number[index(b)]; });
  ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());
  coarse.original_ids.insert(coarse.original_ids.end(), ghosts.begin(), ghosts.end());

  std::vector<int> to_local(index(mesh.nodes()), -1);
  const auto d = index(mesh.dimension);
  for (std::size_t i = 0; i < coarse.original_ids.size(); ++i) {
    const auto node = index(coarse.original_ids[i]);
    to_local[node] = static_cast<int>(i);
    coarse.global_ids.push_back(number[node]);
    coarse.coordinates.insert(coarse.coordinates.end(), &mesh.coordinates[node * d], &mesh.coordinates[node * d] + d);
  }
  LocalBlock here;
  here.name = block.name;
  here.type = block.type;
  here.original_cells = parents;
  here.global_cells = block.cells();
  for (const int parent : parents) {
    here.owned.push_back(owner(block.nodes[cell_entry(parent, n)]) == rank ? 1 : 0);
    for (int a = 0; a < n; ++a) here.nodes.push_back(to_local[index(block.nodes[cell_entry(parent, n, a)])]);
  }
  coarse.blocks.push_back(std::move(here));

  result.first_share.assign(1, 0);
  for (const int node : fine.original_ids) {
    for (std::size_t k = halving.first_share[index(node)]; k < halving.first_share[index(node) + 1]; ++k)
      result.corner.push_back(to_local[index(halving.corner[k])]);
    const bool is_corner = result.corner.size() == result.first_share.back() + 1;
    result.number.push_back(is_corner ? result.corner.back() : -1);
    result.first_share.push_back(result.corner.size());
  }
  return result;
}

void add_parents(const Mesh& mesh, const std::vector<int>& node_owner, int rank, int ranks, LocalMesh& fine) {
  if (const auto halving = halve(mesh))
    fine.halving = std::make_shared<const LocalHalving>(localize(*halving, node_owner, rank, ranks, fine));
}

}  // namespace ixos
