// Which sets of faces are grids that bicubic Hermite faces can be on.
#include "mesh/enrichment/face_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/enrichment/conformity.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

/// Flat quadrilaterals, as hexahedra of height 1 with the set "bottom".
Mesh slab(const std::vector<std::array<double, 2>>& points, const std::vector<std::array<int, 4>>& faces) {
  Mesh mesh;
  mesh.dimension = 3;
  for (double z : {0.0, 1.0})
    for (const auto& [x, y] : points) mesh.coordinates.insert(mesh.coordinates.end(), {x, y, z});
  ElementBlock block{"body", CellType::Hex8, {}};
  SideSet bottom{"bottom", {}};
  for (const auto& face : faces) {
    for (int shift : {0, static_cast<int>(points.size())})
      for (int node : face) block.nodes.push_back(node + shift);
    bottom.sides.push_back({0, block.cells() - 1, 4});
  }
  mesh.blocks = {block};
  mesh.side_sets = {bottom};
  return mesh;
}

/// n quadrilaterals around a point; of a closed fan the last joins the first.
Mesh fan(int n, bool closed) {
  std::vector<std::array<double, 2>> points{{5, 7}};
  std::vector<std::array<int, 4>> faces;
  const int rays = closed ? n : n + 1;
  for (int k = 0; k < rays; ++k)
    for (double shift : {0.0, 0.5}) {
      const double angle = 2 * M_PI * (k + shift) / (closed ? n : n + 1);
      points.push_back({5 + std::cos(angle), 7 + std::sin(angle)});
    }
  for (int k = 0; k < n; ++k) faces.push_back({0, 1 + 2 * k, 2 + 2 * k, 1 + 2 * ((k + 1) % rays)});
  return slab(points, faces);
}

std::string refused(Mesh mesh) {
  return test::refusal([&] { enrich(mesh, "bottom", ContactElement::Q1CH); });
}

TEST(FaceGridTest, WhatIsNoRegularGridIsRefusedWithItsPlace) {
  EXPECT_EQ(refused(fan(4, true)), "");
  EXPECT_EQ(refused(fan(1, false)), "");
  EXPECT_EQ(refused(fan(2, false)), "");
  EXPECT_EQ(refused(fan(3, false)), "");
  const std::string rule =
      "; the Hermite contact element Q1CH needs a regular grid of faces, four around each node inside the set and at "
      "most three around one of its rim; Q1C1 to Q1C4 take any faces";
  for (int n : {3, 5})
    EXPECT_EQ(refused(fan(n, true)),
              "side set \"bottom\", node 1 at (5, 7, 0): " + std::to_string(n) + " faces meet around it" + rule);
  EXPECT_EQ(refused(fan(4, false)), "side set \"bottom\", node 1 at (5, 7, 0): 4 faces meet at it on the rim" + rule);
  // Two bodies that share an edge of their bottoms, and a third: three faces at one edge.
  Mesh pages = slab({{0, 0}, {0, 1}, {1, 1}, {1, 0}, {-1, 1}, {-1, 0}, {2, 1}, {2, 0}},
                    {{0, 3, 2, 1}, {0, 1, 4, 5}, {0, 7, 6, 1}});
  EXPECT_NE(refused(pages).find("more than two faces share an edge that ends there" + rule), std::string::npos);
}

TEST(FaceGridTest, ThreeFacesAroundANodeGiveASoundMesh) {
  Mesh mesh = fan(3, false);
  enrich(mesh, "bottom", ContactElement::Q1CH);
  test::expect_sound(mesh, "fan of three");
}

}  // namespace
}  // namespace ixos
