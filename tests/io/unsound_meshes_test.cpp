// Meshes that a file's format allows and a scene cannot mean: refused, or warned of.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "io/exodus_mesh.hpp"
#include "mesh/generators/shapes.hpp"
#include "scene/simulation.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::expect_contains;
using test::list;
using test::numbers;
using test::word;

/// Four by two squares of side 1.
Mesh strip() {
  BoxShape shape;
  shape.lengths = {4, 2, 1};
  shape.divisions = {4, 2, 1};
  return box(shape);
}

/// A scene of the mesh, read from a file: its bottom adheres.
Teuchos::ParameterList scene_of(const Mesh& mesh, const std::string& conditions, const std::string& side_set) {
  const std::string path = testing::TempDir() + "unsound.e";
  write_exodus_mesh(mesh, path, "unsound");
  return test::scene(list("Mesh", word("Type", "Exodus") + list("Exodus", word("File", path))) +
                     list("Materials", list("Rubber", "")) +
                     list("Interactions", list("Wall", word("Side Set", side_set) + numbers("Point", {0, -0.5}))) +
                     list("Boundary Conditions", conditions) + test::time_integrator("Midpoint", 0.002, 0.02));
}
std::string refusal(const Mesh& mesh, const std::string& conditions = "", const std::string& side_set = "bottom") {
  return test::refusal([&] { Simulation(scene_of(mesh, conditions, side_set), test::self()); });
}
std::vector<std::string> warnings(const Teuchos::ParameterList& scene) {
  std::vector<std::string> messages;
  const Simulation simulation(scene, test::self());
  for (const Warning& warning : simulation.warnings()) messages.push_back(warning.message);
  return messages;
}
std::vector<std::string> warnings(const Mesh& mesh, const std::string& conditions = "") {
  return warnings(scene_of(mesh, conditions, "bottom"));
}

SideSet& side_set(Mesh& mesh, const std::string& name) {
  return *std::find_if(mesh.side_sets.begin(), mesh.side_sets.end(), [&](const SideSet& s) { return s.name == name; });
}

/// Gives the cells to the right of x a node of their own wherever they share one with a cell to the left.
void cut(Mesh& mesh, double x) {
  std::vector<int>& nodes = mesh.blocks[0].nodes;
  const int before = mesh.nodes();
  std::vector<int> copies(static_cast<std::size_t>(before), -1);
  for (std::size_t first = 0; first < nodes.size(); first += 4) {
    double centre = 0;
    for (std::size_t k = 0; k < 4; ++k) centre += mesh.coordinates[2 * static_cast<std::size_t>(nodes[first + k])] / 4;
    if (centre < x) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto node = static_cast<std::size_t>(nodes[first + k]);
      if (mesh.coordinates[2 * node] != x) continue;
      if (copies[node] < 0) {
        copies[node] = mesh.nodes();
        mesh.coordinates.push_back(x);
        mesh.coordinates.push_back(mesh.coordinates[2 * node + 1]);
      }
      nodes[first + k] = copies[node];
    }
  }
}

TEST(UnsoundMeshesTest, ASoundMeshHasNoWarnings) { EXPECT_TRUE(warnings(strip()).empty()); }

TEST(UnsoundMeshesTest, CellsGivenTwiceAreRefused) {
  Mesh mesh = strip();
  std::vector<int>& nodes = mesh.blocks[0].nodes;
  // Element 3 again, begun at another corner.
  const std::vector<int> again{nodes[9], nodes[10], nodes[11], nodes[8]};
  nodes.insert(nodes.end(), again.begin(), again.end());
  expect_contains(refusal(mesh), "unsound.e: elements 3 and 9 have the same nodes");
}

TEST(UnsoundMeshesTest, SidesInsideTheBodyAreRefusedWhereAWallActsOnThem) {
  Mesh mesh = strip();
  side_set(mesh, "bottom").sides.push_back({0, 0, 2});  // between elements 1 and 5
  expect_contains(refusal(mesh),
                  "Interactions/Wall/Side Set: the side set \"bottom\" has side 3 of element 1, which lies inside the "
                  "body: element 5 is on its other side");
  // Nothing acts there otherwise.
  Mesh sound = strip();
  side_set(sound, "top").sides.push_back({0, 0, 2});
  EXPECT_EQ(refusal(sound), "");
}

