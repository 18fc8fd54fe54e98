#include "io/gathered_mesh.hpp"

#include <algorithm>
#include <map>

#include "base/gather.hpp"

namespace ixos {
namespace {

/// Returns the first position of each id in a list, in the order of the ids.
std::map<int, std::size_t> first_places(const std::vector<int>& ids) {
  std::map<int, std::size_t> places;
  for (std::size_t i = 0; i < ids.size(); ++i) places.emplace(ids[i], i);
  return places;
}

/// The number of each id, from 0, in the order of the ids.
using Numbers = std::map<int, int>;

std::vector<int> ids_of(const std::vector<int>& nodes, const std::vector<int>& ids) {
  std::vector<int> result;
  result.reserve(nodes.size());
  for (int node : nodes) result.push_back(ids[static_cast<std::size_t>(node)]);
  return result;
}

Numbers gather_nodes(const OutputMesh& share, const Comm& comm, GatheredMesh& whole) {
  const auto d = static_cast<std::size_t>(share.mesh.dimension);
  const std::vector<int> ids = gather(share.description.node_ids, comm);
  const std::vector<double> coordinates = gather(share.mesh.coordinates, comm);
  Numbers numbers;
  for (const auto& [id, place] : first_places(ids)) {
    numbers.emplace(id, static_cast<int>(numbers.size()));
    whole.description.node_ids.push_back(id);
    for (std::size_t i = 0; i < d; ++i) whole.mesh.coordinates.push_back(coordinates[place * d + i]);
  }
  return numbers;
}

/// Returns the place of each cell as the sides of a set name it.
std::map<int, Side> gather_cells(const OutputMesh& share, const Comm& comm, const Numbers& nodes, GatheredMesh& whole) {
  std::map<int, Side> places;
  auto first = share.description.cell_ids.begin();
  for (const ElementBlock& block : share.mesh.blocks) {
    const std::vector<int> ids = gather(std::vector<int>(first, first + block.cells()), comm);
    const std::vector<int> corners = gather(ids_of(block.nodes, share.description.node_ids), comm);
    first += block.cells();
    const int n = nodes_per_cell(block.type);
    ElementBlock& here = whole.mesh.blocks.emplace_back();
    here.name = block.name;
    here.type = block.type;
    for (const auto& [id, place] : first_places(ids)) {
      places[id] = {static_cast<int>(whole.mesh.blocks.size()) - 1, here.cells(), 0};
      whole.description.cell_ids.push_back(id);
      for (int a = 0; a < n; ++a) here.nodes.push_back(nodes.at(corners[cell_entry(static_cast<int>(place), n, a)]));
    }
  }
  return places;
}

void gather_sets(const OutputMesh& share, const Comm& comm, const Numbers& nodes, const std::map<int, Side>& cells,
                 GatheredMesh& whole) {
  for (const NodeSet& set : share.mesh.node_sets) {
    NodeSet& here = whole.mesh.node_sets.emplace_back();
    here.name = set.name;
    for (const auto& [id, place] : first_places(gather(ids_of(set.nodes, share.description.node_ids), comm)))
      here.nodes.push_back(nodes.at(id));
  }
  std::vector<int> first_cell{0};
  for (const ElementBlock& block : share.mesh.blocks) first_cell.push_back(first_cell.back() + block.cells());
  for (const SideSet& set : share.mesh.side_sets) {
    std::vector<int> pairs;  // a cell's id, a side
    for (const Side& side : set.sides) {
      const int cell = first_cell[static_cast<std::size_t>(side.block)] + side.cell;
      pairs.insert(pairs.end(), {share.description.cell_ids[static_cast<std::size_t>(cell)], side.side});
    }
    pairs = gather(pairs, comm);
    std::vector<std::pair<int, int>> sorted;
    for (std::size_t i = 0; i < pairs.size(); i += 2) sorted.emplace_back(pairs[i], pairs[i + 1]);
    std::sort(sorted.begin(), sorted.end());
    SideSet& here = whole.mesh.side_sets.emplace_back();
    here.name = set.name;
    for (const auto& [id, side] : sorted) here.sides.push_back({cells.at(id).block, cells.at(id).cell, side});
  }
}

}  // namespace

GatheredMesh gathered(const OutputMesh& share, const Comm& comm) {
  GatheredMesh whole;
  whole.mesh.dimension = share.mesh.dimension;
  const Numbers nodes = gather_nodes(share, comm, whole);
  gather_sets(share, comm, nodes, gather_cells(share, comm, nodes, whole), whole);
  return whole;
}

}  // namespace ixos
