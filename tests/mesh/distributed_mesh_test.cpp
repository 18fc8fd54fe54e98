#include "mesh/distributed_mesh.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <tuple>

#include "mesh/cell_order.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/partition.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::expect_contains;
using test::refusal;

/// Ids with gaps, in the order of the nodes.
long long id_of(int node) { return 100 + 3LL * node; }

/// Returns this rank's share of the mesh. `owner` has the rank of each node; the owner of a cell's last node has the
/// cell.
DistributedMesh share_of(const Mesh& mesh, const std::vector<int>& owner) {
  const int rank = test::world()->getRank();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  DistributedMesh share;
  share.dimension = mesh.dimension;
  share.order = is_quadratic(mesh.blocks[0].type) ? 2 : 1;
  for (int node = 0; node < mesh.nodes(); ++node) {
    if (owner[static_cast<std::size_t>(node)] != rank) continue;
    share.nodes.push_back(id_of(node));
    for (std::size_t i = 0; i < d; ++i)
      share.coordinates.push_back(mesh.coordinates[static_cast<std::size_t>(node) * d + i]);
  }
  std::vector<std::vector<int>> here;  // by block: the cell's number in this share, or -1
  for (const ElementBlock& block : mesh.blocks) {
    const int n = nodes_per_cell(block.type);
    share.blocks.push_back({block.name, {}});
    here.emplace_back(static_cast<std::size_t>(block.cells()), -1);
    int cells = 0;
    for (int cell = 0; cell < block.cells(); ++cell) {
      const int last = block.nodes[cell_entry(cell, n, n - 1)];
      if (owner[static_cast<std::size_t>(last)] != rank) continue;
      here.back()[static_cast<std::size_t>(cell)] = cells++;
      for (int a = 0; a < n; ++a) share.blocks.back().nodes.push_back(id_of(block.nodes[cell_entry(cell, n, a)]));
    }
  }
  for (const SideSet& set : mesh.side_sets) {
    share.side_sets.push_back({set.name, {}});
    for (const Side& side : set.sides)
      if (const int cell = here[static_cast<std::size_t>(side.block)][static_cast<std::size_t>(side.cell)]; cell >= 0)
        share.side_sets.back().sides.push_back({side.block, cell, side.side});
  }
  for (const NodeSet& set : mesh.node_sets) {
    share.node_sets.push_back({set.name, {}});
    if (rank == 0)  // of nodes that other ranks own, too
      for (const int node : set.nodes) share.node_sets.back().nodes.push_back(id_of(node));
  }
  return share;
}

/// A cell or a side: its nodes, and whether it is counted here.
using Counted = std::multiset<std::tuple<std::string, std::vector<int>, int>>;

Counted cells_of(const LocalMesh& mesh) {
  Counted cells;
  for (const LocalBlock& block : mesh.blocks) {
    const int n = nodes_per_cell(block.type);
    for (int cell = 0; cell < block.cells(); ++cell)
      cells.emplace(block.name, std::vector<int>(block.nodes.begin() + cell * n, block.nodes.begin() + (cell + 1) * n),
                    block.owned[static_cast<std::size_t>(cell)]);
  }
  return cells;
}

Counted sides_of(const LocalMesh& mesh) {
  Counted sides;
  for (std::size_t set = 0; set < mesh.side_sets.size(); ++set)
    for (const LocalSide& side : mesh.side_sets[set]) sides.emplace(mesh.side_set_names[set], side.nodes, side.owned);
  return sides;
}

std::vector<std::vector<int>> sorted(std::vector<std::vector<int>> sets) {
  for (std::vector<int>& set : sets) std::sort(set.begin(), set.end());
  return sets;
}

/// Two blocks in the plane, and a brick, of linear and of quadratic cells.
std::vector<Mesh> meshes() {
  BoxShape plane, brick;
  plane.divisions = {4, 4, 1};
  brick.dimension = 3;
  brick.divisions = {3, 2, 4};
  Mesh two = box(plane);
  const std::vector<int> lower = two.blocks[0].nodes;
  two.blocks.push_back({"upper", CellType::Quad4, std::vector<int>(lower.begin() + 32, lower.end())});
  two.blocks[0].nodes.resize(32);
  for (SideSet& set : two.side_sets)
    for (Side& side : set.sides)
      if (side.cell >= 8) side = {1, side.cell - 8, side.side};
  std::vector<Mesh> all{two, box(brick), two, box(brick)};
  raise_order(all[2]);
  raise_order(all[3]);
  return all;
}

