// Meshes that gmsh wrote (gmsh/README.md), and changes of them.
#include "io/gmsh_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>

#include "mesh/cell_sides.hpp"
#include "mesh/quality.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

using test::expect_contains;
using test::refusal;

std::string path(const std::string& name) { return IXOS_TEST_DIRECTORY "/io/gmsh/" + name + ".msh"; }

template <class Set>
std::vector<std::string> names(const std::vector<Set>& sets) {
  std::vector<std::string> result;
  for (const Set& set : sets) result.push_back(set.name);
  return result;
}

/// Returns the places of nodes, with zeros for missing coordinates.
std::set<std::array<double, 3>> places(const Mesh& mesh, const std::vector<int>& nodes) {
  std::set<std::array<double, 3>> result;
  const auto d = static_cast<std::size_t>(mesh.dimension);
  for (int node : nodes) {
    std::array<double, 3> x{};
    std::copy_n(&mesh.coordinates[static_cast<std::size_t>(node) * d], d, x.begin());
    result.insert(x);
  }
  return result;
}
std::set<std::array<double, 3>> places(const Mesh& mesh, const SideSet& set) {
  std::vector<int> nodes;
  for (const Side& side : set.sides)
    for (int corner : sorted_corners(mesh, side))
      if (corner >= 0) nodes.push_back(corner);
  return places(mesh, nodes);
}

/// Writes the file with `from` replaced by `to`, and returns the path.
std::string changed(const std::string& name, const std::string& from, const std::string& to) {
  std::ifstream file(path(name), std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  const std::string copy = testing::TempDir() + "changed.msh";
  std::ofstream(copy, std::ios::binary) << text.replace(place, from.size(), to);
  return copy;
}

TEST(GmshMeshTest, GroupsBecomeBlocksAndSetsOfTheirNames) {
  for (const char* name : {"plates", "plates-binary", "plates-parametric"}) {
    SCOPED_TRACE(name);
    const Mesh mesh = read_gmsh_mesh(path(name));
    EXPECT_EQ(mesh.dimension, 2);
    EXPECT_EQ(mesh.nodes(), 15);
    EXPECT_EQ(names(mesh.blocks), (std::vector<std::string>{"soft", "hard one"}));
    EXPECT_EQ(mesh.blocks[0].cells(), 4);
    EXPECT_EQ(mesh.blocks[1].cells(), 4);
    EXPECT_EQ(names(mesh.side_sets), (std::vector<std::string>{"bottom", "seam", "nowhere", "surface_9"}));
    EXPECT_EQ(names(mesh.node_sets), (std::vector<std::string>{"corner", "bottom", "seam", "nowhere", "surface_9"}));
    const std::set<std::array<double, 3>> bottom{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}};
    EXPECT_EQ(mesh.side_sets[0].sides.size(), 4U);
    const auto rounded = [](std::set<std::array<double, 3>> all) {  // gmsh places nodes on curves to 1e-12
      std::set<std::array<double, 3>> result;
      for (std::array<double, 3> x : all) {
        for (double& coordinate : x) coordinate = std::round(1e9 * coordinate) / 1e9;
        result.insert(x);
      }
      return result;
    };
    EXPECT_EQ(rounded(places(mesh, mesh.side_sets[0])), bottom);
    EXPECT_EQ(rounded(places(mesh, mesh.node_sets[1].nodes)), bottom);
    EXPECT_EQ(places(mesh, mesh.node_sets[0].nodes), (std::set<std::array<double, 3>>{{4, 2, 0}}));
    EXPECT_EQ(mesh.side_sets[1].sides.size(), 2U);
    for (const Side& side : mesh.side_sets[1].sides) EXPECT_EQ(side.block, 0);  // the first of the two neighbours
    EXPECT_TRUE(mesh.side_sets[2].sides.empty());
    EXPECT_TRUE(mesh.notes.empty());
    EXPECT_NO_THROW(check_cells(mesh));  // the right square is clockwise in the file
    EXPECT_NEAR(mesh_quality(mesh).volume, 8, 1e-9);
    EXPECT_NEAR(mesh_quality(mesh).least_scaled_jacobian, 1, 1e-9);
  }
}

