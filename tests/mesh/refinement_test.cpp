// The coarse cells of halved cells: those of boxes and disks, in any numbering; none where cells come of no refinement.
#include "mesh/refinement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "mesh/cell_order.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/partition.hpp"

namespace ixos {
namespace {

Mesh block(int dimension, std::array<int, 3> divisions) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lengths = {1.0 * divisions[0], 1.0 * divisions[1], 1.0 * divisions[2]};
  shape.divisions = divisions;
  return box(shape);
}

/// Returns the mesh with its nodes and cells in another order, and each cell turned about some axis.
Mesh shuffled(const Mesh& mesh, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<int> number(static_cast<std::size_t>(mesh.nodes()));
  std::iota(number.begin(), number.end(), 0);
  std::shuffle(number.begin(), number.end(), random);
  Mesh result;
  result.dimension = mesh.dimension;
  const auto d = static_cast<std::size_t>(mesh.dimension);
  result.coordinates.resize(mesh.coordinates.size());
  for (std::size_t node = 0; node < number.size(); ++node)
    std::copy_n(&mesh.coordinates[node * d], d, &result.coordinates[static_cast<std::size_t>(number[node]) * d]);
  const std::vector<int> turn = d == 2 ? std::vector<int>{1, 2, 3, 0} : std::vector<int>{3, 2, 6, 7, 0, 1, 5, 4};
  ElementBlock shuffled = mesh.blocks.front();
  std::vector<int> order(static_cast<std::size_t>(shuffled.cells()));
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  shuffled.nodes.clear();
  for (const int cell : order) {
    std::vector<int> nodes;
    for (std::size_t a = 0; a < turn.size(); ++a)
      nodes.push_back(number[static_cast<std::size_t>(
          mesh.blocks.front().nodes[cell_entry(cell, static_cast<int>(turn.size()), static_cast<int>(a))])]);
    for (int times = static_cast<int>(random() % 4); times > 0; --times) {
      std::vector<int> turned;
      for (const int a : turn) turned.push_back(nodes[static_cast<std::size_t>(a)]);
      nodes = turned;
    }
    shuffled.nodes.insert(shuffled.nodes.end(), nodes.begin(), nodes.end());
  }
  result.blocks.push_back(shuffled);
  return result;
}

/// Compares the coarse cells with the cells of length 2 of a box, and each node with the mean of its corners.
void expect_box(const Mesh& mesh, int coarse_cells, int corners) {
  const auto refinement = find_refinement(mesh);
  ASSERT_TRUE(refinement.has_value());
  EXPECT_EQ(refinement->coarse.cells(), coarse_cells);
  EXPECT_EQ(refinement->coarse.nodes(), corners);
  EXPECT_TRUE(std::is_sorted(refinement->fine_node.begin(), refinement->fine_node.end()));
  const auto d = static_cast<std::size_t>(mesh.dimension);
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.nodes()); ++node) {
    const std::size_t begin = refinement->first_share[node], end = refinement->first_share[node + 1];
    std::size_t odd = 0;
    for (std::size_t i = 0; i < d; ++i) {
      const double x = mesh.coordinates[node * d + i];
      odd += std::lround(x) % 2 != 0 ? 1U : 0U;
      double mean = 0;
      for (std::size_t k = begin; k < end; ++k) {
        const double corner = refinement->coarse.coordinates[static_cast<std::size_t>(refinement->corner[k]) * d + i];
        EXPECT_LE(std::abs(corner - x), 1);
        mean += corner / static_cast<double>(end - begin);
      }
      EXPECT_EQ(mean, x);
    }
    EXPECT_EQ(end - begin, std::size_t{1} << odd);
  }
  // Coarse cells are cells in Exodus' order: edges of length 2 join their first corner with three others.
  const std::vector<int>& nodes = refinement->coarse.blocks.front().nodes;
  const auto n = std::size_t{1} << d;
  const auto place = [&](std::size_t entry, std::size_t i) {
    return refinement->coarse.coordinates[static_cast<std::size_t>(nodes[entry]) * d + i];
  };
  for (std::size_t first = 0; first < nodes.size(); first += n) {
    std::vector<std::pair<int, int>> edges{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
    if (d == 3) edges.insert(edges.end(), {{4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}});
    for (const auto& [a, b] : edges) {
      double distance = 0;
      for (std::size_t i = 0; i < d; ++i)
        distance +=
            std::abs(place(first + static_cast<std::size_t>(a), i) - place(first + static_cast<std::size_t>(b), i));
      EXPECT_EQ(distance, 2);
    }
  }
  std::vector<int> children(static_cast<std::size_t>(coarse_cells), 0);
  for (const int coarse_cell : refinement->coarse_cell.front()) ++children[static_cast<std::size_t>(coarse_cell)];
  EXPECT_EQ(children, std::vector<int>(static_cast<std::size_t>(coarse_cells), static_cast<int>(n)));
}

