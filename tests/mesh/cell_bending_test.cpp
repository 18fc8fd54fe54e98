#include "mesh/cell_bending.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "mesh/cell_order.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"

namespace ixos {
namespace {

/// A bar of length 12 and height 1, in 3D so wide, 3.5 in y, that it is slender along x and through z only.
Mesh bar(int dimension, int along, int layers) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lengths = {12, dimension == 2 ? 1.0 : 3.5, 1};
  shape.divisions = {along, dimension == 2 ? layers : 1, layers};
  return box(shape);
}

/// Standard cells, Young's modulus 1.
BendingQuery query(double nu, double slenderness = 4) {
  const double mu = 1 / (2 * (1 + nu)), lambda = 2 * mu * nu / (1 - 2 * nu);
  BendingQuery own;
  own.block = "body";
  own.moduli = {lambda + mu, mu, 1 / (1 - nu * nu)};
  own.slenderness = slenderness;
  return own;
}

/// Returns the energy of u_x = x y over that of bending in plane strain, in a rectangle of that aspect ratio.
double of_rectangle(double nu, double aspect) {
  return (1 - nu) * (1 - nu) / (1 - 2 * nu) + (1 - nu) / 2 * aspect * aspect;
}

TEST(CellBendingTest, RectanglesAndBricksHaveTheClosedForm) {
  for (int dimension : {2, 3})
    for (double nu : {0.0, 0.3, 0.49, 0.4995})
      for (int along : {10, 20, 80})
        for (int layers : {1, 2, 4}) {
          const CellBending found = typical_bending(bar(dimension, along, layers), query(nu));
          const double aspect = 12.0 / along * layers, cell = of_rectangle(nu, aspect);
          EXPECT_EQ(found.layers, layers);
          EXPECT_NEAR(found.aspect, aspect, 1e-12);
          EXPECT_NEAR(found.cell, cell, 1e-10 * cell);
          EXPECT_NEAR(found.body, 1 + (cell - 1) / (layers * layers), 1e-10 * cell);
        }
}

TEST(CellBendingTest, NothingDependsOnPlaceAndSize) {
  const CellBending straight = typical_bending(bar(2, 40, 3), query(0.3));
  Mesh mesh = bar(2, 40, 3);
  for (std::size_t n = 0; n < mesh.coordinates.size(); n += 2) {
    const double x = mesh.coordinates[n], y = mesh.coordinates[n + 1];
    mesh.coordinates[n] = 3 * (0.6 * x - 0.8 * y) + 7;
    mesh.coordinates[n + 1] = 3 * (0.8 * x + 0.6 * y) - 5;
  }
  const CellBending turned = typical_bending(mesh, query(0.3));
  EXPECT_NEAR(turned.body, straight.body, 1e-12);
  EXPECT_NEAR(turned.cell, straight.cell, 1e-12);
  EXPECT_EQ(turned.layers, 3);
}

// A ring of 40 by 2 cells, without ends: cells of the mean length 5 pi/40 and the height 0.25.
TEST(CellBendingTest, ARingIsSlenderAlongItsCircle) {
  constexpr int along = 40;
  Mesh mesh;
  for (int layer = 0; layer <= 2; ++layer)
    for (int k = 0; k < along; ++k) {
      const double angle = 2 * 3.14159265358979 * k / along, radius = 2.25 + 0.25 * layer;
      mesh.coordinates.insert(mesh.coordinates.end(), {radius * std::cos(angle), radius * std::sin(angle)});
    }
  ElementBlock block;
  block.name = "body";
  for (int layer = 0; layer < 2; ++layer)
    for (int k = 0; k < along; ++k) {
      const int next = (k + 1) % along, low = layer * along, high = low + along;
      block.nodes.insert(block.nodes.end(), {low + next, low + k, high + k, high + next});
    }
  mesh.blocks.push_back(block);
  const CellBending found = typical_bending(mesh, query(0.3));
  EXPECT_EQ(found.layers, 2);
  EXPECT_NEAR(found.aspect, 5 * 3.14159 / along / 0.25, 0.1);
  EXPECT_NEAR(found.cell, of_rectangle(0.3, found.aspect), 0.05);
}

TEST(CellBendingTest, CompactBodiesSupportedLayersAndQuadraticCellsDoNotBend) {
  BoxShape shape;
  shape.lengths = {3, 1, 1};
  shape.divisions = {3, 1, 1};
  EXPECT_EQ(typical_bending(box(shape), query(0.3)).layers, 0);
  EXPECT_EQ(typical_bending(box(shape), query(0.3)).body, 1);
  EXPECT_EQ(typical_bending(box(shape), query(0.3, 0)).layers, 1) << "asked for all directions";
  shape.divisions = {1, 1, 1};
  EXPECT_EQ(typical_bending(box(shape), query(0.3, 0)).layers, 0) << "one cell";

  Mesh mesh = bar(2, 20, 2);
  BendingQuery supported = query(0.3);
  supported.held.assign(static_cast<std::size_t>(mesh.nodes()), false);
  for (std::size_t n = 0; n < supported.held.size(); ++n) supported.held[n] = mesh.coordinates[2 * n + 1] == 0;
  EXPECT_EQ(typical_bending(mesh, supported).body, 1);
  for (std::size_t n = 0; n < supported.held.size(); ++n) supported.held[n] = mesh.coordinates[2 * n] == 0;
  EXPECT_EQ(typical_bending(mesh, supported).layers, 2) << "a clamped end";
  raise_order(mesh);
  EXPECT_EQ(typical_bending(mesh, query(0.3)).body, 1);
}

TEST(CellBendingTest, EnhancedCellsLockOnlyWhereTheyAreEnriched) {
  Mesh mesh = bar(2, 40, 1);
  BendingQuery enhanced = query(0.3);
  enhanced.enriched_only = true;
  EXPECT_EQ(typical_bending(mesh, enhanced).body, 1);
  enrich(mesh, "bottom", ContactElement::Q1C2);
  EXPECT_NEAR(typical_bending(mesh, enhanced).body, of_rectangle(0.3, 0.3), 1e-12);
}

}  // namespace
}  // namespace ixos