TEST(UnsoundMeshesTest, ANodeBelowTheWallIsRefusedWhereQuadraturePointsAreAboveIt) {
  Mesh mesh = strip();
  mesh.coordinates[2 * 2 + 1] = -0.515;  // the wall is at -0.5, the bottom's other nodes are at 0
  expect_contains(
      refusal(mesh),
      "Interactions/Wall: the surface \"bottom\" starts in or below the wall, least gap -0.015 at node 3 of "
      "the mesh at (2, -0.515); all gaps must be positive");
}

TEST(UnsoundMeshesTest, EmptySetsAreRefusedWhereSomethingActsOnThem) {
  Mesh mesh = strip();
  mesh.side_sets.push_back({"nowhere", {}});
  mesh.node_sets.push_back({"nobody", {}});
  EXPECT_EQ(refusal(mesh), "");
  expect_contains(refusal(mesh, "", "nowhere"), "Interactions/Wall/Side Set: the side set \"nowhere\" has no sides");
  expect_contains(refusal(mesh, list("Grip", word("Node Set", "nobody"))),
                  "Boundary Conditions/Grip/Node Set: the node set \"nobody\" has no nodes");
  expect_contains(
      refusal(mesh, list("Pull", word("Type", "Traction") + word("Side Set", "nowhere") + numbers("Vector", {1, 0}))),
      "Boundary Conditions/Pull/Side Set: the side set \"nowhere\" has no sides");
}

TEST(UnsoundMeshesTest, CoincidentNodesAndLoosePartsAreWarnedOf) {
  Mesh mesh = strip();
  cut(mesh, 2);
  // Bottom sides of both halves adhere, so both are held.
  std::vector<std::string> found = warnings(mesh);
  ASSERT_EQ(found.size(), 1U);
  expect_contains(found[0], "3 node(s) of the mesh stand where another one stands, the first at (2, 0)");

  // Only the left half is held: the other one's bottom is free, and nothing else acts on it.
  std::vector<Side>& bottom = side_set(mesh, "bottom").sides;
  bottom.erase(std::remove_if(bottom.begin(), bottom.end(), [](const Side& side) { return side.cell % 4 >= 2; }),
               bottom.end());
  found = warnings(mesh);
  ASSERT_EQ(found.size(), 2U);
  expect_contains(found[1], "4 of the mesh's 8 elements");
  expect_contains(found[1], "share no side with the rest, and nothing holds them");
  EXPECT_EQ(warnings(mesh, list("Grip", word("Node Set", "right"))).size(), 1U);
}

TEST(UnsoundMeshesTest, PartsThatHangByANodeAreWarnedOf) {
  Mesh mesh = strip();
  // Without elements 3 and 6 (and 7, 8) of 1 2 3 4 / 5 6 7 8, 4 would be alone; keep 1, 6: they share one node.
  const std::vector<int> all = mesh.blocks[0].nodes;
  const auto cell = [&](std::size_t c) {
    return std::vector<int>(all.begin() + 4 * static_cast<long>(c), all.begin() + 4 * static_cast<long>(c) + 4);
  };
  Mesh hinge;
  hinge.dimension = 2;
  std::vector<int> nodes = cell(0), other = cell(5);
  nodes.insert(nodes.end(), other.begin(), other.end());
  std::vector<int> numbers(static_cast<std::size_t>(mesh.nodes()), -1);
  for (int& node : nodes) {
    int& number = numbers[static_cast<std::size_t>(node)];
    if (number < 0) {
      number = hinge.nodes();
      for (std::size_t i = 0; i < 2; ++i)
        hinge.coordinates.push_back(mesh.coordinates[2 * static_cast<std::size_t>(node) + i]);
    }
    node = number;
  }
  hinge.blocks = {{"body", CellType::Quad4, nodes}};
  hinge.side_sets = {{"bottom", {{0, 0, 0}}}};
  const std::vector<std::string> found = warnings(hinge);
  ASSERT_EQ(found.size(), 1U);
  expect_contains(found[0], "1 of the mesh's 2 elements");
  expect_contains(found[0], "hang on it by 1 node(s)");
}

