#include "mesh/partition.hpp"

#include <fmt/format.h>
#include <metis.h>

#include <algorithm>
#include <new>
#include <set>
#include <stdexcept>

#include "base/memory.hpp"
#include "fem/shape_table.hpp"
#include "fem/with_element.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/selection.hpp"

namespace ixos {
namespace {

int points_per_cell(CellType type) {
  return with_element(type, [](auto tag) { return static_cast<int>(own_rule<typename decltype(tag)::type>().size()); });
}

/// Throws if METIS failed.
void check(int status) {
  if (status == METIS_ERROR_MEMORY) {
    note_failed_allocation(0);
    throw std::bad_alloc();
  }
  if (status != METIS_OK) throw std::runtime_error(fmt::format("METIS failed with status {}", status));
}

/// Nodes of common cells are neighbours.
struct NodalGraph {
  std::vector<idx_t> start, neighbours, weights;
};

NodalGraph nodal_graph(idx_t cells, idx_t nodes, std::vector<idx_t>& start, std::vector<idx_t>& nodes_of_cells) {
  idx_t base = 0, *first = nullptr, *neighbours = nullptr;
  check(METIS_MeshToNodal(&cells, &nodes, start.data(), nodes_of_cells.data(), &base, &first, &neighbours));
  NodalGraph graph;
  graph.start.assign(first, first + nodes + 1);
  graph.neighbours.assign(neighbours, neighbours + first[nodes]);
  graph.weights.assign(graph.neighbours.size(), 1);
  METIS_Free(first);
  METIS_Free(neighbours);
  return graph;
}

/// Adds an edge for each pair of nodes, once in each direction, that is cut only if nothing else is possible.
NodalGraph with_edges(const NodalGraph& graph, const std::vector<std::pair<int, int>>& pairs) {
  constexpr idx_t heavy = 1000;
  std::set<std::pair<idx_t, idx_t>> edges;
  for (const auto& [a, b] : pairs)
    if (a != b) edges.insert({{a, b}, {b, a}});
  NodalGraph result;
  auto edge = edges.begin();
  for (std::size_t node = 0; node + 1 < graph.start.size(); ++node) {
    result.start.push_back(static_cast<idx_t>(result.neighbours.size()));
    std::set<idx_t> own;
    for (; edge != edges.end() && edge->first == static_cast<idx_t>(node); ++edge) own.insert(edge->second);
    for (auto k = static_cast<std::size_t>(graph.start[node]); k < static_cast<std::size_t>(graph.start[node + 1]);
         ++k) {
      const idx_t neighbour = graph.neighbours[k];
      if (own.count(neighbour) > 0) continue;
      result.neighbours.push_back(neighbour);
      result.weights.push_back(graph.weights[k]);
    }
    result.neighbours.insert(result.neighbours.end(), own.begin(), own.end());
    result.weights.resize(result.neighbours.size(), heavy);
  }
  result.start.push_back(static_cast<idx_t>(result.neighbours.size()));
  return result;
}

}  // namespace

std::vector<int> node_work(const Mesh& mesh, const std::vector<std::string>& contact, int solve,
                           const std::vector<Side>& facing) {
  std::vector<double> work(static_cast<std::size_t>(mesh.nodes()), solve);
  const auto share = [&work](const int* nodes, int count, double units) {
    for (int a = 0; a < count; ++a) work[static_cast<std::size_t>(nodes[a])] += units / count;
  };
  for (const ElementBlock& block : mesh.blocks) {
    const int n = nodes_per_cell(block.type);
    // Gradients and stresses grow with nodes times points.
    const double plain = mesh.dimension == 2 ? 4 : 8;
    const double units = (mesh.dimension == 2 ? 4 : 24) * (n / plain) * (points_per_cell(block.type) / plain);
    for (int cell = 0; cell < block.cells(); ++cell) share(&block.nodes[cell_entry(cell, n)], n, units);
  }
  const auto share_side = [&](const Side& side, double units_of_a_node) {
    const std::vector<int> nodes = nodes_of_side(mesh, side);
    share(nodes.data(), static_cast<int>(nodes.size()), units_of_a_node * static_cast<double>(nodes.size()));
  };
  // Eight time points on a plain side cost as much as the cell behind it, before another body as much as a hundred
  // hexahedra or twenty quadrilaterals with their part in the linear solve.
  for (const std::string& name : contact)
    for (const Side& side : side_set_named(mesh, name).sides) share_side(side, 6);
  for (const Side& side : facing) share_side(side, mesh.dimension == 2 ? 10.0 * (4 + solve) : 25.0 * (24 + solve));
  // METIS adds them up in 32 bits.
  double total = 0;
  for (double units : work) total += units;
  const double scale = std::min(1.0, 1e9 / total);
  std::vector<int> weights(work.size());
  std::transform(work.begin(), work.end(), weights.begin(),
                 [scale](double units) { return std::max(1, static_cast<int>(scale * units)); });
  return weights;
}

std::vector<int> partition_nodes(const Mesh& mesh, int ranks, const std::vector<int>& work,
                                 const std::vector<std::pair<int, int>>& facing) {
  std::vector<int> owner(static_cast<std::size_t>(mesh.nodes()), 0);
  if (ranks == 1) return owner;
  if (mesh.nodes() <= 2 * ranks) {
    // METIS balances parts of many nodes. With so few, each rank gets one node and further ranks none.
    for (std::size_t node = 0; node < owner.size(); ++node) owner[node] = static_cast<int>(node) % ranks;
    return owner;
  }

  std::vector<idx_t> start{0};
  std::vector<idx_t> nodes;
  for (const ElementBlock& block : mesh.blocks) {
    for (int cell = 0; cell < block.cells(); ++cell)
      start.push_back(start.back() + static_cast<idx_t>(nodes_per_cell(block.type)));
    nodes.insert(nodes.end(), block.nodes.begin(), block.nodes.end());
  }
  idx_t cells = mesh.cells();
  idx_t node_count = mesh.nodes();
  idx_t parts = ranks;
  idx_t cut = 0;
  std::vector<idx_t> node_part(static_cast<std::size_t>(node_count));
  std::vector<idx_t> options(METIS_NOPTIONS);
  METIS_SetDefaultOptions(options.data());
  options[METIS_OPTION_SEED] = 1;
  std::vector<idx_t> weights(work.begin(), work.end());
  idx_t* const of_nodes = weights.empty() ? nullptr : weights.data();
  if (facing.empty()) {
    std::vector<idx_t> cell_part(static_cast<std::size_t>(cells));
    check(METIS_PartMeshNodal(&cells, &node_count, start.data(), nodes.data(), of_nodes, nullptr, &parts, nullptr,
                              options.data(), &cut, cell_part.data(), node_part.data()));
  } else {
    NodalGraph graph = with_edges(nodal_graph(cells, node_count, start, nodes), facing);
    idx_t constraints = 1;
    check(METIS_PartGraphKway(&node_count, &constraints, graph.start.data(), graph.neighbours.data(), of_nodes, nullptr,
                              graph.weights.data(), &parts, nullptr, nullptr, options.data(), &cut, node_part.data()));
  }
  for (std::size_t i = 0; i < owner.size(); ++i) owner[i] = static_cast<int>(node_part[i]);
  return owner;
}

}  // namespace ixos