TEST(RefinementTest, BoxesOfEvenDivisionsHaveCoarseCells) {
  expect_box(block(2, {6, 4, 1}), 3 * 2, 4 * 3);
  expect_box(block(3, {6, 4, 2}), 3 * 2, 4 * 3 * 2);
  expect_box(block(3, {2, 2, 2}), 1, 8);
}

TEST(RefinementTest, NumbersAndOrientationsPlayNoPart) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    expect_box(shuffled(block(2, {6, 4, 1}), seed), 3 * 2, 4 * 3);
    expect_box(shuffled(block(3, {4, 4, 6}), seed), 2 * 2 * 3, 3 * 3 * 4);
  }
}

TEST(RefinementTest, OddDivisionsHaveNone) {
  EXPECT_FALSE(find_refinement(block(2, {3, 4, 1})).has_value());
  EXPECT_FALSE(find_refinement(block(3, {4, 4, 3})).has_value());
  EXPECT_FALSE(find_refinement(shuffled(block(3, {4, 5, 4}), 1)).has_value());
}

TEST(RefinementTest, OtherCellsHaveNone) {
  Mesh quadratic = block(3, {2, 2, 2});
  raise_order(quadratic);
  EXPECT_FALSE(find_refinement(quadratic).has_value());
  Mesh revolved = block(2, {2, 2, 1});
  revolved.axisymmetric = true;
  EXPECT_FALSE(find_refinement(revolved).has_value());
  Mesh enriched = block(2, {2, 2, 1});
  enriched.plain_nodes = enriched.nodes();
  EXPECT_FALSE(find_refinement(enriched).has_value());
  EXPECT_FALSE(find_refinement(Mesh{}).has_value());
}

/// A ring of two cells along its circumference: both coarse cells' ends would be one corner.
TEST(RefinementTest, ARingOfTwoCellsHasNone) {
  Mesh ring;
  ring.coordinates = {1, 0, 2, 0, 3, 0, -1, 0, -2, 0, -3, 0};
  ElementBlock cells;
  cells.nodes = {0, 1, 4, 3, 1, 2, 5, 4, 3, 4, 1, 0, 4, 5, 2, 1};
  ring.blocks.push_back(cells);
  EXPECT_FALSE(find_refinement(ring).has_value());
}

TEST(LocalRefinementTest, PartsHoldTheCoarseCellsOfAllLocalCells) {
  const Mesh mesh = shuffled(block(3, {4, 4, 4}), 4);
  const Refinement refinement = *find_refinement(mesh);
  for (const int ranks : {1, 2, 3}) {
    const std::vector<int> owner = partition_nodes(mesh, ranks);
    std::set<long long> owned;
    for (int rank = 0; rank < ranks; ++rank) {
      const LocalMesh fine = localize(mesh, owner, rank, ranks);
      const LocalRefinement part = localize(refinement, owner, rank, ranks, fine);
      EXPECT_EQ(part.coarse.global_nodes, 27);
      for (int node = 0; node < part.coarse.owned_nodes; ++node)
        EXPECT_TRUE(owned.insert(part.coarse.global_ids[static_cast<std::size_t>(node)]).second);
      int next = 0;
      for (std::size_t node = 0; node < part.number.size(); ++node) {
        std::array<double, 3> mean{};
        const std::size_t begin = part.first_share[node], end = part.first_share[node + 1];
        for (std::size_t k = begin; k < end; ++k) {
          ASSERT_GE(part.corner[k], 0);
          for (std::size_t i = 0; i < 3; ++i)
            mean[i] += part.coarse.coordinates[static_cast<std::size_t>(part.corner[k]) * 3 + i] /
                       static_cast<double>(end - begin);
        }
        for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(mean[i], fine.coordinates[node * 3 + i]);
        if (static_cast<int>(node) < fine.owned_nodes && part.number[node] >= 0) {
          EXPECT_EQ(part.number[node], next++);  // the order of the fine nodes
        }
      }
      EXPECT_EQ(next, part.coarse.owned_nodes);
    }
    EXPECT_EQ(owned.size(), 27U);
    EXPECT_EQ(*owned.rbegin(), 26);
  }
}

}  // namespace
}  // namespace ixos
