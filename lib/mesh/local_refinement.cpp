// A rank's part of the coarse cells of halved cells.
#include <algorithm>
#include <memory>

#include "mesh/refinement.hpp"

namespace ixos {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// Returns the coarse cells of the rank's fine cells, ascending.
std::vector<int> coarse_cells_of(const Refinement& refinement, const LocalMesh& fine) {
  std::vector<char> seen(index(refinement.coarse.cells()), 0);
  for (std::size_t b = 0; b < fine.blocks.size(); ++b)
    for (const int cell : fine.blocks[b].original_cells) seen[index(refinement.coarse_cell[b][index(cell)])] = 1;
  std::vector<int> coarse_cells;
  for (int cell = 0; cell < refinement.coarse.cells(); ++cell)
    if (seen[index(cell)] != 0) coarse_cells.push_back(cell);
  return coarse_cells;
}

}  // namespace

LocalRefinement localize(const Refinement& refinement, const std::vector<int>& node_owner, int rank, int ranks,
                         const LocalMesh& fine) {
  const Mesh& mesh = refinement.coarse;
  const ElementBlock& block = mesh.blocks.front();
  const int n = nodes_per_cell(block.type);
  const auto owner = [&](int coarse) { return node_owner[index(refinement.fine_node[index(coarse)])]; };
  std::vector<long long> next(index(ranks) + 1, 0), number;
  for (int node = 0; node < mesh.nodes(); ++node) ++next[index(owner(node)) + 1];
  for (std::size_t r = 1; r < next.size(); ++r) next[r] += next[r - 1];
  for (int node = 0; node < mesh.nodes(); ++node) number.push_back(next[index(owner(node))]++);

  LocalRefinement result;
  LocalMesh& coarse = result.coarse;
  coarse.dimension = mesh.dimension;
  coarse.global_nodes = mesh.nodes();
  coarse.global_cells = mesh.cells();
  const std::vector<int> coarse_cells = coarse_cells_of(refinement, fine);
  std::vector<int> ghosts;
  for (int node = 0; node < mesh.nodes(); ++node)
    if (owner(node) == rank) coarse.original_ids.push_back(node);
  coarse.owned_nodes = static_cast<int>(coarse.original_ids.size());
  for (const int coarse_cell : coarse_cells)
    for (int a = 0; a < n; ++a)
      if (const int node = block.nodes[cell_entry(coarse_cell, n, a)]; owner(node) != rank) ghosts.push_back(node);
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
  here.original_cells = coarse_cells;
  here.global_cells = block.cells();
  for (const int coarse_cell : coarse_cells) {
    here.owned.push_back(owner(block.nodes[cell_entry(coarse_cell, n)]) == rank ? 1 : 0);
    for (int a = 0; a < n; ++a) here.nodes.push_back(to_local[index(block.nodes[cell_entry(coarse_cell, n, a)])]);
  }
  coarse.blocks.push_back(std::move(here));

  result.first_share.assign(1, 0);
  for (const int node : fine.original_ids) {
    for (std::size_t k = refinement.first_share[index(node)]; k < refinement.first_share[index(node) + 1]; ++k)
      result.corner.push_back(to_local[index(refinement.corner[k])]);
    const bool is_corner = result.corner.size() == result.first_share.back() + 1;
    result.number.push_back(is_corner ? result.corner.back() : -1);
    result.first_share.push_back(result.corner.size());
  }
  return result;
}

void add_coarse_cells(const Mesh& mesh, const std::vector<int>& node_owner, int rank, int ranks, LocalMesh& fine) {
  if (const auto refinement = find_refinement(mesh))
    fine.refinement = std::make_shared<const LocalRefinement>(localize(*refinement, node_owner, rank, ranks, fine));
}

}  // namespace ixos