/// Two squares that have no node in common where they meet, as gmsh writes them.
std::string torn_squares() {
  const std::string path = testing::TempDir() + "torn.msh";
  std::ofstream(path) << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n1 1 \"bottom\"\n$EndPhysicalNames\n"
                         "$Entities\n0 1 1 0\n1 0 0 0 2 0 0 1 1 0\n1 0 0 0 2 1 0 0 0\n$EndEntities\n"
                         "$Nodes\n1 8 1 8\n2 1 0 8\n1\n2\n3\n4\n5\n6\n7\n8\n"
                         "0 0 0\n1 0 0\n1 1 0\n0 1 0\n1 0 0\n2 0 0\n2 1 0\n1 1 0\n$EndNodes\n"
                         "$Elements\n2 4 1 4\n1 1 1 2\n1 1 2\n2 5 6\n2 1 3 2\n3 1 2 3 4\n4 5 6 7 8\n$EndElements\n";
  return path;
}

TEST(UnsoundMeshesTest, MeshesOfGmshAreWarnedOfAndRefusedAlike) {
  const std::string scene = list("Mesh", word("Type", "Gmsh") + list("Gmsh", word("File", torn_squares()))) +
                            list("Materials", list("Rubber", "")) + test::time_integrator("Midpoint", 0.002, 0.02);
  const auto with_wall = [&](const std::string& side_set) {
    return test::scene(scene +
                       list("Interactions", list("Wall", word("Side Set", side_set) + numbers("Point", {0, -0.5}))));
  };
  const std::vector<std::string> found = warnings(with_wall("bottom"));
  ASSERT_EQ(found.size(), 1U);
  expect_contains(found[0], "2 node(s) of the mesh stand where another one stands, the first at (1, 0)");
  expect_contains(test::refusal([&] { Simulation(with_wall("bottum"), test::self()); }),
                  "side set \"bottum\" does not exist; did you mean \"bottom\"? The mesh has \"bottom\"");
}

TEST(UnsoundMeshesTest, AMeshWithoutSideSetsHasNoNearestName) {
  Mesh mesh = strip();
  mesh.side_sets.clear();
  const std::string message = refusal(mesh, "", "bottom");
  expect_contains(message, "side set \"bottom\" does not exist. The mesh has none; Mesh/Sets can select one");
}

// Nodes of two parts may stand at one place, nodes of one part may not.
TEST(UnsoundMeshesTest, PartsFromFilesAreJudgedEachAlone) {
  Mesh broken = strip();
  cut(broken, 2);
  const auto scene = [](const Mesh& mesh) {
    const std::string path = testing::TempDir() + "unsound_part.e";
    write_exodus_mesh(mesh, path, "unsound");
    const std::string file = word("Type", "Exodus") + list("Exodus", word("File", path));
    return test::scene(
        list("Mesh", word("Type", "Parts") +
                         list("Parts", list("lower", file) + list("upper", file + numbers("Translation", {0, 2})))) +
        list("Materials", list("A", word("Block", "lower_body")) + list("B", word("Block", "upper_body"))) +
        list("Interactions", list("Wall", word("Side Set", "lower_bottom") + numbers("Point", {0, -0.5}))) +
        test::time_integrator("Midpoint", 0.002, 0.02));
  };
  const auto named = [](const std::vector<std::string>& messages, const std::string& words) {
    return std::count_if(messages.begin(), messages.end(),
                         [&](const std::string& message) { return message.find(words) != std::string::npos; });
  };
  const std::vector<std::string> sound = warnings(scene(strip())), faulty = warnings(scene(broken));
  EXPECT_EQ(named(sound, "part \""), 0);
  for (const char* part : {"lower", "upper"})
    EXPECT_EQ(named(faulty, "part \"" + std::string(part) + "\": 3 node(s) of the mesh stand where"), 1) << part;
  EXPECT_EQ(named(faulty, "part \"lower\": 4 of the mesh's 8 elements"), 0);  // the wall holds both halves
  EXPECT_EQ(named(faulty, "part \"upper\": 4 of the mesh's 8 elements"), 1);
  const Simulation simulation(scene(strip()), test::self());
  EXPECT_EQ(named(simulation.notes(), "the part \"lower\" spans 4 x 2 L0 = 4 nm x 2 nm; the part \"upper\" spans"), 1);
}

}  // namespace
}  // namespace ixos
