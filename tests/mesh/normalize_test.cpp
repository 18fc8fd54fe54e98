#include "mesh/normalize.hpp"

#include <gtest/gtest.h>

#include "mesh/cell_order.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/generators/shapes.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

/// Two squares side by side with three coordinates; the right one is clockwise. No cell has node 2.
Mesh plates() {
  Mesh mesh;
  mesh.dimension = 3;
  mesh.coordinates = {0, 0, 0, 1, 0, 0, 9, 9, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0};
  mesh.blocks = {{"left", CellType::Quad4, {0, 1, 5, 4}}, {"right", CellType::Quad4, {1, 5, 6, 3}}};
  mesh.side_sets = {{"right end", {{1, 0, 2}}}, {"top", {{0, 0, 2}, {1, 0, 1}}}};
  mesh.node_sets = {{"ends", {2, 3, 4}}};
  return mesh;
}

TEST(NormalizeTest, UnusedNodesAreDroppedEverywhere) {
  Mesh mesh = plates();
  EXPECT_EQ(drop_unused_nodes(mesh), (std::vector<int>{0, 1, 3, 4, 5, 6}));
  EXPECT_EQ(mesh.notes, std::vector<std::string>{"1 node(s) of the mesh belong to no cell and are left out"});
  EXPECT_EQ(mesh.coordinates, (std::vector<double>{0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0}));
  EXPECT_EQ(mesh.blocks[0].nodes, (std::vector<int>{0, 1, 4, 3}));
  EXPECT_EQ(mesh.blocks[1].nodes, (std::vector<int>{1, 4, 5, 2}));
  EXPECT_EQ(mesh.node_sets[0].nodes, (std::vector<int>{2, 3}));
  drop_unused_nodes(mesh);
  EXPECT_EQ(mesh.notes.size(), 1U);
}

TEST(NormalizeTest, ClockwiseCellsAreTurnedAndTheirSidesStayWhereTheyAre) {
  Mesh mesh = plates();
  const Mesh before = mesh;
  flatten(mesh);
  EXPECT_EQ(mesh.dimension, 2);
  EXPECT_EQ(mesh.coordinates, (std::vector<double>{0, 0, 1, 0, 9, 9, 2, 0, 0, 1, 1, 1, 2, 1}));
  EXPECT_EQ(mesh.blocks[0].nodes, before.blocks[0].nodes);
  EXPECT_EQ(mesh.blocks[1].nodes, (std::vector<int>{1, 3, 6, 5}));
  for (std::size_t s = 0; s < mesh.side_sets.size(); ++s)
    for (std::size_t k = 0; k < mesh.side_sets[s].sides.size(); ++k)
      EXPECT_EQ(sorted_corners(mesh, mesh.side_sets[s].sides[k]), sorted_corners(before, before.side_sets[s].sides[k]));
}

TEST(NormalizeTest, QuadraticCellsAreTurnedWithTheirMiddleNodes) {
  BoxShape shape;
  shape.divisions = {2, 1, 1};
  Mesh plane = box(shape);
  raise_order(plane);
  Mesh mesh = plane;
  mesh.dimension = 3;
  mesh.coordinates.clear();
  for (std::size_t k = 0; k < plane.coordinates.size(); k += 2)
    mesh.coordinates.insert(mesh.coordinates.end(), {plane.coordinates[k], plane.coordinates[k + 1], 0});
  std::vector<int>& nodes = mesh.blocks[0].nodes;
  const std::vector<int> own(nodes.begin() + 9, nodes.end());
  const std::size_t clockwise[] = {0, 3, 2, 1, 7, 6, 5, 4, 8};
  for (std::size_t a = 0; a < 9; ++a) nodes[9 + a] = own[clockwise[a]];
  flatten(mesh);
  EXPECT_EQ(mesh.coordinates, plane.coordinates);
  EXPECT_EQ(mesh.blocks[0].nodes, plane.blocks[0].nodes);
}

TEST(NormalizeTest, MeshesOutsideThePlaneAreRefused) {
  Mesh mesh = plates();
  mesh.coordinates[11] = 1e-9;  // 1e-10 of the size
  flatten(mesh);
  mesh = plates();
  mesh.coordinates[11] = 1e-6;
  test::expect_contains(test::refusal([&] { flatten(mesh); }),
                        "the quadrilaterals do not lie in the plane z = 0: a node stands at (2, 0, 1e-06)");
  EXPECT_EQ(mesh.dimension, 3);
}

}  // namespace
}  // namespace ixos
