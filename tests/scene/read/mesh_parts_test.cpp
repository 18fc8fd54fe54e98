#include "scene/read/mesh_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "mesh/cell_order.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/connected_parts.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/joined_parts.hpp"
#include "mesh/quality.hpp"
#include "scene/read/scene_mesh.hpp"
#include "scene/read/scene_units.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"
#include "test_folders.hpp"

namespace ixos {
namespace {

using test::count;
using test::counts;
using test::expect_contains;
using test::list;
using test::number;
using test::numbers;
using test::word;

Teuchos::ParameterList scene_of(const std::string& parts, const std::string& more_of_mesh,
                                const std::string& more = "") {
  return complete_scene(test::scene(list("Mesh", word("Type", "Parts") + list("Parts", parts) + more_of_mesh) + more +
                                    test::time_integrator("Newmark", 0.1, 1)));
}

Mesh made(const std::string& parts, const std::string& more = "") {
  Teuchos::ParameterList complete = scene_of(parts, more);
  return scene_mesh(complete.sublist("Mesh"), IXOS_TEST_DIRECTORY);
}

std::string refusal(const std::string& parts, const std::string& more = "") {
  return test::refusal([&] { made(parts, more); });
}

const std::string block = word("Type", "Box");
const std::string solid = word("Type", "Box") + list("Box", count("Dimension", 3) + numbers("Lengths", {1, 1, 1}) +
                                                                counts("Divisions", {1, 1, 1}));

std::vector<std::string> block_names(const Mesh& mesh) {
  std::vector<std::string> names;
  for (const ElementBlock& own : mesh.blocks) names.push_back(own.name);
  return names;
}

const SideSet& side_set(const Mesh& mesh, const std::string& name) {
  const auto found =
      std::find_if(mesh.side_sets.begin(), mesh.side_sets.end(), [&](const SideSet& set) { return set.name == name; });
  if (found == mesh.side_sets.end()) throw InputError("no side set " + name);
  return *found;
}

TEST(MeshPartsTest, PartsAreMeshesOfTheCatalogue) {
  DiskShape shape;
  const Mesh expected = joined_parts({{"disk", disk(shape)}, {"box", box(BoxShape{})}});
  const Mesh mesh = made(list("disk", "") + list("box", block));
  EXPECT_EQ(mesh.coordinates, expected.coordinates);
  EXPECT_EQ(block_names(mesh), (std::vector<std::string>{"disk_body", "box_body"}));
}

TEST(MeshPartsTest, CurvedGeneratorsMakeTheirOwnQuadraticCells) {
  DiskShape shape;
  shape.cell_order = 2;
  Mesh square = box(BoxShape{});
  raise_order(square);
  const Mesh mesh = made(list("disk", "") + list("box", block), count("Cell Order", 2));
  EXPECT_EQ(mesh.coordinates, joined_parts({{"disk", disk(shape)}, {"box", square}}).coordinates);
  EXPECT_NE(mesh.linear_nodes, -1);
}

TEST(MeshPartsTest, APartIsMappedTurnedAndMoved) {
  // The unit square becomes 2 wide, turns about its corner (2, 0) to the left and up, and moves.
  const Mesh mesh = made(list("moved", block + list("Map", word("X", "2*x")) + number("Rotation Angle", 90) +
                                           numbers("Rotation Point", {2, 0}) + numbers("Translation", {10, 20})));
  EXPECT_EQ(mesh.coordinates, (std::vector<double>{12, 18, 12, 20, 11, 18, 11, 20}));
}

TEST(MeshPartsTest, InThreeDimensionsAPartTurnsAboutAnyAxis) {
  const Mesh mesh = made(list("a", solid + number("Rotation Angle", 90) + numbers("Rotation Axis", {3, 0, 0})));
  for (std::size_t k = 0; k < mesh.coordinates.size(); k += 3) {  // y to z, z to -y
    EXPECT_LE(mesh.coordinates[k + 1], 0);
    EXPECT_GE(mesh.coordinates[k + 2], 0);
  }
  EXPECT_NEAR(mesh_quality(mesh).volume, 1, 1e-14);
}

TEST(MeshPartsTest, SetsOfAPartFollowItAndThoseOfTheMeshSeeAllParts) {
  const std::string upper = list("half", numbers("Normal", {0, 1}));
  const Mesh mesh = made(list("a", block + number("Rotation Angle", 180) + list("Sets", upper)) +
                             list("b", block + numbers("Translation", {5, 0})),
                         list("Sets", list("tops", numbers("Normal", {0, 1}))));
  ASSERT_EQ(side_set(mesh, "a_half").sides.size(), 1U);
  EXPECT_EQ(side_set(mesh, "a_half").sides[0].side, side_set(mesh, "a_top").sides[0].side);
  ASSERT_EQ(side_set(mesh, "tops").sides.size(), 2U);
  EXPECT_EQ(side_set(mesh, "tops").sides[0].side, side_set(mesh, "a_bottom").sides[0].side);
}

TEST(MeshPartsTest, FilesOfPartsAreFoundBesideTheScene) {
  const std::string file = word("Type", "Gmsh") + list("Gmsh", word("File", "io/gmsh/plates.msh"));
  const Mesh mesh = made(list("plates", file) + list("box", block));
  EXPECT_EQ(mesh.cells(), 9);
  expect_contains(refusal(list("plates", word("Type", "Gmsh") + list("Gmsh", word("File", "nothing.msh")))),
                  "Mesh/Parts/plates/Gmsh");
}

TEST(MeshPartsTest, UnitsOfLoadsFollowTheDimensionOfTheFirstPart) {
  const auto load = [](const std::string& part, const std::string& unit) {
    return test::refusal([&] {
      scene_of(list("a", part) + list("b", part), "",
               list("Boundary Conditions", list("Pull", word("Type", "Point Force") + word("Node Set", "a_top") +
                                                            word("Vector", "{0, 0, 1 " + unit + "}"))));
    });
  };
  EXPECT_EQ(load(solid, "nN"), "");
  EXPECT_NE(load(block, "nN"), "");
}

/// Two posts on a layer, of these numbers of cells across each post.
std::string posts(double merge, int across = 2, const std::string& more = "") {
  const auto post = [&](const std::string& name, double x) {
    return list(name, block + more +
                          list("Box", numbers("Lower", {x, 1}) + numbers("Lengths", {1, 2}) +
                                          counts("Divisions", {across, 4})));
  };
  return number("Merge", merge) +
         list("layer", block + more + list("Box", numbers("Lengths", {4, 1}) + counts("Divisions", {8, 2}))) +
         post("a", 0.5) + post("b", 2.5);
}

TEST(MeshPartsTest, PartsThatShareAFaceAreMerged) {
  const Mesh apart = made(posts(0)), one = made(posts(1e-6));
  EXPECT_EQ(apart.nodes(), 9 * 3 + 2 * 3 * 5);
  EXPECT_EQ(one.nodes(), apart.nodes() - 2 * 3);
  EXPECT_EQ(block_names(one), block_names(apart));
  const std::vector<int> bodies = connected_parts(apart);
  EXPECT_EQ(std::set<int>(bodies.begin(), bodies.end()).size(), 3U);
  const std::vector<int> parts = connected_parts(one);
  EXPECT_TRUE(std::all_of(parts.begin(), parts.end(), [](int part) { return part == 0; }));
  // The shared faces are inside: 2 of the layer's top's 8, and all of a post's bottom.
  EXPECT_EQ(side_set(apart, "layer_top").sides.size(), 8U);
  EXPECT_EQ(side_set(one, "layer_top").sides.size(), 4U);
  EXPECT_THROW(side_set(one, "a_bottom"), InputError);
  EXPECT_EQ(side_set(one, "a_top").sides.size(), 2U);
  double boundary = 0;
  for (const char* set : {"layer_surface", "a_surface", "b_surface"})
    boundary += static_cast<double>(side_set(one, set).sides.size());
  EXPECT_EQ(boundary, static_cast<double>(boundary_sides(one).size()));
  expect_contains(one.notes.back(), "6 nodes of parts were merged");
}

TEST(MeshPartsTest, PartsOfQuadraticCellsAndInSpaceAreMerged) {
  const Mesh quadratic = made(posts(1e-6), count("Cell Order", 2)), apart = made(posts(0), count("Cell Order", 2));
  EXPECT_EQ(quadratic.nodes(), apart.nodes() - 2 * 5);
  EXPECT_EQ(quadratic.linear_nodes, apart.linear_nodes - 2 * 3);
  const std::string cube =
      list("Box", count("Dimension", 3) + numbers("Lengths", {1, 1, 1}) + counts("Divisions", {2, 2, 2}));
  const Mesh cubes = made(number("Merge", 1e-6) + list("low", block + cube) +
                          list("high", block + cube + numbers("Translation", {0, 0, 1})));
  EXPECT_EQ(cubes.nodes(), 3 * 3 * 5);
  EXPECT_EQ(boundary_sides(cubes).size(), 2U * 4 + 4 * 8);
}

TEST(MeshPartsTest, MergesThatDoNotFitAreRefused) {
  EXPECT_EQ(refusal(posts(0.6)),
            "Mesh/Parts/Merge: 0.6 is too large: it makes one node of two nodes of the part \"a\" near (0.5, 1.5); it "
            "must be "
            "smaller than the distance of its nodes");
  expect_contains(refusal(posts(1e-6, 1)), "Mesh/Parts/Merge: the parts \"");
  for (const int across : {3, 4, 5}) expect_contains(refusal(posts(1e-6, across)), "touch near ");
  const std::string size = list("Box", numbers("Lengths", {1, 1}) + counts("Divisions", {2, 2}));
  const auto low = [&](const std::string& place) {
    return number("Merge", 1e-6) + list("low", block + size) + list("high", block + size + place);
  };
  expect_contains(refusal(low(numbers("Translation", {0, 0}))), "overlaps another one near ");
  expect_contains(refusal(low(numbers("Translation", {0.3, 1}) + "")), "no node of a part is within");
  EXPECT_EQ(refusal(low(numbers("Translation", {0.5, 1}))), "");  // half of the face is shared
  EXPECT_EQ(refusal(number("Merge", 0.1) + list("left", block) + list("right", block + numbers("Translation", {9, 0}))),
            "Mesh/Parts/Merge: no node of a part is within 0.1 of a node of another part");
}

TEST(MeshPartsTest, WhatDoesNotFitIsRefusedWithItsPart) {
  expect_contains(refusal(""), "Mesh/Parts: there is no part");
  expect_contains(refusal(list("a", block) + list("b", solid)),
                  "Mesh/Parts: the part \"a\" has 2 dimensions, but the part \"b\" has 3");
  expect_contains(refusal(list("a b", block)), "Mesh/Parts: part \"a b\": a name of a part has letters");
  expect_contains(refusal(list("a", word("Type", "Parts"))), "Mesh/Parts/a/Type: \"Parts\" does not exist");
  expect_contains(refusal(list("a", word("Type", "Given"))), "Mesh/Parts/a/Type: \"Given\" does not exist");
  expect_contains(refusal(list("a", block + numbers("Rotation Axis", {0, 0, 1}))), "Mesh/Parts/a/Rotation Axis: ");
  expect_contains(refusal(list("a", solid + numbers("Rotation Axis", {0, 0, 0}))),
                  "Mesh/Parts/a/Rotation Axis is zero");
  expect_contains(refusal(list("a", block + numbers("Translation", {1, 2, 3}))), "Mesh/Parts/a/Translation");
  expect_contains(refusal(list("a", block + list("Map", word("X", "-x")))),
                  "Mesh/Parts/a: block \"body\", cell 1 at (-0.5, 0.5): inverted");
  expect_contains(refusal(list("a", block + list("Disk", ""))), "Mesh/Parts/a");
  expect_contains(refusal(list("a", list("Disk", count("Core Divisions", 3)))), "Mesh/Parts/a/Disk: core divisions 3");
}

}  // namespace
}  // namespace ixos
