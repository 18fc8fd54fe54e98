#include "mesh/local_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "mesh/generators/shapes.hpp"
#include "mesh/partition.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

using Nodes = std::vector<int>;

/// A rectangle whose upper half is a block of its own.
Mesh two_blocks() {
  BoxShape shape;
  shape.divisions = {4, 4, 1};
  Mesh mesh = box(shape);
  Nodes& lower = mesh.blocks[0].nodes;
  mesh.blocks.push_back({"upper", CellType::Quad4, Nodes(lower.begin() + 32, lower.end())});
  mesh.blocks[0].nodes.resize(32);
  for (SideSet& set : mesh.side_sets)
    for (Side& side : set.sides)
      if (side.cell >= 8) side = {1, side.cell - 8, side.side};
  return mesh;
}

Mesh brick() {
  BoxShape shape;
  shape.dimension = 3;
  shape.divisions = {3, 2, 4};
  return box(shape);
}

/// Calls check(mesh, owner of each node, the parts of all ranks) for several meshes, on one to three ranks, with the
/// nodes partitioned by METIS and dealt out like cards: then nearly every cell touches every rank.
template <class Check>
void for_each_partition(Check check) {
  for (const Mesh& mesh : {disk({}), two_blocks(), brick()})
    for (int ranks : {1, 2, 3}) {
      Nodes dealt;
      for (int node = 0; node < mesh.nodes(); ++node) dealt.push_back(node % ranks);
      for (const Nodes& owner : {partition_nodes(mesh, ranks), dealt}) {
        SCOPED_TRACE(testing::Message() << mesh.nodes() << " nodes on " << ranks << " ranks");
        std::vector<LocalMesh> parts;
        for (int rank = 0; rank < ranks; ++rank) parts.push_back(localize(mesh, owner, rank, ranks));
        check(mesh, owner, parts);
      }
    }
}

/// Numbers in the mesh of a cell's nodes.
Nodes cell_of(const ElementBlock& block, int cell) {
  const int n = nodes_per_cell(block.type);
  return {block.nodes.begin() + cell * n, block.nodes.begin() + (cell + 1) * n};
}

Nodes cell_of(const LocalMesh& part, const LocalBlock& block, int cell) {
  const int n = nodes_per_cell(block.type);
  Nodes nodes;
  for (int i = cell * n; i < (cell + 1) * n; ++i)
    nodes.push_back(part.original_ids.at(static_cast<std::size_t>(block.nodes.at(static_cast<std::size_t>(i)))));
  return nodes;
}

TEST(LocalizeTest, OwnedNodesComeFirstAndEveryNodeIsOwnedOnce) {
  for_each_partition([](const Mesh& mesh, const Nodes& owner, const std::vector<LocalMesh>& parts) {
    std::multiset<int> owned;
    for (std::size_t rank = 0; rank < parts.size(); ++rank) {
      const LocalMesh& part = parts[rank];
      EXPECT_EQ(part.global_nodes, mesh.nodes());
      EXPECT_EQ(part.global_cells, mesh.cells());
      for (int i = 0; i < part.nodes(); ++i) {
        const int node = part.original_ids.at(static_cast<std::size_t>(i));
        EXPECT_EQ(owner[static_cast<std::size_t>(node)] == static_cast<int>(rank), i < part.owned_nodes);
        if (i < part.owned_nodes) owned.insert(node);
      }
    }
    EXPECT_EQ(owned.size(), static_cast<std::size_t>(mesh.nodes()));
    for (int node = 0; node < mesh.nodes(); ++node) EXPECT_EQ(owned.count(node), 1u) << node;
  });
}

TEST(LocalizeTest, GlobalNumbersAreConsecutiveAndGhostsAgreeWithTheirOwner) {
  for_each_partition([](const Mesh& mesh, const Nodes&, const std::vector<LocalMesh>& parts) {
    const auto dim = static_cast<std::size_t>(mesh.dimension);
    std::map<int, long long> number;  // by the owners
    long long next = 0;
    for (const LocalMesh& part : parts)
      for (std::size_t i = 0; i < static_cast<std::size_t>(part.owned_nodes); ++i) {
        EXPECT_EQ(part.global_ids.at(i), next++);
        number[part.original_ids.at(i)] = part.global_ids.at(i);
      }
    for (const LocalMesh& part : parts)
      for (std::size_t i = 0; i < part.global_ids.size(); ++i) {
        const int node = part.original_ids.at(i);
        EXPECT_EQ(part.global_ids[i], number.at(node));
        for (std::size_t d = 0; d < dim; ++d)
          EXPECT_EQ(part.coordinates.at(i * dim + d), mesh.coordinates.at(static_cast<std::size_t>(node) * dim + d));
      }
  });
}

TEST(LocalizeTest, CellsAreThoseThatTouchAnOwnedNodeAndGhostsTheirOtherNodes) {
  for_each_partition([](const Mesh& mesh, const Nodes& owner, const std::vector<LocalMesh>& parts) {
    for (std::size_t rank = 0; rank < parts.size(); ++rank) {
      const LocalMesh& part = parts[rank];
      ASSERT_EQ(part.blocks.size(), mesh.blocks.size());
      std::set<int> nodes;
      for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
        std::multiset<Nodes> expected, found;
        for (int cell = 0; cell < mesh.blocks[b].cells(); ++cell) {
          const Nodes corners = cell_of(mesh.blocks[b], cell);
          const auto mine = [&](int node) { return owner[static_cast<std::size_t>(node)] == static_cast<int>(rank); };
          if (std::any_of(corners.begin(), corners.end(), mine)) expected.insert(corners);
        }
        for (int cell = 0; cell < part.blocks[b].cells(); ++cell) found.insert(cell_of(part, part.blocks[b], cell));
        EXPECT_EQ(found, expected);
        for (const Nodes& corners : found) nodes.insert(corners.begin(), corners.end());
      }
      // Every node of these meshes has a cell: the local nodes are those of the local cells, each once.
      EXPECT_EQ(nodes, std::set<int>(part.original_ids.begin(), part.original_ids.end()));
      EXPECT_EQ(nodes.size(), part.original_ids.size());
    }
  });
}

