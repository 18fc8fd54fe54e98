#include "mesh/distributed_cells.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "base/agreement.hpp"
#include "base/all_to_all.hpp"
#include "base/error.hpp"

namespace ixos {
namespace {

std::size_t nodes_of_cells(const DistributedMesh& mesh) {
  return static_cast<std::size_t>(nodes_per_cell(cell_type(mesh)));
}

/// The owners of nodes by their ids.
using Owners = std::map<long long, int>;

Owners find_owners(const DistributedMesh& mesh, const NodeDirectory& directory, const Comm& comm) {
  std::set<long long> ids;
  for (const DistributedBlock& block : mesh.blocks) ids.insert(block.nodes.begin(), block.nodes.end());
  Owners owners;
  for (const NodeEntry& entry : directory.find({ids.begin(), ids.end()})) owners.emplace(entry.id, entry.owner);
  together<InputError>(comm, [&] {
    for (const DistributedBlock& block : mesh.blocks)
      for (std::size_t k = 0; k < block.nodes.size(); ++k)
        if (owners.at(block.nodes[k]) < 0)
          throw InputError(fmt::format("block \"{}\": cell {} of rank {} has node {}, which no rank owns", block.name,
                                       k / nodes_of_cells(mesh), comm->getRank(), block.nodes[k]));
  });
  return owners;
}

/// Returns, by block, the number of this rank's first cell; sets the numbers of cells of all ranks.
std::vector<long long> first_numbers(const DistributedMesh& mesh, const Comm& comm, std::vector<int>& global) {
  std::vector<long long> mine, until, total;
  for (const DistributedBlock& block : mesh.blocks)
    mine.push_back(static_cast<long long>(block.nodes.size() / nodes_of_cells(mesh)));
  until.resize(mine.size());
  total.resize(mine.size());
  const auto count = static_cast<int>(mine.size());
  Teuchos::scan(*comm, Teuchos::REDUCE_SUM, count, mine.data(), until.data());
  Teuchos::reduceAll(*comm, Teuchos::REDUCE_SUM, count, mine.data(), total.data());
  for (std::size_t b = 0; b < mine.size(); ++b) {
    if (total[b] == 0) throw InputError("block \"" + mesh.blocks[b].name + "\" has no cells on any rank");
    if (total[b] > std::numeric_limits<int>::max())
      throw InputError(fmt::format("block \"{}\" has {} cells; at most {} are allowed", mesh.blocks[b].name, total[b],
                                   std::numeric_limits<int>::max()));
    global.push_back(static_cast<int>(total[b]));
    until[b] -= mine[b];
  }
  return until;
}

/// Throws InputError for two cells with the same corners: each rank that owns one of these has received both.
void refuse_repeated_cells(const TouchingCells& touching, int corners) {
  std::set<std::vector<long long>> seen;
  for (const SentCell& cell : touching.cells) {
    std::vector<long long> nodes(touching.nodes_of(cell), touching.nodes_of(cell) + corners);
    std::sort(nodes.begin(), nodes.end());
    if (seen.insert(nodes).second) continue;
    throw InputError(
        fmt::format("two cells have the nodes {}; one rank must have the cell, once", fmt::join(nodes, ", ")));
  }
}

}  // namespace

TouchingCells touching_cells(const DistributedMesh& mesh, const NodeDirectory& directory, const Comm& comm) {
  const Owners owners = find_owners(mesh, directory, comm);
  TouchingCells result;
  const std::vector<long long> first = first_numbers(mesh, comm, result.global_cells);

  const auto ranks = static_cast<std::size_t>(comm->getSize());
  const std::size_t n = nodes_of_cells(mesh);
  std::vector<std::vector<SentCell>> cells(ranks);
  std::vector<std::vector<long long>> ids(ranks);
  std::vector<std::vector<SentSide>> sides(ranks);
  std::vector<std::vector<std::set<int>>> destinations;  // by block and cell
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const std::vector<long long>& nodes = mesh.blocks[b].nodes;
    destinations.emplace_back(nodes.size() / n);
    for (std::size_t cell = 0; cell < nodes.size() / n; ++cell) {
      const auto own = nodes.begin() + static_cast<std::ptrdiff_t>(cell * n);
      for (std::size_t a = 0; a < n; ++a) destinations[b][cell].insert(owners.at(nodes[cell * n + a]));
      for (const int rank : destinations[b][cell]) {
        const auto to = static_cast<std::size_t>(rank);
        cells[to].push_back({static_cast<int>(b), static_cast<int>(first[b] + static_cast<long long>(cell)), 0});
        ids[to].insert(ids[to].end(), own, own + static_cast<std::ptrdiff_t>(n));
      }
    }
  }
  for (std::size_t set = 0; set < mesh.side_sets.size(); ++set)
    for (const Side& side : mesh.side_sets[set].sides) {
      const auto b = static_cast<std::size_t>(side.block);
      const SentSide sent{static_cast<int>(set), side.block, static_cast<int>(first[b] + side.cell), side.side};
      for (const int rank : destinations[b][static_cast<std::size_t>(side.cell)])
        sides[static_cast<std::size_t>(rank)].push_back(sent);
    }

  result.cells = joined(all_to_all(cells, comm));
  result.nodes = joined(all_to_all(ids, comm));
  for (std::size_t k = 0; k < result.cells.size(); ++k) result.cells[k].first = k * n;
  result.sides = joined(all_to_all(sides, comm));
  std::sort(result.cells.begin(), result.cells.end(), [](const SentCell& a, const SentCell& b) {
    return std::pair(a.block, a.number) < std::pair(b.block, b.number);
  });
  std::sort(result.sides.begin(), result.sides.end(), [](const SentSide& a, const SentSide& b) {
    return std::tie(a.set, a.block, a.cell, a.side) < std::tie(b.set, b.block, b.cell, b.side);
  });
  together<InputError>(comm, [&] { refuse_repeated_cells(result, nodes_per_cell(corner_type(cell_type(mesh)))); });
  return result;
}

}  // namespace ixos
