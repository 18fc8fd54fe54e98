// Contact sides of fourth order of quadratic cells: counts, turned cells, ties, conformity, curved sides.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/cell_order.hpp"
#include "mesh/enrichment/bricks.hpp"
#include "mesh/enrichment/conformity.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/enrichment/side_places.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/quality.hpp"
#include "mesh/selection.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

using test::places;

Mesh rectangle() {
  BoxShape shape;
  shape.lengths = {4, 2, 1};
  shape.divisions = {4, 2, 1};
  Mesh mesh = box(shape);
  raise_order(mesh);
  return mesh;
}

TEST(QuarterNodesTest, SidesInThePlaneGetTheirQuarters) {
  for (const char* name : {"bottom", "right", "top", "left"}) {
    Mesh mesh = rectangle();
    const int nodes = mesh.nodes();
    const std::vector<Side> before = side_set_named(mesh, name).sides;
    enrich(mesh, name, ContactElement::Q2C4);
    EXPECT_NO_THROW(check_cells(mesh)) << name;
    EXPECT_EQ(mesh.nodes(), nodes + 2 * static_cast<int>(before.size()));
    ASSERT_EQ(mesh.blocks.size(), 2U);
    EXPECT_EQ(mesh.blocks[0].type, CellType::Quad9);
    EXPECT_EQ(mesh.blocks[1].type, CellType::Quad9C4);
    EXPECT_NEAR(mesh_quality(mesh).volume, 8, 1e-13);
    EXPECT_NEAR(mesh_quality(mesh).least_scaled_jacobian, 1, 1e-13) << name << ": a turned cell has its nodes mixed up";
    for (const Side& side : side_set_named(mesh, name).sides) {
      EXPECT_EQ(side.side, 0);
      const auto x = places(mesh, side);
      ASSERT_EQ(x.size(), 5U);
      for (std::size_t k = 2; k < 5; ++k)
        for (std::size_t i = 0; i < 2; ++i)
          EXPECT_NEAR(x[k][i], x[0][i] + (x[1][i] - x[0][i]) * static_cast<double>(k - 1) / 4, 1e-15) << name;
    }
    for (const NodeSet& set : mesh.node_sets)
      if (set.name == name) {
        EXPECT_EQ(set.nodes.size(), 4 * before.size() + 1);
      }
  }
}

// The map of a cell stays that of the quadratic one: quarters of a curved side lie on its parabola.
TEST(QuarterNodesTest, ACurvedSideKeepsItsShape) {
  Mesh mesh = rectangle();
  for (std::size_t k = 0; k < mesh.coordinates.size(); k += 2)
    mesh.coordinates[k + 1] += 0.1 * mesh.coordinates[k] * mesh.coordinates[k];
  const double volume = mesh_quality(mesh).volume;
  enrich(mesh, "bottom", ContactElement::Q2C4);
  EXPECT_NEAR(mesh_quality(mesh).volume, volume, 1e-13);
  for (const Side& side : side_set_named(mesh, "bottom").sides)
    for (const auto& [x, y] : places(mesh, side)) EXPECT_NEAR(y, 0.1 * x * x, 1e-14);
}

Mesh quadratic_brick(const std::array<int, 3>& divisions) {
  Mesh mesh = test::brick(divisions);
  raise_order(mesh);
  return mesh;
}

TEST(QuarterNodesTest, AWholeSideOfABoxGetsTheQuartersOfItsEdgesAndFaces) {
  for (const char* name : {"bottom", "top", "left", "right", "front", "back"}) {
    const std::array<int, 3> n{3, 2, 4};
    Mesh mesh = quadratic_brick(n);
    const int before = mesh.nodes();
    const double volume = mesh_quality(mesh).volume;
    enrich(mesh, name, ContactElement::Q2C4);
    const std::string set = name;
    const int a = set == "left" || set == "right" ? n[1] : n[0];
    const int b = set == "bottom" || set == "top" ? n[1] : n[2];
    EXPECT_EQ(mesh.nodes() - before, 2 * (a * (b + 1) + b * (a + 1)) + 8 * a * b) << name;
    EXPECT_EQ(mesh.blocks[1].tied, 0U);
    EXPECT_EQ(mesh.blocks[1].type, CellType::Hex27C4);
    EXPECT_NEAR(mesh_quality(mesh).volume, volume, 1e-12 * volume) << name;
    test::expect_sound(mesh, name);
    for (const NodeSet& nodes : mesh.node_sets)
      if (nodes.name == set) {
        EXPECT_EQ(nodes.nodes.size(), static_cast<std::size_t>((4 * a + 1) * (4 * b + 1))) << name;
      }
  }
}

TEST(QuarterNodesTest, PatchesOfAnyShapeConform) { test::expect_patches_conform(ContactElement::Q2C4); }

TEST(QuarterNodesTest, WhatDoesNotFitIsRefused) {
  Mesh corner = rectangle();
  test::expect_contains(test::refusal([&] { enrich(corner, "surface", ContactElement::Q2C4); }),
                        "two sides of the cell");
  Mesh twice = rectangle();
  enrich(twice, "bottom", ContactElement::Q2C4);
  test::expect_contains(test::refusal([&] { enrich(twice, "left", ContactElement::Q2C4); }), "already has an enriched");
  test::expect_contains(test::refusal([&] { raise_order(twice); }), "before it is enriched");
  BoxShape shape;
  Mesh linear = box(shape);
  test::expect_contains(test::refusal([&] { enrich(linear, "bottom", ContactElement::Q2C4); }),
                        "contact elements of quadratic cells, and these cells are linear; choose Q1C1, Q1C2");
}

}  // namespace
}  // namespace ixos
