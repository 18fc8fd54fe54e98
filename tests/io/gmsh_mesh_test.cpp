// Meshes that gmsh wrote (gmsh/README.md), and changes of them.
#include "io/gmsh_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>
#include <tuple>

#include "fem/cell_info.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/curved_cells.hpp"
#include "mesh/quality.hpp"
#include "mesh/set_size.hpp"
#include "mesh/soundness.hpp"
#include "support/refusal.hpp"
#include "test_folders.hpp"

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

TEST(GmshMeshTest, TrianglesAndTetrahedraAreRead) {
  for (const auto& [name, type, d] :
       {std::tuple("triangles", CellType::Tri3, 2), std::tuple("tetrahedra", CellType::Tet4, 3)}) {
    const Mesh mesh = read_gmsh_mesh(path(name));
    EXPECT_EQ(mesh.dimension, d);
    ASSERT_EQ(mesh.blocks.size(), 1U);
    EXPECT_EQ(mesh.blocks[0].type, type);
    EXPECT_NO_THROW(check_cells(mesh));
    EXPECT_NEAR(mesh_quality(mesh).volume, 1, 1e-12);
  }
}

// Version 2.2 names no entities and has no parametric coordinates; the mesh is the same.
TEST(GmshMeshTest, FilesOfVersion22HoldTheSameMesh) {
  const Mesh mesh = read_gmsh_mesh(path("plates-22")), other = read_gmsh_mesh(path("plates"));
  EXPECT_EQ(names(mesh.blocks), names(other.blocks));
  EXPECT_EQ(names(mesh.side_sets), names(other.side_sets));
  for (std::size_t set = 0; set < mesh.side_sets.size(); ++set)
    EXPECT_EQ(mesh.side_sets[set].sides.size(), other.side_sets[set].sides.size());
  EXPECT_NO_THROW(check_cells(mesh));
  EXPECT_NEAR(mesh_quality(mesh).volume, 8, 1e-9);
}

TEST(GmshMeshTest, CellsOfSecondOrderAreRead) {
  const Mesh mesh = read_gmsh_mesh(path("plates-order-2"));
  for (const ElementBlock& block : mesh.blocks) EXPECT_EQ(block.type, CellType::Quad9);
  EXPECT_NO_THROW(check_cells(mesh));
  EXPECT_NEAR(mesh_quality(mesh).volume, 8, 1e-9);
  EXPECT_EQ(mesh.side_sets[0].sides.size(), 4U);
  EXPECT_EQ(places(mesh, mesh.node_sets[1].nodes).size(), 9U);
}

/// All nodes stand in the middle of their corners: those of each type are in the right order.
void expect_straight(const Mesh& mesh) {
  for (const ElementBlock& block : mesh.blocks)
    EXPECT_FALSE(needs_high_rule(mesh, block)) << cell_info(block.type).name;
  const auto d = static_cast<std::size_t>(mesh.dimension);
  for (const ElementBlock& block : mesh.blocks) {
    const CellInfo& info = cell_info(block.type);
    for (int cell = 0; cell < block.cells(); ++cell)
      for (std::size_t a = 0; a < info.node_corners.size(); ++a)
        for (std::size_t i = 0; i < d; ++i) {
          const auto x = [&](int own) {
            return mesh.coordinates[d * static_cast<std::size_t>(block.nodes[cell_entry(cell, info.nodes, own)]) + i];
          };
          double middle = 0;
          for (const int corner : info.node_corners[a])
            middle += x(corner) / static_cast<double>(info.node_corners[a].size());
          EXPECT_NEAR(x(static_cast<int>(a)), middle, 1e-12) << info.name << ", node " << a;
        }
  }
}

std::set<CellType> types(const Mesh& mesh) {
  std::set<CellType> all;
  for (const ElementBlock& block : mesh.blocks) all.insert(block.type);
  return all;
}

