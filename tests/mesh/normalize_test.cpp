#include "mesh/normalize.hpp"

#include <gtest/gtest.h>

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

TEST(NormalizeTest, TheThirdCoordinateIsDropped) {
  Mesh mesh = plates();
  const Mesh before = mesh;
  flatten(mesh);
  EXPECT_EQ(mesh.dimension, 2);
  EXPECT_EQ(mesh.coordinates, (std::vector<double>{0, 0, 1, 0, 9, 9, 2, 0, 0, 1, 1, 1, 2, 1}));
  for (std::size_t b = 0; b < 2; ++b) EXPECT_EQ(mesh.blocks[b].nodes, before.blocks[b].nodes);
}

TEST(NormalizeTest, MeshesOutsideThePlaneAreRefused) {
  Mesh mesh = plates();
  mesh.coordinates[11] = 1e-9;  // 1e-10 of the size
  flatten(mesh);
  mesh = plates();
  mesh.coordinates[11] = 1e-6;
  test::expect_contains(test::refusal([&] { flatten(mesh); }),
                        "the surface elements do not lie in the plane z = 0: a node stands at (2, 0, 1e-06)");
  EXPECT_EQ(mesh.dimension, 3);
}

}  // namespace
}  // namespace ixos