TEST(GmshMeshTest, HexahedraHaveSidesEdgesAndCorners) {
  for (const char* name : {"bricks", "bricks-binary"}) {
    const Mesh mesh = read_gmsh_mesh(path(name));
    EXPECT_EQ(mesh.dimension, 3);
    EXPECT_EQ(mesh.cells(), 8);
    EXPECT_EQ(names(mesh.blocks), std::vector<std::string>{"block"});
    EXPECT_EQ(names(mesh.side_sets), (std::vector<std::string>{"bottom", "top"}));
    EXPECT_EQ(names(mesh.node_sets), (std::vector<std::string>{"corner", "edge", "bottom", "top"}));
    for (const auto& [set, z] : {std::pair(0U, 0.0), std::pair(1U, 1.0)}) {
      const auto found = places(mesh, mesh.side_sets[set]);
      EXPECT_EQ(found.size(), 9U);
      for (const auto& x : found) EXPECT_EQ(x[2], z);
    }
    EXPECT_EQ(mesh.node_sets[1].nodes.size(), 3U);
    check_cells(mesh);
    EXPECT_NEAR(mesh_quality(mesh).volume, 1, 1e-12);
  }
}

TEST(GmshMeshTest, WithoutGroupsTheCellsAreTheBody) {
  const Mesh mesh = read_gmsh_mesh(path("arc"));
  EXPECT_EQ(names(mesh.blocks), std::vector<std::string>{"body"});
  EXPECT_TRUE(mesh.side_sets.empty());
  EXPECT_EQ(mesh.nodes(), 12);  // without the centre of the arc
  EXPECT_EQ(mesh.notes, std::vector<std::string>{"1 node(s) of the mesh belong to no cell and are left out"});
  // Three cells along the arc of 90 degrees, radii 1 and 2.
  EXPECT_NEAR(mesh_quality(mesh).volume, 3 * 0.5 * (4 - 1) * std::sin(std::acos(-1.0) / 6), 1e-9);
}

TEST(GmshMeshTest, OtherCellsAreRefusedWithTheRecipe) {
  expect_contains(refusal([] { read_gmsh_mesh(path("triangles")); }),
                  "triangles.msh: has triangles with 3 nodes; quadrilaterals with 4 nodes (2D) and hexahedra with 8 "
                  "(3D) are allowed. In gmsh, put these lines into the .geo file and mesh it again: "
                  "Mesh.ElementOrder = 1; Mesh.RecombineAll = 1; Mesh.SubdivisionAlgorithm = 1;");
  const std::string solid = refusal([] { read_gmsh_mesh(path("tetrahedra")); });
  expect_contains(solid, "has tetrahedra with 4 nodes");
  expect_contains(solid, "Mesh.SubdivisionAlgorithm = 2;");
  expect_contains(refusal([] { read_gmsh_mesh(path("plates-order-2")); }), "has quadrilaterals with 9 nodes");
  expect_contains(refusal([] { read_gmsh_mesh(path("plates-22")); }), "the format is MSH 2.2; 4.1 is allowed");
  expect_contains(refusal([] { read_gmsh_mesh(path("plates-parts")); }), "the mesh is partitioned");
}

TEST(GmshMeshTest, GroupsThatMakeNoMeshAreRefused) {
  const auto refused = [](const char* from, const char* to) {
    const std::string file = changed("plates", from, to);
    return refusal([&] { read_gmsh_mesh(file); });
  };
  expect_contains(refused("\"hard one\"", "\"soft\""), "changed.msh: two physical groups make the block \"soft\"");
  expect_contains(refused("\"seam\"", "\"bottom\""), "two physical groups make the side set \"bottom\"");
  expect_contains(refused("\"corner\"", "\"bottom\""), "two physical groups make the node set \"bottom\"");
  // The surface 1 in both groups.
  expect_contains(refused("1 0 0 0 2 2 0 1 1 ", "1 0 0 0 2 2 0 2 1 2 "),
                  "the quadrilaterals of entity 1 belong to the physical groups \"soft\" and \"hard one\"");
}

TEST(GmshMeshTest, TheSameBytesMakeTheSameMesh) {
  const Mesh one = read_gmsh_mesh(path("plates")), other = read_gmsh_mesh(path("plates-binary"));
  EXPECT_EQ(one.blocks[1].nodes, other.blocks[1].nodes);
  ASSERT_EQ(one.coordinates.size(), other.coordinates.size());
  for (std::size_t k = 0; k < one.coordinates.size(); ++k)
    EXPECT_NEAR(one.coordinates[k], other.coordinates[k], 1e-15);  // ASCII has 16 digits
}

}  // namespace
}  // namespace ixos