TEST(DistributedMeshTest, ItsPartsAreThoseOfTheWholeMesh) {
  const Comm comm = test::world();
  for (const Mesh& mesh : meshes()) {
    std::vector<int> dealt;
    for (int node = 0; node < mesh.nodes(); ++node) dealt.push_back(node % comm->getSize());
    const std::vector<int> one(dealt.size(), 0);  // the other ranks have nothing
    for (const std::vector<int>& owner : {partition_nodes(mesh, comm->getSize()), dealt, one}) {
      const LocalMesh whole = localize(mesh, owner, comm->getRank(), comm->getSize());
      const LocalMesh part = local_part(share_of(mesh, owner), comm);
      EXPECT_EQ(part.dimension, whole.dimension);
      EXPECT_EQ(part.owned_nodes, whole.owned_nodes);
      EXPECT_EQ(part.global_nodes, whole.global_nodes);
      EXPECT_EQ(part.global_cells, whole.global_cells);
      EXPECT_EQ(part.global_ids, whole.global_ids);
      EXPECT_EQ(part.original_ids, whole.original_ids);
      EXPECT_EQ(part.coordinates, whole.coordinates);
      EXPECT_EQ(cells_of(part), cells_of(whole));
      EXPECT_EQ(part.side_set_names, whole.side_set_names);
      EXPECT_EQ(sides_of(part), sides_of(whole));
      EXPECT_EQ(part.node_set_names, whole.node_set_names);
      EXPECT_EQ(sorted(part.node_sets), sorted(whole.node_sets));
      for (std::size_t b = 0; b < part.blocks.size(); ++b)
        EXPECT_EQ(part.blocks[b].global_cells, whole.blocks[b].global_cells);
      for (std::size_t node = 0; node < static_cast<std::size_t>(part.nodes()); ++node) {
        EXPECT_EQ(part.program_id(node), id_of(whole.original_ids[node]));
        EXPECT_EQ(part.message_number(node), part.program_id(node));
        EXPECT_EQ(whole.program_id(node), whole.original_ids[node]);
        EXPECT_EQ(whole.message_number(node), whole.original_ids[node] + 1);
      }
    }
  }
}

TEST(DistributedMeshTest, TheNumbersOfCellsAreThoseOfTheirBlock) {
  const Comm comm = test::world();
  const Mesh mesh = meshes()[0];
  const LocalMesh part = local_part(share_of(mesh, partition_nodes(mesh, comm->getSize())), comm);
  for (const LocalBlock& block : part.blocks) {
    double owned = 0, sum = 0;
    for (std::size_t cell = 0; cell < block.owned.size(); ++cell) {
      EXPECT_GE(block.original_cells[cell], 0);
      if (block.owned[cell] != 0) {
        ++owned;
        sum += block.original_cells[cell];
      }
    }
    double all[2] = {0, 0};
    const double mine[2] = {owned, sum};
    Teuchos::reduceAll(*comm, Teuchos::REDUCE_SUM, 2, mine, all);
    EXPECT_EQ(all[0], block.global_cells);
    EXPECT_EQ(all[1], block.global_cells * (block.global_cells - 1) / 2);  // 0 + 1 + 2 + ...
  }
}

TEST(DistributedMeshTest, ItsNodesMayHaveAnyOrder) {
  const Comm comm = test::world();
  const Mesh mesh = meshes()[0];
  DistributedMesh share = share_of(mesh, partition_nodes(mesh, comm->getSize()));
  std::reverse(share.nodes.begin(), share.nodes.end());
  std::vector<double> reversed;
  for (std::size_t i = share.nodes.size(); i-- > 0;)
    reversed.insert(reversed.end(), {share.coordinates[2 * i], share.coordinates[2 * i + 1]});
  share.coordinates = reversed;
  const LocalMesh part = local_part(share, comm);
  for (std::size_t node = 0; node < share.nodes.size(); ++node) EXPECT_EQ(part.program_ids[node], share.nodes[node]);
  for (std::size_t node = 0; node < static_cast<std::size_t>(part.nodes()); ++node)
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_EQ(part.coordinates[2 * node + i],
                mesh.coordinates[static_cast<std::size_t>((part.program_ids[node] - 100) / 3) * 2 + i]);
}