TEST(LocalizeTest, OwnedCellsPartitionTheCells) {
  for_each_partition([](const Mesh& mesh, const Nodes&, const std::vector<LocalMesh>& parts) {
    std::multiset<Nodes> all, owned;
    for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
      for (int cell = 0; cell < mesh.blocks[b].cells(); ++cell) all.insert(cell_of(mesh.blocks[b], cell));
      for (const LocalMesh& part : parts)
        for (int cell = 0; cell < part.blocks.at(b).cells(); ++cell)
          if (part.blocks[b].owned[static_cast<std::size_t>(cell)]) owned.insert(cell_of(part, part.blocks[b], cell));
    }
    EXPECT_EQ(owned, all);
  });
}

TEST(LocalizeTest, EverySideIsOwnedOnceWithItsCell) {
  for_each_partition([](const Mesh& mesh, const Nodes&, const std::vector<LocalMesh>& parts) {
    for (const SideSet& set : mesh.side_sets) {
      std::multiset<Nodes> all, owned;
      for (const Side& side : set.sides) {
        const ElementBlock& block = mesh.blocks[static_cast<std::size_t>(side.block)];
        const Nodes corners = cell_of(block, side.cell);
        Nodes nodes;
        for (int a : side_nodes(block.type, side.side)) nodes.push_back(corners.at(static_cast<std::size_t>(a)));
        all.insert(nodes);
      }
      for (const LocalMesh& part : parts)
        for (const LocalSide& side : part.side_sets.at(part.side_set(set.name))) {
          const LocalBlock& block = part.blocks.at(static_cast<std::size_t>(side.block));
          EXPECT_EQ(side.owned, block.owned.at(static_cast<std::size_t>(side.cell)) != 0);
          Nodes nodes;
          for (int node : side.nodes) nodes.push_back(part.original_ids.at(static_cast<std::size_t>(node)));
          const Nodes corners = cell_of(part, block, side.cell);
          for (int node : nodes) EXPECT_EQ(std::count(corners.begin(), corners.end(), node), 1);
          if (side.owned) owned.insert(nodes);
        }
      EXPECT_EQ(owned, all) << set.name;
    }
  });
}

TEST(LocalizeTest, NodeSetsHoldTheirLocalNodesGhostsIncluded) {
  for_each_partition([](const Mesh& mesh, const Nodes&, const std::vector<LocalMesh>& parts) {
    for (const NodeSet& set : mesh.node_sets)
      for (const LocalMesh& part : parts) {
        std::multiset<int> expected, found;
        for (int node : part.original_ids)
          if (std::count(set.nodes.begin(), set.nodes.end(), node) > 0) expected.insert(node);
        for (int node : part.node_sets.at(part.node_set(set.name)))
          found.insert(part.original_ids.at(static_cast<std::size_t>(node)));
        EXPECT_EQ(found, expected) << set.name;
      }
  });
}

TEST(LocalMeshTest, MisspeltNamesAreRefusedWithTheNearest) {
  const Mesh mesh = disk({});
  const LocalMesh part = localize(mesh, partition_nodes(mesh, 1), 0, 1);
  EXPECT_EQ(test::refusal([&] { part.node_set("centre"); }),
            "node set \"centre\" does not exist; did you mean \"center\"? The mesh has \"surface\", \"center\"");
  EXPECT_EQ(test::refusal([&] { part.side_set("surfcae"); }),
            "side set \"surfcae\" does not exist; did you mean \"surface\"? The mesh has \"surface\"");
  EXPECT_EQ(test::refusal([] { LocalMesh{}.side_set("surface"); }),
            "side set \"surface\" does not exist. The mesh has none; Mesh/Sets can select one");
}

TEST(PartitionNodesTest, PartsAreBalancedWithinTenPercent) {
  BoxShape shape;
  shape.divisions = {29, 19, 1};
  const Mesh mesh = box(shape);
  for (int ranks : {1, 2, 3, 4}) {
    const Nodes owner = partition_nodes(mesh, ranks);
    ASSERT_EQ(owner.size(), 600u);
    for (int rank = 0; rank < ranks; ++rank)
      EXPECT_NEAR(static_cast<double>(std::count(owner.begin(), owner.end(), rank)), 600.0 / ranks, 60.0 / ranks);
  }
}

TEST(PartitionNodesTest, MoreRanksThanNodesLeaveRanksEmpty) {
  const Mesh mesh = box({});
  const std::vector<int> owner = partition_nodes(mesh, 5);
  ASSERT_EQ(owner.size(), 4U);
  for (int rank : owner) EXPECT_TRUE(rank >= 0 && rank < 5);
  const LocalMesh empty = localize(mesh, owner, 4, 5);
  EXPECT_EQ(empty.nodes(), 0);
  EXPECT_EQ(empty.blocks.at(0).cells(), 0);
}

}  // namespace
}  // namespace ixos
