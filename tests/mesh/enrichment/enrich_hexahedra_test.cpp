// Enriched contact faces of hexahedra: counts, turned cells, ties, conformity.
#include "mesh/enrichment/enrich.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/error.hpp"
#include "mesh/enrichment/bricks.hpp"
#include "mesh/enrichment/conformity.hpp"
#include "mesh/quality.hpp"
#include "mesh/selection.hpp"

namespace ixos {
namespace {

using test::at_node;
using test::brick;
using test::cell_nodes;
using test::choose;
using test::expect_conforming;
using test::expect_patches_conform;
using test::expect_plain_map;
using test::expect_sets_conform;
using test::expect_sound;

const std::pair<ContactElement, int> orders[] = {
    {ContactElement::Q1C2, 2}, {ContactElement::Q1C3, 3}, {ContactElement::Q1C4, 4}};

TEST(EnrichHexahedraTest, AWholeSideOfABoxGetsTheNodesOfItsEdgesAndFaces) {
  for (const auto& [element, q] : orders)
    for (const char* name : {"bottom", "top", "left", "right", "front", "back"}) {
      const std::array<int, 3> n{3, 2, 4};
      Mesh mesh = brick(n);
      const int before = mesh.nodes();
      enrich(mesh, name, element);
      const std::string set = name;
      const int a = set == "left" || set == "right" ? n[1] : n[0];
      const int b = set == "bottom" || set == "top" ? n[1] : n[2];
      EXPECT_EQ(mesh.nodes() - before, (q - 1) * (a * (b + 1) + b * (a + 1)) + (q - 1) * (q - 1) * a * b) << name;
      EXPECT_EQ(mesh.plain_nodes, before);
      EXPECT_EQ(mesh.cells(), 24);
      ASSERT_EQ(mesh.blocks.size(), 2U);
      EXPECT_EQ(mesh.blocks[1].cells(), a * b);
      EXPECT_EQ(mesh.blocks[1].name, "body");
      EXPECT_EQ(mesh.blocks[1].tied, 0U);
      for (const Side& side : side_set_named(mesh, name).sides) EXPECT_EQ(side.side, contact_side(mesh.blocks[1].type));
      expect_sound(mesh, name);
    }
}

TEST(EnrichHexahedraTest, ExtraNodesLieOnTheBilinearFace) {
  // Then the map from reference to body stays that of the plain hexahedron.
  for (const auto& [element, q] : orders) {
    Mesh mesh = brick({2, 2, 2});
    mesh.coordinates[at_node(4, 2)] = 0.2;  // warped faces
    enrich(mesh, "bottom", element);
    expect_plain_map(mesh, mesh.blocks[1]);
  }
}

TEST(EnrichHexahedraTest, SideSetsFollowTheTurnedCells) {
  for (const char* name : {"bottom", "top", "left", "right", "front", "back"}) {
    const Mesh before = brick({2, 3, 2});
    Mesh after = before;
    enrich(after, name, ContactElement::Q1C2);
    for (std::size_t s = 0; s < before.side_sets.size(); ++s)
      for (std::size_t k = 0; k < before.side_sets[s].sides.size(); ++k) {
        const auto of = [](const Mesh& mesh, const Side& side) {
          const ElementBlock& block = mesh.blocks[static_cast<std::size_t>(side.block)];
          std::vector<int> corner;
          for (std::size_t a = 0; a < 4; ++a)
            corner.push_back(cell_nodes(block, side.cell)[side_nodes(block.type, side.side)[a]]);
          // From the least on: the order round the side stays, where it starts does not matter.
          std::rotate(corner.begin(), std::min_element(corner.begin(), corner.end()), corner.end());
          return corner;
        };
        EXPECT_EQ(of(before, before.side_sets[s].sides[k]), of(after, after.side_sets[s].sides[k])) << name;
      }
  }
}

TEST(EnrichHexahedraTest, NodeSetsGetTheNodesBetweenTheirMembers) {
  Mesh mesh = brick({3, 2, 2});
  const int before = mesh.nodes();
  enrich(mesh, "bottom", ContactElement::Q1C3);
  const std::map<std::string, int> expected{
      {"bottom", mesh.nodes() - before}, {"surface", mesh.nodes() - before}, {"front", 6}, {"left", 4}, {"top", 0}};
  std::size_t sets = 0;
  for (const NodeSet& set : mesh.node_sets) {
    const std::set<int> members(set.nodes.begin(), set.nodes.end());
    EXPECT_EQ(members.size(), set.nodes.size());
    const auto found = expected.find(set.name);
    if (found == expected.end()) continue;
    ++sets;
    EXPECT_EQ(std::count_if(members.begin(), members.end(), [&](int node) { return node >= before; }), found->second)
        << set.name;
  }
  EXPECT_EQ(sets, expected.size());
}

TEST(EnrichHexahedraTest, TheRimOfAPatchIsTiedAndAFreeRimIsNot) {
  for (const auto& [element, q] : orders) {
    // 2 x 2 faces inside a bottom of 4 x 4: four edges inside stay, eight on the rim are tied.
    Mesh inside = brick({4, 4, 2});
    choose(inside, "patch", "bottom", {5, 6, 9, 10});
    const int before = inside.nodes();
    enrich(inside, "patch", element);
    EXPECT_EQ(inside.nodes() - before, 4 * (q - 1) + 4 * (q - 1) * (q - 1));
    EXPECT_EQ(inside.blocks.size(), 5U);  // plain, and the four corners of the patch, each with its own two edges
    for (std::size_t b = 1; b < inside.blocks.size(); ++b) {
      const unsigned tied = inside.blocks[b].tied;
      EXPECT_TRUE(tied == 3 || tied == 6 || tied == 12 || tied == 9) << tied;
      EXPECT_EQ(inside.blocks[b].cells(), 1);
    }
    expect_sound(inside, "inside");

    // Half of a bottom of 4 x 3: of the rim only the edges against the other half are tied.
    Mesh half = brick({4, 3, 1});
    choose(half, "patch", "bottom", {0, 1, 4, 5, 8, 9});
    const int nodes = half.nodes();
    enrich(half, "patch", element);
    EXPECT_EQ(half.nodes() - nodes, (2 * 4 + 2 * 3) * (q - 1) + 6 * (q - 1) * (q - 1));
    expect_sound(half, "half");
  }
}

TEST(EnrichHexahedraTest, PatchesOfAnyShapeConform) {
  for (const auto& [element, q] : orders) expect_patches_conform(element);
}

TEST(EnrichHexahedraTest, SetsOfDifferentOrdersConform) { expect_sets_conform(ContactElement::Q1C2); }

/// Two cells by two in the plane x, z and one deep, without the upper right one: the sides round the inner edge.
Mesh step(bool with_far_cell) {
  Mesh mesh = brick({2, 1, 2});
  std::vector<int>& nodes = mesh.blocks[0].nodes;
  nodes.resize(24);
  if (!with_far_cell) nodes.erase(nodes.begin(), nodes.begin() + 8);
  mesh.side_sets.clear();
  mesh.node_sets.clear();
  const int shift = with_far_cell ? 0 : 1;
  mesh.side_sets.push_back({"corner", {{0, 1 - shift, 5}, {0, 2 - shift, 1}}});
  return mesh;
}

TEST(EnrichHexahedraTest, AnEdgeIsTiedByACellThatTouchesItOnly) {
  for (const auto& [element, q] : orders) {
    // Two faces round a re-entrant edge; the cell behind it has the edge, but no face beside it.
    Mesh behind = step(true);
    const int before = behind.nodes();
    enrich(behind, "corner", element);
    EXPECT_EQ(behind.nodes() - before, 2 * 3 * (q - 1) + 2 * (q - 1) * (q - 1));
    expect_sound(behind, "cell behind the edge");
    // Without that cell the edge is enriched in both.
    Mesh free = step(false);
    const int nodes = free.nodes();
    enrich(free, "corner", element);
    EXPECT_EQ(free.nodes() - nodes, (2 * 4 - 1) * (q - 1) + 2 * (q - 1) * (q - 1));
    EXPECT_NO_THROW(check_cells(free));
    expect_conforming(free, "no cell behind the edge");
  }
}

TEST(EnrichHexahedraTest, WhatCannotBeEnrichedIsRefused) {
  Mesh corner = brick({2, 2, 2});
  EXPECT_THROW(enrich(corner, "surface", ContactElement::Q1C2), InputError);  // faces of one cell
  Mesh twice = brick({2, 2, 2});
  enrich(twice, "bottom", ContactElement::Q1C2);
  EXPECT_THROW(enrich(twice, "left", ContactElement::Q1C2), InputError);
  EXPECT_NO_THROW(enrich(twice, "top", ContactElement::Q1C4));
}

}  // namespace
}  // namespace ixos
