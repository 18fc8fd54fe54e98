// The ranks' output meshes, gathered: the mesh that was distributed, whatever the number of ranks.
#include "io/gathered_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <tuple>

#include "io/hdf5_fields_fixture.hpp"
#include "mesh/cell_order.hpp"

namespace ixos {
namespace {

using test::self;
using test::two_blocks;
using test::world;

GatheredMesh distributed_and_gathered(const Mesh& mesh, const Comm& comm) {
  const int ranks = comm->getSize();
  const LocalMesh local = localize(mesh, partition_nodes(mesh, ranks), comm->getRank(), ranks);
  return gathered(OutputMesh(local, ranks), comm);
}

std::vector<int> from_one(int last) {
  std::vector<int> numbers(static_cast<std::size_t>(last));
  std::iota(numbers.begin(), numbers.end(), 1);
  return numbers;
}

using Place = std::tuple<int, int, int>;

std::vector<Place> places(const SideSet& set) {
  std::vector<Place> result;
  result.reserve(set.sides.size());
  for (const Side& side : set.sides) result.emplace_back(side.block, side.cell, side.side);
  return result;
}

TEST(GatheredMeshTest, APlainMeshComesBackInTheOrderOfItsNumbers) {
  for (const auto& [dimension, order] : {std::pair{2, 1}, std::pair{3, 1}, std::pair{2, 2}, std::pair{3, 2}}) {
    Mesh mesh = two_blocks(dimension, false);
    if (order == 2) raise_order(mesh);
    const GatheredMesh whole = distributed_and_gathered(mesh, world());
    EXPECT_EQ(whole.mesh.dimension, dimension);
    if (world()->getRank() > 0) {
      EXPECT_EQ(whole.mesh.nodes(), 0) << "the first rank alone has the mesh";
      EXPECT_EQ(whole.mesh.cells(), 0);
      continue;
    }
    EXPECT_EQ(whole.description.node_ids, from_one(mesh.nodes()));
    EXPECT_EQ(whole.description.cell_ids, from_one(mesh.cells()));
    EXPECT_EQ(whole.mesh.coordinates, mesh.coordinates);
    ASSERT_EQ(whole.mesh.blocks.size(), mesh.blocks.size());
    for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
      EXPECT_EQ(whole.mesh.blocks[b].name, mesh.blocks[b].name);
      EXPECT_EQ(whole.mesh.blocks[b].type, mesh.blocks[b].type);
      EXPECT_EQ(whole.mesh.blocks[b].nodes, mesh.blocks[b].nodes) << mesh.blocks[b].name;
    }
    ASSERT_EQ(whole.mesh.side_sets.size(), mesh.side_sets.size());
    for (std::size_t s = 0; s < mesh.side_sets.size(); ++s) {
      EXPECT_EQ(whole.mesh.side_sets[s].name, mesh.side_sets[s].name);
      std::vector<Place> expected = places(mesh.side_sets[s]);
      std::sort(expected.begin(), expected.end());
      EXPECT_EQ(places(whole.mesh.side_sets[s]), expected) << mesh.side_sets[s].name;
    }
    ASSERT_EQ(whole.mesh.node_sets.size(), mesh.node_sets.size());
    for (std::size_t s = 0; s < mesh.node_sets.size(); ++s) {
      const std::string& name = mesh.node_sets[s].name;
      const bool taken = std::any_of(mesh.side_sets.begin(), mesh.side_sets.end(),
                                     [&](const SideSet& set) { return set.name == name; });
      EXPECT_EQ(whole.mesh.node_sets[s].name, taken ? name + "_nodes" : name);
      std::vector<int> expected = mesh.node_sets[s].nodes;
      std::sort(expected.begin(), expected.end());
      EXPECT_EQ(whole.mesh.node_sets[s].nodes, expected) << mesh.node_sets[s].name;
    }
  }
}

/// The area of a mesh of quadrilaterals.
double area(const Mesh& mesh) {
  double sum = 0;
  for (const ElementBlock& block : mesh.blocks)
    for (int cell = 0; cell < block.cells(); ++cell)
      for (int a = 0; a < 4; ++a) {
        const auto n = 2 * static_cast<std::size_t>(block.nodes[cell_entry(cell, 4, a)]);
        const auto m = 2 * static_cast<std::size_t>(block.nodes[cell_entry(cell, 4, (a + 1) % 4)]);
        sum += (mesh.coordinates[n] * mesh.coordinates[m + 1] - mesh.coordinates[m] * mesh.coordinates[n + 1]) / 2;
      }
  return sum;
}

// Enriched cells are shown as several cells with nodes of their own, whose numbers leave gaps.
TEST(GatheredMeshTest, AnEnrichedMeshIsThatOfASingleRank) {
  for (int dimension : {2, 3}) {
    const Mesh mesh = two_blocks(dimension, true);
    const GatheredMesh whole = distributed_and_gathered(mesh, world());
    if (world()->getRank() > 0) continue;
    const GatheredMesh alone = distributed_and_gathered(mesh, self());
    EXPECT_GT(whole.mesh.cells(), mesh.cells());
    const std::vector<int>& ids = whole.description.node_ids;
    EXPECT_TRUE(std::adjacent_find(ids.begin(), ids.end(), std::greater_equal<>()) == ids.end())
        << "numbers rise and none comes twice";
    EXPECT_EQ(ids.size(), static_cast<std::size_t>(whole.mesh.nodes()));
    if (dimension == 2) {
      EXPECT_NEAR(area(whole.mesh), 4 * 2, 1e-13);
    }
    EXPECT_EQ(ids, alone.description.node_ids);
    EXPECT_EQ(whole.description.cell_ids, alone.description.cell_ids);
    EXPECT_EQ(whole.mesh.coordinates, alone.mesh.coordinates);
    ASSERT_EQ(whole.mesh.blocks.size(), alone.mesh.blocks.size());
    for (std::size_t b = 0; b < alone.mesh.blocks.size(); ++b)
      EXPECT_EQ(whole.mesh.blocks[b].nodes, alone.mesh.blocks[b].nodes) << alone.mesh.blocks[b].name;
    for (std::size_t s = 0; s < alone.mesh.side_sets.size(); ++s)
      EXPECT_EQ(places(whole.mesh.side_sets[s]), places(alone.mesh.side_sets[s])) << alone.mesh.side_sets[s].name;
    for (std::size_t s = 0; s < alone.mesh.node_sets.size(); ++s)
      EXPECT_EQ(whole.mesh.node_sets[s].nodes, alone.mesh.node_sets[s].nodes) << alone.mesh.node_sets[s].name;
  }
}

}  // namespace
}  // namespace ixos
