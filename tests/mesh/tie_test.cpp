#include "mesh/tie.hpp"

#include <gtest/gtest.h>

#include "mesh/node_ties.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

std::string name(int node) { return "node " + std::to_string(node); }

std::vector<Tie> resolved(const std::vector<Tie>& ties) { return resolved_ties(ties, name); }

TEST(TieTest, MastersThatAreTiedAreReplacedByTheirOwn) {
  const auto ties = resolved({{5, {3, 4}, {0.5, 0.5}}, {3, {0, 1}, {0.25, 0.75}}});
  ASSERT_EQ(ties.size(), 2U);
  EXPECT_EQ(ties[0].node, 3);
  EXPECT_EQ(ties[1].node, 5);
  EXPECT_EQ(ties[1].masters, (std::vector<int>{0, 1, 4}));
  EXPECT_EQ(ties[1].weights, (std::vector<double>{0.125, 0.375, 0.5}));
}

TEST(TieTest, SharesOfOneMasterAreAdded) {
  const auto ties = resolved({{9, {1, 2}, {0.5, 0.5}}, {2, {1, 0}, {0.5, 0.5}}});
  EXPECT_EQ(ties[1].masters, (std::vector<int>{0, 1}));
  EXPECT_EQ(ties[1].weights, (std::vector<double>{0.25, 0.75}));
}

TEST(TieTest, LoopsOverlapsAndTiesToNothingAreRefused) {
  test::expect_contains(test::refusal([] {
                          resolved({{1, {2}, {1}}, {2, {3}, {1}}, {3, {1}, {1}}});
                        }),
                        "follows itself");
  test::expect_contains(test::refusal([] { resolved({{1, {1}, {1}}}); }), "node 1 follows itself");
  test::expect_contains(test::refusal([] { resolved({{1, {2}, {1}}, {1, {3}, {1}}}); }), "node 1 is tied twice");
  test::expect_contains(test::refusal([] { resolved({{4, {}, {}}}); }), "node 4 is tied to nothing");
}

/// Two free nodes and two that follow them, two values each.
NodeTies two_followers() {
  NodeTies ties(2);
  ties.add({{0, 0.25}, {1, 0.75}});
  ties.add({{1, 1.0}});
  return ties;
}

TEST(NodeTiesTest, CondensedForcesDoTheWorkOfAllForces) {
  const NodeTies ties = two_followers();
  std::vector<double> u{1, 2, 3, 5, 0, 0, 0, 0};
  ties.interpolate(u.data(), 2);
  EXPECT_EQ(u, (std::vector<double>{1, 2, 3, 5, 2.5, 4.25, 3, 5}));
  const std::vector<double> all{0.5, -1, 2, 3, -4, 1, 7, 0.25};
  std::vector<double> free = all;
  ties.condense(free.data(), 2);
  double work = 0, condensed = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    work += u[i] * all[i];
    condensed += u[i] * free[i];
  }
  EXPECT_DOUBLE_EQ(condensed, work);
  for (std::size_t i = 4; i < u.size(); ++i) EXPECT_EQ(free[i], 0);
}

TEST(NodeTiesTest, NodesBehindTheFirstAreTied) {
  const NodeTies ties = two_followers();
  EXPECT_FALSE(ties.is_tied(1));
  EXPECT_TRUE(ties.is_tied(2));
  EXPECT_EQ(ties.size(), 2);
  EXPECT_FALSE(NodeTies().is_tied(0));
  EXPECT_EQ(ties.largest_magnitude(), 1);
}

}  // namespace
}  // namespace ixos
