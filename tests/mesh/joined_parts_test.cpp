#include "mesh/joined_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "mesh/cell_order.hpp"
#include "mesh/connected_parts.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/given.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/periodic_sides.hpp"
#include "mesh/quality.hpp"
#include "mesh/splitting/refine.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

Mesh box_of(int dimension, double left = 0, std::array<int, 3> divisions = {2, 1, 1}) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lower[0] = left;
  shape.divisions = divisions;
  return box(shape);
}

/// Returns the coordinates of the nodes, in the order of the numbers.
std::vector<double> places(const Mesh& mesh, const std::vector<int>& nodes) {
  std::vector<double> result;
  for (int node : nodes)
    for (int i = 0; i < mesh.dimension; ++i)
      result.push_back(mesh.coordinates[static_cast<std::size_t>(node * mesh.dimension + i)]);
  return result;
}

/// Expects that the joined mesh has the part's cells, sides and sets at their places.
void expect_holds(const Mesh& joined, const std::string& name, const Mesh& part, std::size_t first_block) {
  for (std::size_t b = 0; b < part.blocks.size(); ++b) {
    const ElementBlock& block = joined.blocks.at(first_block + b);
    EXPECT_EQ(block.name, name + "_" + part.blocks[b].name);
    EXPECT_EQ(block.type, part.blocks[b].type);
    EXPECT_EQ(places(joined, block.nodes), places(part, part.blocks[b].nodes)) << block.name;
  }
  for (const SideSet& set : part.side_sets) {
    const auto found = std::find_if(joined.side_sets.begin(), joined.side_sets.end(),
                                    [&](const SideSet& own) { return own.name == name + "_" + set.name; });
    ASSERT_NE(found, joined.side_sets.end()) << set.name;
    ASSERT_EQ(found->sides.size(), set.sides.size());
    for (std::size_t k = 0; k < set.sides.size(); ++k) {
      EXPECT_EQ(found->sides[k].block, set.sides[k].block + static_cast<int>(first_block));
      EXPECT_EQ(found->sides[k].cell, set.sides[k].cell);
      EXPECT_EQ(found->sides[k].side, set.sides[k].side);
    }
  }
  for (const NodeSet& set : part.node_sets) {
    const auto found = std::find_if(joined.node_sets.begin(), joined.node_sets.end(),
                                    [&](const NodeSet& own) { return own.name == name + "_" + set.name; });
    ASSERT_NE(found, joined.node_sets.end()) << set.name;
    EXPECT_EQ(places(joined, found->nodes), places(part, set.nodes)) << set.name;
  }
}

TEST(JoinedPartsTest, EachPartKeepsItsCellsAndSetsUnderItsName) {
  for (const int order : {1, 2}) {
    DiskShape shape;
    shape.center = {3, 3};
    shape.cell_order = order;
    const Mesh ball = disk(shape);
    Mesh block = box_of(2);
    if (order == 2) raise_order(block);
    const Mesh joined = joined_parts({{"ball", ball}, {"block-2", block}});
    EXPECT_EQ(joined.nodes(), ball.nodes() + block.nodes());
    EXPECT_EQ(joined.side_sets.size(), ball.side_sets.size() + block.side_sets.size());
    EXPECT_EQ(joined.node_sets.size(), ball.node_sets.size() + block.node_sets.size());
    expect_holds(joined, "ball", ball, 0);
    expect_holds(joined, "block-2", block, 1);
    EXPECT_EQ(joined.linear_nodes, order == 1 ? -1 : ball.linear_nodes + block.linear_nodes);
    if (order == 1) check_arrays(joined);
    check_cells(joined);
  }
}

// As in any mesh, the nodes of linear cells come first: raise_order() puts the middles behind them.
TEST(JoinedPartsTest, CornersStandBeforeMiddles) {
  Mesh one = box_of(3), two = box_of(3, 5);
  raise_order(one);
  raise_order(two);
  const Mesh joined = joined_parts({{"one", one}, {"two", two}});
  std::set<int> corners;
  for (const ElementBlock& block : joined.blocks)
    for (int cell = 0; cell < block.cells(); ++cell)
      for (int a = 0; a < 8; ++a) corners.insert(block.nodes[cell_entry(cell, 27, a)]);
  EXPECT_EQ(static_cast<int>(corners.size()), joined.linear_nodes);
  EXPECT_EQ(*corners.rbegin(), joined.linear_nodes - 1);
}

TEST(JoinedPartsTest, PartsThatTouchStayApart) {
  const Mesh joined = joined_parts({{"left", box_of(2)}, {"right", box_of(2, 1)}});
  const std::vector<int> bodies = connected_parts(joined);
  EXPECT_EQ(std::set<int>(bodies.begin(), bodies.end()).size(), 2U);
}

