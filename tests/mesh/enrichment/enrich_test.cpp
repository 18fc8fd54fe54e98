// Enriched contact sides, and sets chosen by place.
#include "mesh/enrichment/enrich.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.hpp"
#include "mesh/enrichment/side_places.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/quality.hpp"
#include "mesh/selection.hpp"

namespace ixos {
namespace {

using test::places;

Mesh rectangle() {
  BoxShape shape;
  shape.lengths = {4, 2, 1};
  shape.divisions = {4, 2, 1};
  return box(shape);
}

const ElementBlock& block_of(const Mesh& mesh, CellType type) {
  return *std::find_if(mesh.blocks.begin(), mesh.blocks.end(), [&](const ElementBlock& b) { return b.type == type; });
}

const SideSet& side_set(const Mesh& mesh, const std::string& name) {
  return *std::find_if(mesh.side_sets.begin(), mesh.side_sets.end(), [&](const SideSet& s) { return s.name == name; });
}

TEST(EnrichTest, ASideGetsEquallySpacedNodesAndItsCellsABlock) {
  for (const char* set : {"bottom", "right", "top", "left"}) {
    Mesh mesh = rectangle();
    const auto sides = side_set(mesh, set).sides.size();
    const int nodes = mesh.nodes();
    enrich(mesh, set, ContactElement::Q1C4);
    EXPECT_NO_THROW(check_cells(mesh)) << set;
    EXPECT_EQ(mesh.nodes(), nodes + 3 * static_cast<int>(sides));
    ASSERT_EQ(mesh.blocks.size(), 2U);
    EXPECT_EQ(mesh.blocks[0].name, mesh.blocks[1].name);
    EXPECT_EQ(block_of(mesh, CellType::Quad4C4).cells(), static_cast<int>(sides));
    EXPECT_EQ(mesh.cells(), 8);
    for (const Side& side : side_set(mesh, set).sides) {
      EXPECT_EQ(side.side, 0);
      const auto x = places(mesh, side);
      ASSERT_EQ(x.size(), 5U);
      for (std::size_t k = 2; k < 5; ++k)
        for (std::size_t i = 0; i < 2; ++i) {
          const double t = static_cast<double>(k - 1) / 4;
          EXPECT_NEAR(x[k][i], (1 - t) * x[0][i] + t * x[1][i], 1e-15);
        }
    }
  }
}

TEST(EnrichTest, OtherSideSetsFollowTheTurnedCells) {
  Mesh before = rectangle();
  Mesh after = before;
  enrich(after, "right", ContactElement::Q1C2);
  for (const char* set : {"bottom", "top", "left"})
    for (std::size_t k = 0; k < side_set(before, set).sides.size(); ++k)
      EXPECT_EQ(places(before, side_set(before, set).sides[k]), places(after, side_set(after, set).sides[k])) << set;
}

TEST(EnrichTest, NodeSetsWithBothEndsOfASideGetItsNodes) {
  Mesh mesh = rectangle();
  enrich(mesh, "bottom", ContactElement::Q1C3);
  int grown = 0;
  for (const NodeSet& set : mesh.node_sets) {
    const std::set<int> extra(set.nodes.begin(), set.nodes.end());
    const auto added = std::count_if(extra.begin(), extra.end(), [](int node) { return node >= 15; });
    EXPECT_EQ(added, set.name == "bottom" || set.name == "surface" ? 8 : 0) << set.name;
    if (added > 0) ++grown;
  }
  EXPECT_EQ(grown, 2);
}

TEST(EnrichTest, HermiteSidesShareOneDerivativeANode) {
  Mesh mesh = rectangle();
  mesh.coordinates[2] = 1.4;  // the second node of the bottom: sides of 1.4 and 0.6
  enrich(mesh, "bottom", ContactElement::Q1CH);
  EXPECT_NO_THROW(check_cells(mesh));
  EXPECT_EQ(mesh.nodes(), 15 + 5);
  const ElementBlock& block = block_of(mesh, CellType::Quad4CH);
  for (int cell = 0; cell < block.cells(); ++cell)
    for (int end : {0, 1}) {
      const int derivative = block.nodes[cell_entry(cell, 6, 4 + end)];
      EXPECT_EQ(mesh.derivative_of[static_cast<std::size_t>(derivative)], block.nodes[cell_entry(cell, 6, end)]);
      // Scaled, it is dX/dxi: half the side.
      const double length = cell == 0 ? 1.4 : cell == 1 ? 0.6 : 1.0;
      EXPECT_NEAR(node_scale(block, cell, 4 + end) * mesh.coordinates[2 * static_cast<std::size_t>(derivative)],
                  length / 2, 1e-15);
    }
}

TEST(EnrichTest, WhatCannotBeEnrichedIsRefused) {
  Mesh corner = rectangle();
  EXPECT_THROW(enrich(corner, "surface", ContactElement::Q1C2), InputError);  // two sides of the corner cells
  Mesh twice = rectangle();
  enrich(twice, "bottom", ContactElement::Q1C2);
  EXPECT_THROW(enrich(twice, "left", ContactElement::Q1C2), InputError);  // the corner cell again
}

TEST(SelectionTest, SidesAndNodesAreChosenByPlace) {
  Mesh mesh = rectangle();
  add_side_set(mesh, "half", "bottom", {{}, {2, 10}});
  EXPECT_EQ(side_set(mesh, "half").sides.size(), 2U);
  add_node_set(mesh, "corner", "", {{4, 2}, {}});
  EXPECT_EQ(mesh.node_sets.back().nodes, std::vector<int>{14});
  add_node_set(mesh, "left end", "bottom", {{}, {0.5, 10}});
  EXPECT_EQ(mesh.node_sets.back().nodes.size(), 1U);
  EXPECT_THROW(add_side_set(mesh, "half", "top", {}), InputError);
  EXPECT_THROW(add_side_set(mesh, "none", "bottom", {{7, 0}, {}}), InputError);
  EXPECT_THROW(add_side_set(mesh, "what", "bottum", {}), InputError);
  EXPECT_THROW(add_node_set(mesh, "odd", "", {{1, 2, 3}, {}}), InputError);
}

}  // namespace
}  // namespace ixos
