#include "mesh/generators/given.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "support/refusal.hpp"

namespace ixos {
namespace {

/// Two squares in a row, with a set of each kind.
Mesh squares() {
  Mesh mesh;
  mesh.dimension = 2;
  mesh.coordinates = {0, 0, 1, 0, 2, 0, 0, 1, 1, 1, 2, 1};
  mesh.blocks = {{"body", CellType::Quad4, {0, 1, 4, 3, 1, 2, 5, 4}}};
  mesh.node_sets = {{"left", {0, 3}}};
  mesh.side_sets = {{"bottom", {{0, 0, 0}, {0, 1, 0}}}};
  return mesh;
}

std::string refusal(const std::function<void(Mesh&)>& change) {
  Mesh mesh = squares();
  change(mesh);
  return test::refusal([&] { check_arrays(mesh); });
}

TEST(GivenMeshTest, ArraysThatFitAreAccepted) {
  EXPECT_EQ(test::refusal([] { check_arrays(squares()); }), "");
}

TEST(GivenMeshTest, ArraysThatDoNotFitAreRefused) {
  EXPECT_EQ(refusal([](Mesh& m) { m.dimension = 4; }), "the points have 4 coordinates; 2 or 3 are allowed");
  EXPECT_EQ(refusal([](Mesh& m) { m.coordinates.pop_back(); }),
            "11 coordinates are not those of points in 2 dimensions");
  EXPECT_EQ(refusal([](Mesh& m) { m.coordinates[7] = std::numeric_limits<double>::infinity(); }),
            "point 3 has the coordinate inf; it must be finite");
  EXPECT_EQ(refusal([](Mesh& m) { m.blocks.clear(); }), "the mesh has no blocks; at least one is needed");
  EXPECT_EQ(refusal([](Mesh& m) { m.blocks[0].nodes[1] = 6; }),
            "block \"body\" has node 6; the points are numbered from 0 to 5");
  EXPECT_EQ(refusal([](Mesh& m) { m.blocks[0].nodes.pop_back(); }),
            "block \"body\": 7 node numbers are not those of cells with 4 nodes");
  EXPECT_EQ(refusal([](Mesh& m) { m.blocks[0].type = CellType::Hex8; }),
            "block \"body\": its cells have 8 nodes; in 2 dimensions cells have 3, 4, 6, 7 or 9");
  EXPECT_EQ(refusal([](Mesh& m) {
              m.coordinates.insert(m.coordinates.end(), {9, 9});
            }),
            "point 6 belongs to no cell; remove it");
  EXPECT_EQ(refusal([](Mesh& m) { m.blocks.push_back(m.blocks[0]); }), "two blocks have the name \"body\"");
  EXPECT_EQ(refusal([](Mesh& m) { m.node_sets[0].name = ""; }), "a node set has an empty name");
  EXPECT_EQ(refusal([](Mesh& m) { m.node_sets[0].nodes[0] = -1; }),
            "node set \"left\" has node -1; the points are numbered from 0 to 5");
  EXPECT_EQ(refusal([](Mesh& m) { m.node_sets[0].nodes[1] = 0; }), "node set \"left\" has node 0 twice");
  EXPECT_EQ(refusal([](Mesh& m) { m.side_sets[0].sides[1].side = 4; }),
            "side set \"bottom\" has side 4 of cell 1 of block 0, which does not exist");
  EXPECT_EQ(refusal([](Mesh& m) { m.side_sets[0].sides[1].cell = 0; }),
            "side set \"bottom\" has side 0 of cell 0 of block 0 twice");
}

TEST(GivenMeshTest, TheCommandHasNone) {
  const MeshEntry entry = given_mesh();
  const Teuchos::ParameterList list;
  EXPECT_NE(test::refusal([&] { entry.make(SceneNode(list, "Mesh")); }).find("a program provides this mesh"),
            std::string::npos);
}

}  // namespace
}  // namespace ixos
