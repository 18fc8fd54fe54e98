#include "mesh/node_directory.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/all_to_all.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using Ids = std::vector<long long>;

/// Rank r owns the nodes 1000 r + 30, + 10 and + 20, in that order, at x = their id and y = 2 ids.
Ids owned_by(int rank) {
  const long long first = 1000LL * rank;
  return {first + 30, first + 10, first + 20};
}

NodeDirectory directory() {
  const Ids ids = owned_by(test::world()->getRank());
  std::vector<double> x;
  for (const long long id : ids) x.insert(x.end(), {1.0 * static_cast<double>(id), 2.0 * static_cast<double>(id)});
  return {ids, x, 2, test::world()};
}

TEST(AllToAllTest, EveryRankGetsWhatWasSentToIt) {
  const Comm comm = test::world();
  const auto ranks = static_cast<std::size_t>(comm->getSize());
  std::vector<Ids> out(ranks);
  for (std::size_t to = 0; to < ranks; ++to) out[to].assign(to + 1, 10 * comm->getRank() + static_cast<long long>(to));
  const std::vector<Ids> in = all_to_all(out, comm);
  ASSERT_EQ(in.size(), ranks);
  for (std::size_t from = 0; from < ranks; ++from)
    EXPECT_EQ(in[from],
              Ids(static_cast<std::size_t>(comm->getRank()) + 1, 10 * static_cast<long long>(from) + comm->getRank()));
}

TEST(NodeDirectoryTest, EveryRankFindsTheNodesOfAll) {
  const NodeDirectory nodes = directory();
  const int ranks = test::world()->getSize();
  EXPECT_EQ(nodes.size(), 3 * ranks);
  Ids asked{77777, -5};
  for (int rank = ranks - 1; rank >= 0; --rank)
    for (const long long id : owned_by(rank)) asked.push_back(id);
  asked.push_back(30);  // twice
  const std::vector<NodeEntry> found = nodes.find(asked);
  ASSERT_EQ(found.size(), asked.size());
  EXPECT_EQ(found[0].owner, -1);
  EXPECT_EQ(found[1].owner, -1);
  const int place_of[] = {1, 2, 0};  // of + 10, + 20, + 30
  for (std::size_t i = 2; i < asked.size(); ++i) {
    const auto rank = static_cast<int>(asked[i] / 1000);
    const auto step = static_cast<int>(asked[i] % 1000) / 10 - 1;
    EXPECT_EQ(found[i].id, asked[i]);
    EXPECT_EQ(found[i].owner, rank);
    EXPECT_EQ(found[i].place, place_of[step]);
    EXPECT_EQ(found[i].number, 3 * rank + step);
    EXPECT_EQ(found[i].x,
              (std::array<double, 3>{1.0 * static_cast<double>(asked[i]), 2.0 * static_cast<double>(asked[i]), 0.0}));
  }
}

TEST(NodeDirectoryTest, MembersOfAnyRankAreMembersEverywhere) {
  const NodeDirectory nodes = directory();
  const Comm comm = test::world();
  // Each rank contributes a node of the next one to set 1; all contribute node 10 to set 0.
  const long long next = 1000LL * ((comm->getRank() + 1) % comm->getSize());
  Ids asked;
  for (int rank = 0; rank < comm->getSize(); ++rank)
    asked.insert(asked.end(), {1000LL * rank + 20, 1000LL * rank + 10});
  const auto members = nodes.find_members({{10, 0}, {next + 20, 1}}, 3, asked);
  ASSERT_EQ(members.size(), 3);
  EXPECT_EQ(members[0], std::vector<int>{1});
  std::vector<int> every_second;
  for (int rank = 0; rank < comm->getSize(); ++rank) every_second.push_back(2 * rank);
  EXPECT_EQ(members[1], every_second);
  EXPECT_TRUE(members[2].empty());
}

TEST(NodeDirectoryTest, ANodeHasOneOwner) {
  const Comm comm = test::world();
  const Ids ids{7, comm->getRank() == comm->getSize() - 1 && comm->getSize() == 1 ? 7 : 8LL + comm->getRank()};
  test::expect_contains(test::refusal([&] { NodeDirectory(ids, {0, 0, 0, 0}, 2, comm); }), "node 7 is owned twice");
  test::expect_contains(test::refusal([&] { NodeDirectory({}, {}, 2, comm); }), "the mesh has no nodes");
}

}  // namespace
}  // namespace ixos