TEST(JoinedPartsTest, ContactElementsOfOnePartLeaveTheOthersAlone) {
  Mesh joined = joined_parts({{"left", box_of(2)}, {"right", box_of(2, 1)}});
  enrich(joined, "right_bottom", ContactElement::Q1C4);
  for (const ElementBlock& block : joined.blocks)
    if (block.name == "left_body") {
      EXPECT_EQ(block.type, CellType::Quad4);
    }
  EXPECT_TRUE(std::any_of(joined.blocks.begin(), joined.blocks.end(), [](const ElementBlock& block) {
    return block.name == "right_body" && block.type != CellType::Quad4;
  }));
}

TEST(JoinedPartsTest, NotesNameTheirPart) {
  Mesh noted = box_of(2);
  noted.notes = {"a point is left out"};
  EXPECT_EQ(joined_parts({{"plain", box_of(2)}, {"noted", noted}}).notes,
            std::vector<std::string>{"part \"noted\": a point is left out"});
}

TEST(JoinedPartsTest, TiesStayWithTheirNodes) {
  Mesh one = box_of(2), two = box_of(2, 5, {2, 2, 1});
  raise_order(one);
  raise_order(two);
  RefinedRegion corner;
  corner.upper = {5.1, 0.1};
  refine(two, {{"corner", corner}}, 2);
  make_periodic(one, "right", "left", 0);
  ASSERT_FALSE(two.ties.empty());
  const Mesh joined = joined_parts({{"one", one}, {"two", two}});
  ASSERT_EQ(joined.ties.size(), one.ties.size() + two.ties.size());
  std::size_t k = 0;
  for (const Mesh* part : {&one, &two})
    for (const Tie& tie : part->ties) {
      const Tie& own = joined.ties[k++];
      EXPECT_EQ(places(joined, {own.node}), places(*part, {tie.node}));
      EXPECT_EQ(places(joined, own.masters), places(*part, tie.masters));
      EXPECT_EQ(own.weights, tie.weights);
      EXPECT_EQ(own.in_place, tie.in_place);
    }
  EXPECT_EQ(joined.hanging_sides.size(), two.hanging_sides.size());
  EXPECT_EQ(joined.hanging_sides.front().block, two.hanging_sides.front().block + 1);
  EXPECT_EQ(joined.nodes_of_tied_sides.size(), one.nodes_of_tied_sides.size());
}

TEST(JoinedPartsTest, PartsThatDoNotFitAreRefused) {
  const auto refused = [](const std::vector<MeshPart>& parts, const std::string& words) {
    test::expect_contains(test::refusal([&] { joined_parts(parts); }), words);
  };
  refused({}, "there is no part");
  refused({{"", box_of(2)}}, "a part has an empty name");
  refused({{"a", box_of(2)}, {"b", box_of(2)}, {"a", box_of(2)}}, "two parts have the name \"a\"");
  for (const char* name : {"a/b", "a b", "a.b", "\xc3\xa4"})
    refused({{name, box_of(2)}}, "letters, digits, \"_\" and \"-\"");
  refused({{"flat", box_of(2)}, {"solid", box_of(3)}},
          "the part \"flat\" has 2 dimensions, but the part \"solid\" has 3");
  Mesh ring = box_of(2);
  ring.axisymmetric = true;
  refused({{"a", ring}, {"b", box_of(2)}}, "one is axisymmetric");
  Mesh rich = box_of(2);
  enrich(rich, "bottom", ContactElement::Q1C4);
  refused({{"a", rich}}, "join parts before they are enriched");
  refused({{"a_b", box_of(2)}, {"a", box_of(2)}}, "the name of the part \"a_b\" begins with \"a_\"");
}

TEST(JoinedPartsTest, APartComesBack) {
  Mesh one = box_of(3), two = box_of(3, 5);
  raise_order(one);
  raise_order(two);
  std::vector<int> old;
  const Mesh joined = joined_parts({{"one", one}, {"two", two}}), back = part_of_joined(joined, "two", old);
  EXPECT_EQ(back.coordinates, two.coordinates);
  EXPECT_EQ(back.blocks[0].nodes, two.blocks[0].nodes);
  EXPECT_EQ(places(joined, old), two.coordinates);
  EXPECT_TRUE(back.notes.empty());
  EXPECT_EQ(back.linear_nodes, two.linear_nodes);
  ASSERT_EQ(back.side_sets.size(), two.side_sets.size());
  for (std::size_t k = 0; k < two.side_sets.size(); ++k) {
    EXPECT_EQ(back.side_sets[k].name, "two_" + two.side_sets[k].name);
    ASSERT_EQ(back.side_sets[k].sides.size(), two.side_sets[k].sides.size());
    for (std::size_t s = 0; s < two.side_sets[k].sides.size(); ++s) {
      const Side &found = back.side_sets[k].sides[s], &expected = two.side_sets[k].sides[s];
      EXPECT_EQ(std::tie(found.block, found.cell, found.side), std::tie(expected.block, expected.cell, expected.side));
    }
  }
  ASSERT_EQ(back.node_sets.size(), two.node_sets.size());
  for (std::size_t k = 0; k < two.node_sets.size(); ++k) EXPECT_EQ(back.node_sets[k].nodes, two.node_sets[k].nodes);
}

}  // namespace
}  // namespace ixos
