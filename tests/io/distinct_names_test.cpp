#include "io/distinct_names.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ixos {
namespace {

using Names = std::vector<std::string>;

/// Returns the names of blocks, side sets and node sets, one after another.
Names distinct(const Names& blocks, const Names& side_sets, const Names& node_sets) {
  Mesh mesh;
  for (const std::string& name : blocks) mesh.blocks.push_back({name, CellType::Quad4, {}});
  for (const std::string& name : side_sets) mesh.side_sets.push_back({name, {}});
  for (const std::string& name : node_sets) mesh.node_sets.push_back({name, {}});
  make_names_distinct(mesh);
  Names names;
  for (const ElementBlock& block : mesh.blocks) names.push_back(block.name);
  for (const SideSet& set : mesh.side_sets) names.push_back(set.name);
  for (const NodeSet& set : mesh.node_sets) names.push_back(set.name);
  return names;
}

TEST(DistinctNamesTest, DistinctNamesStay) {
  EXPECT_EQ(distinct({"a", "b"}, {"c", "d_nodes"}, {"d"}), (Names{"a", "b", "c", "d_nodes", "d"}));
}

TEST(DistinctNamesTest, EqualNamesTellWhatTheyBelongTo) {
  EXPECT_EQ(distinct({"body"}, {"base"}, {"base", "corner"}), (Names{"body", "base", "base_nodes", "corner"}));
  EXPECT_EQ(distinct({"base"}, {"base"}, {"base"}), (Names{"base", "base_sides", "base_nodes"}));
}

TEST(DistinctNamesTest, NamesThatReadersTakeForEqualAreEqual) {
  EXPECT_EQ(distinct({"Base"}, {"base"}, {"BASE"}), (Names{"Base", "base_sides", "BASE_nodes"}));
  EXPECT_EQ(distinct({"left end"}, {"left_end"}, {"left.end"}),
            (Names{"left end", "left_end_sides", "left.end_nodes"}));
  EXPECT_EQ(distinct({}, {"base"}, {"base", "Base_Nodes"}), (Names{"base", "base_nodes_2", "Base_Nodes"}));
}

TEST(DistinctNamesTest, NumbersFollowWhereANameIsTaken) {
  EXPECT_EQ(distinct({"rim", "rim", "rim"}, {}, {}), (Names{"rim", "rim_2", "rim_3"}));
  EXPECT_EQ(distinct({"rim", "rim", "rim_2"}, {}, {}), (Names{"rim", "rim_3", "rim_2"}));
  // A set that has a name of its own keeps it in any order.
  EXPECT_EQ(distinct({}, {"base"}, {"base", "base_nodes"}), (Names{"base", "base_nodes_2", "base_nodes"}));
  EXPECT_EQ(distinct({}, {"base"}, {"base_nodes", "base"}), (Names{"base", "base_nodes", "base_nodes_2"}));
}

}  // namespace
}  // namespace ixos
