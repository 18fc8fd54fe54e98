#include "mesh/repeated.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "mesh/cell_order.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/connected_parts.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/overlaps.hpp"
#include "mesh/placement.hpp"
#include "mesh/quality.hpp"
#include "mesh/selection.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

Mesh box_at(int dimension, double left, double turn = 0) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.divisions = {3, 2, 2};
  Mesh mesh = box(shape);
  move_nodes({turn, {0, 0, 1}, {}, {left, 0, 0}}, mesh);
  return mesh;
}

TEST(RepeatedTest, BlocksAndSetsAreThoseOfAllCopiesAndOfEach) {
  for (const int dimension : {2, 3})
    for (const int order : {1, 2}) {
      std::vector<Mesh> copies;
      for (const double left : {0.0, 20.0, 40.0}) copies.push_back(box_at(dimension, left));
      for (Mesh& copy : copies)
        if (order == 2) raise_order(copy);
      const Mesh one = copies.front(), all = repeated(copies);
      ASSERT_EQ(all.blocks.size(), 1U);
      EXPECT_EQ(all.blocks[0].name, "body");
      EXPECT_EQ(all.blocks[0].cells(), 3 * one.blocks[0].cells());
      EXPECT_EQ(all.nodes(), 3 * one.nodes());
      EXPECT_EQ(all.side_sets.size(), 4 * one.side_sets.size());
      EXPECT_EQ(all.node_sets.size(), 4 * one.node_sets.size());
      EXPECT_NO_THROW(check_cells(all));
      const std::vector<int> parts = connected_parts(all);
      EXPECT_EQ(std::set<int>(parts.begin(), parts.end()).size(), 3U);
      // The sides of each copy are where that copy is.
      for (std::size_t copy = 0; copy < copies.size(); ++copy)
        for (const SideSet& set : one.side_sets) {
          const SideSet& own = side_set_named(all, std::to_string(copy + 1) + "_" + set.name);
          ASSERT_EQ(own.sides.size(), set.sides.size());
          for (std::size_t k = 0; k < own.sides.size(); ++k) {
            const auto here = centre_of(all, corners_of(all, own.sides[k]));
            const auto there = centre_of(copies[copy], corners_of(copies[copy], set.sides[k]));
            for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(here[i], there[i]) << set.name << copy;
          }
        }
      EXPECT_EQ(side_set_named(all, "left").sides.size(), 3 * side_set_named(one, "left").sides.size());
      EXPECT_EQ(find_set(all.node_sets, "left")->nodes.size(), 3 * find_set(one.node_sets, "left")->nodes.size());
    }
}

TEST(RepeatedTest, CopiesOfOtherKindsAreRefused) {
  EXPECT_EQ(test::refusal([] { repeated({}); }).find("there is no part"), 0U);
  Mesh other = box_at(2, 20);
  other.side_sets.pop_back();
  EXPECT_EQ(test::refusal([&] {
              repeated({box_at(2, 0), other});
            }),
            "copy 2 has other blocks or sets than copy 1: \"top\"");
}

TEST(OverlapsTest, BodiesThatTouchDoNotOverlap) {
  for (const int dimension : {2, 3}) {
    const Mesh one = box_at(dimension, 0);
    double right = 0;
    for (std::size_t i = 0; i < one.coordinates.size(); i += static_cast<std::size_t>(dimension))
      right = std::max(right, one.coordinates[i]);
    const Mesh touching = box_at(dimension, right), apart = box_at(dimension, right + 1);
    EXPECT_FALSE(find_overlap({&one, &touching}).has_value());
    EXPECT_FALSE(find_overlap({&one, &apart}).has_value());
    EXPECT_FALSE(find_overlap({&one}).has_value());
    const Mesh inside = box_at(dimension, right - 0.01 * right);
    const auto found = find_overlap({&one, &apart, &inside});
    ASSERT_TRUE(found.has_value());
    // The third one overlaps both others.
    EXPECT_TRUE(found->first == 2 || found->second == 2);
  }
}

/// Boxes around turned bodies may meet where the bodies do not.
TEST(OverlapsTest, TurnedBodiesMayPassEachOther) {
  const double far = 0.9;
  BoxShape shape;
  shape.lengths = {1, 1, 1};
  shape.divisions = {4, 4, 1};
  shape.lower = {-0.5, -0.5, 0};
  Mesh one = box(shape), other = box(shape);
  move_nodes({45, {0, 0, 1}, {}, {}}, one);
  move_nodes({45, {0, 0, 1}, {}, {far, far, 0}}, other);
  EXPECT_FALSE(find_overlap({&one, &other}).has_value()) << "their sides face each other, 0.27 apart";
  move_nodes({0, {0, 0, 1}, {}, {-0.3, -0.3, 0}}, other);
  EXPECT_TRUE(find_overlap({&one, &other}).has_value());
}

}  // namespace
}  // namespace ixos
