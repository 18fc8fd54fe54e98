#include "mesh/name_pattern.hpp"

#include <gtest/gtest.h>

#include "mesh/generators/shapes.hpp"
#include "mesh/selection.hpp"

namespace ixos {
namespace {

TEST(NamePatternTest, AStarStandsForAnyCharacters) {
  for (const char* const pattern : {"hair_*_pad", "*_pad", "hair_17*", "*", "h*r*1*d", "*hair_17_pad*"})
    EXPECT_TRUE(matches(pattern, "hair_17_pad")) << pattern;
  for (const char* const pattern : {"hair_*_tip", "*_pa", "air*", "hair_17_pad_*", "h*r*2*d", "hair_17_pad17_pad*"})
    EXPECT_FALSE(matches(pattern, "hair_17_pad")) << pattern;
  EXPECT_FALSE(matches("ab*ba", "aba")) << "both ends need their own characters";
  EXPECT_TRUE(matches("same", "same"));
}

TEST(NamePatternTest, PatternsOfListsBecomeTheNamesThatTheyMatch) {
  const std::vector<std::string> known{"a_1", "b", "a_2", "a_*"};
  EXPECT_EQ(expanded({"b", "a_*", "c_*"}, known), (std::vector<std::string>{"b", "a_1", "a_2", "c_*"}));
  EXPECT_EQ(expanded({"a_*1", "a_*", "a_2"}, known), (std::vector<std::string>{"a_1", "a_2"})) << "each once";
  EXPECT_EQ(expanded({"b", "b"}, known), (std::vector<std::string>{"b", "b"})) << "the caller refuses these";
}

TEST(NamePatternTest, SetsOfPatternsHaveAllEntriesOnce) {
  Mesh mesh = box({});
  const std::size_t sides = mesh.side_sets.size();
  add_pattern_sets({"*t", "left", "x*"}, mesh);  // left and right
  ASSERT_EQ(mesh.side_sets.size(), sides + 1);
  EXPECT_EQ(side_set_named(mesh, "*t").sides.size(),
            side_set_named(mesh, "left").sides.size() + side_set_named(mesh, "right").sides.size());
  EXPECT_EQ(find_set(mesh.node_sets, "*t")->nodes.size(),
            find_set(mesh.node_sets, "left")->nodes.size() + find_set(mesh.node_sets, "right")->nodes.size());
  add_pattern_sets({"*"}, mesh);
  EXPECT_EQ(side_set_named(mesh, "*").sides.size(), side_set_named(mesh, "surface").sides.size()) << "once each";
}

}  // namespace
}  // namespace ixos