using Spoil = std::function<void(DistributedMesh&)>;

/// Returns why a mesh is refused after `spoil` has changed it; empty if it is not.
std::string refusal_of(DistributedMesh share, const Spoil& spoil, const Comm& comm) {
  spoil(share);
  return refusal([&] { local_part(share, comm); });
}

TEST(DistributedMeshTest, UnsoundMeshesAreRefusedOnAllRanks) {
  const Comm comm = test::world();
  const Mesh mesh = meshes()[0];
  const DistributedMesh sound = share_of(mesh, partition_nodes(mesh, comm->getSize()));
  const bool first = comm->getRank() == 0;
  const auto message = [&](const Spoil& spoil) { return refusal_of(sound, spoil, comm); };
  EXPECT_EQ(message([](DistributedMesh&) {}), "");
  expect_contains(message([&](DistributedMesh& m) { m.dimension = 4; }), "the mesh has 4 dimensions");
  expect_contains(message([&](DistributedMesh& m) {
                    if (first) m.coordinates.pop_back();
                  }),
                  "in 2 dimensions");
  expect_contains(message([&](DistributedMesh& m) {
                    if (first) m.coordinates[0] = NAN;
                  }),
                  "must be finite");
  expect_contains(message([&](DistributedMesh& m) {
                    if (first) m.nodes[0] = -3;
                  }),
                  "the id -3; ids are at least 0");
  expect_contains(message([&](DistributedMesh& m) {
                    if (first) m.nodes[0] = m.nodes[1];
                  }),
                  "is owned twice");
  expect_contains(message([&](DistributedMesh& m) {
                    if (first) m.blocks[0].nodes[2] = 99999;
                  }),
                  "block \"body\": cell 0 of rank 0 has node 99999, which no rank owns");
  expect_contains(message([&](DistributedMesh& m) {
                    if (first) m.blocks[0].nodes.pop_back();
                  }),
                  "are not those of cells with 4 nodes");
  expect_contains(message([&](DistributedMesh& m) {
                    if (first)
                      m.blocks[0].nodes.insert(m.blocks[0].nodes.end(), m.blocks[0].nodes.begin(),
                                               m.blocks[0].nodes.begin() + 4);
                  }),
                  "two cells have the nodes ");
  expect_contains(message([&](DistributedMesh& m) {
                    if (first) std::swap(m.blocks[0].nodes[1], m.blocks[0].nodes[3]);
                  }),
                  "block \"body\", the cell with nodes ");
  expect_contains(message([&](DistributedMesh& m) {
                    if (!first) return;
                    m.nodes.push_back(7);
                    m.coordinates.insert(m.coordinates.end(), {0, 0});
                  }),
                  "node 7 belongs to no cell");
  expect_contains(message([&](DistributedMesh& m) {
                    if (first) m.node_sets[1].nodes.push_back(5);
                  }),
                  "has node 5, which no rank owns");
  expect_contains(message([&](DistributedMesh& m) {
                    if (first) m.side_sets[0].sides.push_back({0, 0, 4});
                  }),
                  "has side 4 of cell 0 of block 0, which does not exist");
  expect_contains(message([&](DistributedMesh& m) { m.blocks[0].name = "upper"; }), "two blocks have the name");
  expect_contains(message([&](DistributedMesh& m) {
                    m.blocks.push_back({"empty", {}});
                  }),
                  "block \"empty\" has no cells on any rank");
  if (comm->getSize() > 1)
    expect_contains(message([&](DistributedMesh& m) {
                      if (!first) m.blocks[1].name = "other";
                    }),
                    "all ranks must list the same blocks and sets in the same order");
}

