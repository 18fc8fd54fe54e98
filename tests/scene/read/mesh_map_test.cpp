#include "scene/read/mesh_map.hpp"

#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <string>

#include "parameters/validation.hpp"
#include "scene/read/parameters.hpp"
#include "scene/read/scene_mesh.hpp"
#include "scene/scene_file.hpp"
#include "support/refusal.hpp"
#include "test_folders.hpp"

namespace ixos {
namespace {

/// The list "Mesh" of a box with all defaults.
Teuchos::ParameterList box_list() {
  Teuchos::ParameterList list = scene_parameters().sublist("Mesh");
  for (const char* named : {"Sets", "Refine", "Ties", "Periodic"}) {
    list.remove(named);
    list.sublist(named);
  }
  list.set("Type", "Box");
  return list;
}

TEST(MeshMapTest, AMapMovesTheNodes) {
  Teuchos::ParameterList list = box_list();
  list.sublist("Box").set("Divisions", Teuchos::Array<int>(Teuchos::tuple(2, 2)));
  list.sublist("Box").set("Lengths", Teuchos::Array<double>(Teuchos::tuple(1.0, 2.0)));
  const Mesh plain = scene_mesh(list, ".");
  list.sublist("Map").set("X", std::string("x^2 + y"));
  const Mesh mapped = scene_mesh(list, ".");
  ASSERT_EQ(mapped.nodes(), 9);
  for (std::size_t k = 0; k < plain.coordinates.size(); k += 2) {
    const double x = plain.coordinates[k], y = plain.coordinates[k + 1];
    EXPECT_DOUBLE_EQ(mapped.coordinates[k], x * x + y);
    EXPECT_EQ(mapped.coordinates[k + 1], y);
  }
}

TEST(MeshMapTest, MapsThatMoveNodesNowhereAreRefused) {
  const auto refusal_of = [](const char* name, const char* expression) {
    Teuchos::ParameterList list = box_list();
    list.sublist("Map").set(name, std::string(expression));
    return test::refusal([&] { scene_mesh(list, "."); });
  };
  test::expect_contains(refusal_of("X", "1 +"), "Mesh/Map/X: ");
  test::expect_contains(refusal_of("Y", "ln(-1 - x)"), "Mesh/Map/Y: the node at (0, 0, 0) has no finite place");
  test::expect_contains(refusal_of("Z", "x"), "Mesh/Map/Z: a mesh of two dimensions has no third coordinate");
  test::expect_contains(refusal_of("X", "-x"), "inverted");
}

// The scene of the guide.
TEST(MeshMapTest, ABoxIsGradedAndHasAParabolicBottom) {
  Teuchos::ParameterList scene =
      validated(read_scene_file(std::string(IXOS_TEST_DIRECTORY) + "/guide/graded-box.xml"), scene_parameters());
  const Mesh mesh = scene_mesh(scene.sublist("Mesh"), ".");
  double widest = 0;
  for (std::size_t k = 0; k < mesh.coordinates.size(); k += 2) widest = std::max(widest, mesh.coordinates[k]);
  EXPECT_DOUBLE_EQ(widest, 90 + 0.4 * 900);
  EXPECT_DOUBLE_EQ(mesh.coordinates[2], 0.5);
  const auto bottom = std::find_if(mesh.node_sets.begin(), mesh.node_sets.end(),
                                   [](const NodeSet& set) { return set.name == "bottom"; });
  ASSERT_NE(bottom, mesh.node_sets.end());
  for (const int node : bottom->nodes) {
    const double* place = &mesh.coordinates[2 * static_cast<std::size_t>(node)];
    EXPECT_NEAR(place[1], place[0] * place[0] / 2000, 1e-12);
  }
}

}  // namespace
}  // namespace ixos