TEST(GmshMeshTest, MixedMeshesAreReadAsGmshMakesThem) {
  const std::set<CellType> linear{CellType::Hex8, CellType::Pyr5, CellType::Tet4},
      quadratic{CellType::Hex27, CellType::Pyr14, CellType::Tet10};
  for (const char* name : {"mixed", "mixed-2", "mixed-2-22", "mixed-2-22-binary", "mixed-2-edges"}) {
    SCOPED_TRACE(name);
    const Mesh mesh = read_gmsh_mesh(path(name));
    EXPECT_EQ(types(mesh), std::string(name) == "mixed" ? linear : quadratic);
    for (const ElementBlock& block : mesh.blocks) EXPECT_EQ(block.name, "body");
    EXPECT_NO_THROW(check_cells(mesh));
    EXPECT_NO_THROW(require_one_order(mesh));
    EXPECT_NO_THROW(require_shared_middles(mesh));
    EXPECT_NO_THROW(refuse_split_faces(mesh));
    EXPECT_NEAR(mesh_quality(mesh).volume, 2, 1e-12);
    expect_straight(mesh);
    ASSERT_EQ(mesh.side_sets.size(), 1U);
    double area = 0;
    for (const Side& side : mesh.side_sets[0].sides) area += side_measure(mesh, side);
    EXPECT_NEAR(area, 2, 1e-12);
    for (const auto& x : places(mesh, mesh.node_sets.at(0).nodes)) EXPECT_NEAR(x[2], 0, 1e-12);
    // The nodes of the bottom's sides, with those that the file lacks.
    std::set<int> of_sides;
    for (const Side& side : mesh.side_sets[0].sides)
      for (const int node : nodes_of_side(mesh, side)) of_sides.insert(node);
    EXPECT_EQ(std::set<int>(mesh.node_sets[0].nodes.begin(), mesh.node_sets[0].nodes.end()), of_sides);
  }
}

TEST(GmshMeshTest, PrismsOfFifteenNodesBecomeThoseOfEighteen) {
  for (const char* name : {"prisms-2", "prisms-2-edges"}) {
    const Mesh mesh = read_gmsh_mesh(path(name));
    EXPECT_EQ(types(mesh), std::set<CellType>{CellType::Prism18});
    EXPECT_NO_THROW(require_shared_middles(mesh));
    EXPECT_NEAR(mesh_quality(mesh).volume, 1, 1e-12);
    expect_straight(mesh);
  }
}

TEST(GmshMeshTest, RoundedEdgesStayRound) {
  const Mesh mesh = read_gmsh_mesh(path("disk-2"));
  EXPECT_EQ(types(mesh), std::set<CellType>{CellType::Tri6});
  EXPECT_FALSE(needs_high_rule(mesh, mesh.blocks[0])) << "three points serve curved triangles, too";
  for (const auto& x : places(mesh, mesh.node_sets.at(0).nodes)) EXPECT_NEAR(std::hypot(x[0], x[1]), 1, 1e-12);
  // A parabola on an arc of half the angle h misses h^5/30 of its segment, up to terms of h^7.
  const double half = std::acos(-1.0) / 9;
  EXPECT_NEAR(mesh_quality(mesh).volume, std::acos(-1.0) - 9 * std::pow(half, 5) / 30, 9 * std::pow(half, 7) / 30);
  Mesh richer = mesh;
  raise_order(richer, true);
  EXPECT_EQ(types(richer), std::set<CellType>{CellType::Tri7});
  EXPECT_NEAR(mesh_quality(richer).volume, mesh_quality(mesh).volume, 1e-13);
}