TEST(DistributedMeshTest, UnsoundQuadraticCellsAreRefusedOnAllRanks) {
  const Comm comm = test::world();
  const Mesh mesh = meshes()[2];
  const DistributedMesh sound = share_of(mesh, partition_nodes(mesh, comm->getSize()));
  const bool first = comm->getRank() == 0;
  const auto message = [&](const Spoil& spoil) { return refusal_of(sound, spoil, comm); };
  EXPECT_EQ(message([](DistributedMesh&) {}), "");
  expect_contains(message([](DistributedMesh& m) { m.order = 3; }), "cells have order 3; 1 or 2 are allowed");
  expect_contains(message([&](DistributedMesh& m) {
                    if (first) m.blocks[0].nodes.pop_back();
                  }),
                  "are not those of cells with 9 nodes");
  // A second node in the middle of the right side of a cell: the body opens there.
  expect_contains(message([&](DistributedMesh& m) {
                    if (!first) return;
                    const int block = m.blocks[0].nodes.empty() ? 1 : 0;
                    long long& middle = m.blocks[static_cast<std::size_t>(block)].nodes[5];
                    const auto x = mesh.coordinates.begin() + 2 * (middle - 100) / 3;
                    const long long fresh = 90000;
                    m.nodes.push_back(fresh);
                    m.coordinates.insert(m.coordinates.end(), {*x, *(x + 1)});
                    middle = fresh;
                  }),
                  "in its middle");
  if (comm->getSize() > 1)
    expect_contains(message([&](DistributedMesh& m) {
                      if (first) return;
                      m.order = 1;
                      for (DistributedBlock& block : m.blocks) block.nodes.clear();
                      for (SideSet& set : m.side_sets) set.sides.clear();
                    }),
                    "cells of order 2");
}

TEST(LocalPartTest, OfAWholeMeshIsThatOfItsPartition) {
  const Comm comm = test::world();
  const Mesh mesh = meshes()[1];
  const LocalMesh part = local_part(mesh, comm);
  EXPECT_EQ(part.global_ids,
            localize(mesh, partition_nodes(mesh, comm->getSize()), comm->getRank(), comm->getSize()).global_ids);
  std::vector<int> dealt;
  for (int node = 0; node < mesh.nodes(); ++node) dealt.push_back(node % comm->getSize());
  EXPECT_EQ(local_part(mesh, dealt, comm).global_ids,
            localize(mesh, dealt, comm->getRank(), comm->getSize()).global_ids);
  dealt[3] = comm->getSize();
  expect_contains(refusal([&] { local_part(mesh, dealt, comm); }), "node 3 is owned by rank");
  dealt.pop_back();
  expect_contains(refusal([&] { local_part(mesh, dealt, comm); }), "59 nodes have owners, but the mesh has 60 nodes");
  Mesh inverted = mesh;
  std::swap(inverted.blocks[0].nodes[0], inverted.blocks[0].nodes[4]);
  expect_contains(refusal([&] { local_part(inverted, comm); }), "cell 1 at (0.166667, 0.25, 0.125): inverted");
  Mesh unknown = mesh;
  unknown.blocks[0].nodes[0] = 60;
  expect_contains(refusal([&] { local_part(unknown, comm); }), "has node 60");
}

TEST(LocalPartTest, RanksThatPassDifferentMeshesAreRefused) {
  const Comm comm = test::world();
  const Mesh mesh = meshes()[1];
  const bool last = comm->getRank() == comm->getSize() - 1;
  const std::vector<int> owner = partition_nodes(mesh, comm->getSize());
  const auto message = [&](auto change) {
    Mesh changed = mesh;
    std::vector<int> owners = owner;
    if (last) change(changed, owners);
    return refusal([&] { local_part(changed, owners, comm); });
  };
  EXPECT_EQ(message([](Mesh&, std::vector<int>&) {}), "");
  if (comm->getSize() == 1) return;
  const std::string words = fmt::format("rank {} has another mesh, or other owners", comm->getSize() - 1);
  expect_contains(message([](Mesh& m, std::vector<int>&) { m.coordinates[0] += 1e-9; }), words);
  expect_contains(message([](Mesh& m, std::vector<int>&) { m.node_sets[0].nodes.pop_back(); }), words);
  expect_contains(message([](Mesh& m, std::vector<int>&) { m.side_sets[0].sides.pop_back(); }), words);
  expect_contains(message([](Mesh&, std::vector<int>& o) { std::swap(o.front(), o.back()); }), words);
  Mesh share = mesh;  // no share of a mesh is a whole one
  if (last) share.coordinates.resize(4);
  expect_contains(refusal([&] { local_part(share, comm); }), words);
}

}  // namespace
}  // namespace ixos
