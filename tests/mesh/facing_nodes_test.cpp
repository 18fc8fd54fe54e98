// Nodes of two surfaces that face each other.
#include "mesh/facing_nodes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "mesh/partition.hpp"
#include "support/two_bodies.hpp"

namespace ixos {
namespace {

/// The sides of the upper block are 0.4 long, those of the lower one 0.575; their middles are nearer than the sum of
/// half of both and the gap.
TEST(FacingNodesTest, SidesWithinTheDistanceHaveNearestNodes) {
  const Mesh mesh = test::two_blocks(0.3);
  const FacingNodes facing = facing_nodes(mesh, "upper_bottom", "lower_top", 0.3);
  EXPECT_EQ(facing.sides.size(), 5U);
  std::set<int> upper;
  for (const auto& [a, b] : facing.pairs) {
    const auto x = [&](int node, std::size_t i) { return mesh.coordinates[2 * static_cast<std::size_t>(node) + i]; };
    EXPECT_EQ(x(a, 1), 0.3);
    EXPECT_EQ(x(b, 1), 0);
    EXPECT_LE(std::abs(x(a, 0) - x(b, 0)), 0.575);
    upper.insert(a);
  }
  EXPECT_EQ(upper.size(), 6U);
  EXPECT_TRUE(facing_nodes(test::two_blocks(3), "upper_bottom", "lower_top", 0.3).pairs.empty());
  EXPECT_EQ(facing_nodes(test::two_boxes(0.3), "upper_bottom", "lower_top", 0.3).sides.size(), 9U);
}

/// The bodies are cut across: facing nodes stay together, and the parts have equal work. Without the pairs each body is
/// a part.
TEST(FacingNodesTest, RanksHoldBothSidesOfAContact) {
  const Mesh mesh = test::two_blocks(0.3, 40, 40);
  const FacingNodes facing = facing_nodes(mesh, "upper_bottom", "lower_top", 0.3);
  const std::vector<int> work = node_work(mesh, {}, 500, facing.sides);
  for (const int ranks : {2, 3}) {
    const std::vector<int> owner = partition_nodes(mesh, ranks, work, facing.pairs);
    std::vector<double> share(static_cast<std::size_t>(ranks), 0.0);
    for (std::size_t node = 0; node < owner.size(); ++node) share[static_cast<std::size_t>(owner[node])] += work[node];
    double total = 0;
    for (const double own : share) total += own;
    for (const double own : share) EXPECT_NEAR(own, total / ranks, 0.1 * total / ranks);
    for (const auto& [a, b] : facing.pairs)
      EXPECT_EQ(owner[static_cast<std::size_t>(a)], owner[static_cast<std::size_t>(b)]);
  }
  const std::vector<int> owner = partition_nodes(mesh, 2);
  for (const auto& [a, b] : facing.pairs)
    EXPECT_NE(owner[static_cast<std::size_t>(a)], owner[static_cast<std::size_t>(b)]);
}

}  // namespace
}  // namespace ixos