TEST(GmshMeshTest, PartitionedMeshesAreRefused) {
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

/// Writes a file of the sections $Entities, $Nodes and $Elements, and returns its path.
std::string written(const std::string& entities, const std::string& nodes, const std::string& elements) {
  const std::string file = testing::TempDir() + "written.msh";
  std::ofstream(file) << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n"
                      << entities << "\n$EndEntities\n$Nodes\n"
                      << nodes << "\n$EndNodes\n$Elements\n"
                      << elements << "\n$EndElements\n";
  return file;
}
std::string refusal_of(const std::string& entities, const std::string& nodes, const std::string& elements) {
  const std::string file = written(entities, nodes, elements);
  return refusal([&] { read_gmsh_mesh(file); });
}

TEST(GmshMeshTest, MessagesOfCellsNameTheTagInTheFile) {
  const std::string nodes = "1 6 1 6\n2 1 0 6\n1\n2\n3\n4\n5\n6\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0";
  const Mesh mesh = read_gmsh_mesh(written("0 0 1 0\n1 0 0 0 2 1 0 0 0", nodes,
                                           "1 2 1 77\n2 1 3 2\n5 1 2 5 4\n77 2 3 5 6"));  // the last crosses itself
  EXPECT_EQ(mesh.blocks.at(0).file_numbers, (std::vector<long long>{5, 77}));
  expect_contains(refusal([&] { check_cells(mesh); }),
                  "block \"body\", cell 2 (number 77 in the file) at (1.5, 0.5): inverted or degenerate");
}

// A brick whose upper side comes first, and its upper side, z = 1, as a physical group.
TEST(GmshMeshTest, LeftHandedHexahedraAreTurnedWithANote) {
  const Mesh mesh = read_gmsh_mesh(
      written("0 0 1 1\n1 0 0 1 1 1 1 1 7 0\n1 0 0 0 1 1 1 0 0",
              "1 8 1 8\n3 1 0 8\n1\n2\n3\n4\n5\n6\n7\n8\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1",
              "2 2 1 2\n2 1 3 1\n1 5 6 7 8\n3 1 5 1\n2 5 6 7 8 1 2 3 4"));
  EXPECT_NO_THROW(check_cells(mesh));
  EXPECT_NEAR(mesh_quality(mesh).volume, 1, 1e-15);
  ASSERT_EQ(mesh.notes.size(), 1U);
  expect_contains(mesh.notes[0], "1 of the mesh's 1 hexahedra are numbered as mirror images");
  EXPECT_EQ(places(mesh, mesh.side_sets.at(0)),
            (std::set<std::array<double, 3>>{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}));
}

// One point entity in many groups, with many elements: each group would get a copy of them all.
TEST(GmshMeshTest, GroupsThatRepeatElementsBeyondTheFileAreRefused) {
  const auto repeated = [](int groups, int points) {
    std::string tags, elements;
    for (int tag = 1; tag <= groups; ++tag) tags += std::to_string(tag) + ' ';
    for (int k = 1; k <= points; ++k) elements += std::to_string(k) + " 1\n";
    const std::string all = std::to_string(points);
    return refusal_of("1 0 0 0\n1 0 0 0 " + std::to_string(groups) + ' ' + tags, "1 1 1 1\n0 1 0 1\n1\n0 0 0",
                      "1 " + all + " 1 " + all + "\n0 1 15 " + all + '\n' + elements);
  };
  const std::string message = repeated(400, 400);
  expect_contains(message, "written.msh: is damaged: its physical groups up to \"group_");
  expect_contains(message, " claim ");
  expect_contains(repeated(10, 400), "has no cells");  // elements may be in some groups
}

TEST(GmshMeshTest, SidesWithoutCellsAreRefusedWithTheCause) {
  const std::string cause =
      "gmsh saves only elements in physical groups: add Physical Surface (2D) or Physical Volume (3D), or Mesh.SaveAll "
      "= 1";
  const std::string nodes = "1 4 1 4\n2 1 0 4\n1\n2\n3\n4\n0 0 1\n1 0 1\n1 1 1\n0 1 1";
  expect_contains(refusal_of("0 1 1 0\n1 0 0 0 1 0 0 1 7 0\n1 0 0 0 1 1 0 0 0", nodes, "1 1 1 1\n1 1 1 1\n1 1 2"),
                  "written.msh: has no cells: a mesh needs surface elements (2D) or volume elements (3D). " + cause);
  const std::string bare = refusal_of("0 1 0 0\n1 0 0 0 1 0 0 0 0", nodes, "1 1 1 1\n1 1 1 1\n1 1 2");
  EXPECT_EQ(bare.find("gmsh saves"), std::string::npos) << bare;
  // The upper side of a block whose volume is in no group.
  const std::string side =
      refusal_of("0 0 1 1\n1 0 0 1 1 1 1 1 7 0\n1 0 0 0 1 1 1 0 0", nodes, "1 1 1 1\n2 1 3 1\n1 1 2 3 4");
  expect_contains(side, "the surface elements do not lie in the plane z = 0");
  expect_contains(side, cause);
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
