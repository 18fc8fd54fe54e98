#include "scene/read/scene_mesh.hpp"

#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <cmath>

#include "base/error.hpp"
#include "mesh/generators/spatula.hpp"
#include "parameters/parameter_entries.hpp"
#include "parameters/validation.hpp"
#include "scene/read/parameters.hpp"
#include "test_folders.hpp"

namespace ixos {
namespace {

/// The list "Mesh" with all defaults, of that type and without further sets.
Teuchos::ParameterList mesh_list(const std::string& type) {
  Teuchos::ParameterList list = scene_parameters().sublist("Mesh");
  for (const char* named : {"Sets", "Refine", "Ties", "Periodic"}) {
    list.remove(named);
    list.sublist(named);
  }
  list.set("Type", type);
  return list;
}

TEST(SceneMeshTest, AMeshFileMayHaveAUnitOfLength) {
  Teuchos::ParameterList list = mesh_list("Exodus");
  list.sublist("Exodus").set("File", std::string(IXOS_TEST_DIRECTORY) + "/../meshes/ball.e");
  const Mesh own = scene_mesh(list, ".");
  list.sublist("Exodus").set("Length Unit", 1000.0);
  const Mesh larger = scene_mesh(list, ".");
  for (std::size_t k = 0; k < own.coordinates.size(); ++k) ASSERT_EQ(larger.coordinates[k], 1000 * own.coordinates[k]);
}

TEST(SceneMeshTest, TheSizeOfAMeshFileIsNoted) {
  const UnitSystem nano("1 nm", "2 GPa", "1 ns");
  Teuchos::ParameterList list = mesh_list("Gmsh");
  list.sublist("Gmsh").set("File", std::string(IXOS_TEST_DIRECTORY) + "/../meshes/pillar.msh");
  EXPECT_EQ(size_note(list, scene_mesh(list, "."), nano), "the mesh spans 30 x 40 L0 = 30 nm x 40 nm");
  list.sublist("Gmsh").set("Length Unit", 1000.0);
  EXPECT_EQ(size_note(list, scene_mesh(list, "."), nano), "the mesh spans 30000 x 40000 L0 = 30 um x 40 um");
  list = mesh_list("Box");
  EXPECT_EQ(size_note(list, scene_mesh(list, "."), nano), "");
}

TEST(SceneMeshTest, SpatulaTakesEveryParameterOfItsList) {
  Teuchos::ParameterList list = mesh_list("Spatula");
  Teuchos::ParameterList& own = list.sublist("Spatula");
  SpatulaShape shape;
  own.set("Target Cells", shape.target_cells = 1000);
  const std::vector<std::pair<const char*, double SpatulaShape::*>> lengths{
      {"Pad Length", &SpatulaShape::pad_length},
      {"Neck Width", &SpatulaShape::neck_width},
      {"Tip Width", &SpatulaShape::tip_width},
      {"Widening Length", &SpatulaShape::widening_length},
      {"Tip Length", &SpatulaShape::tip_length},
      {"Rear Thickness", &SpatulaShape::rear_thickness},
      {"Tip Thickness", &SpatulaShape::tip_thickness},
      {"Transition Length", &SpatulaShape::transition_length},
      {"Fillet Radius", &SpatulaShape::fillet_radius},
      {"Shaft Diameter", &SpatulaShape::shaft_diameter},
      {"Shaft Length", &SpatulaShape::shaft_length},
      {"Inclination", &SpatulaShape::inclination},
      {"Gap", &SpatulaShape::gap},
      {"Growth", &SpatulaShape::growth},
      {"Layer Ratio", &SpatulaShape::layer_ratio}};
  double factor = 1.01;  // each is changed by another factor
  for (const auto& [name, member] : lengths) {
    EXPECT_EQ(own.get<double>(name), shape.*member) << name;
    own.set(name, shape.*member *= factor);
    factor += 0.001;
  }
  const std::vector<std::pair<const char*, int SpatulaShape::*>> counts{{"Core Cells", &SpatulaShape::core_cells},
                                                                        {"Core Layers", &SpatulaShape::core_layers},
                                                                        {"Rings", &SpatulaShape::rings},
                                                                        {"Tip Rows", &SpatulaShape::tip_rows},
                                                                        {"Stations", &SpatulaShape::stations}};
  for (const auto& [name, member] : counts) EXPECT_EQ(own.get<int>(name), shape.*member) << name;
  EXPECT_EQ(scene_mesh(list, ".").coordinates, spatula(shape).coordinates);
  own.set("Core Cells", shape.core_cells = 12);
  own.set("Core Layers", shape.core_layers = 3);
  own.set("Rings", shape.rings = 1);
  own.set("Tip Rows", shape.tip_rows = 4);
  own.set("Stations", shape.stations = 40);
  EXPECT_EQ(scene_mesh(list, ".").coordinates, spatula(shape).coordinates);
}

TEST(SceneMeshTest, RefusedShapesNameTheMesh) {
  Teuchos::ParameterList list = mesh_list("Spatula");
  list.sublist("Spatula").set("Tip Length", 140.0);
  try {
    scene_mesh(list, ".");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "Mesh/Spatula: tip length 140 must be at most the pad length less the widening length, 130");
  }
}

TEST(SceneMeshTest, AMeshOfGmshIsFoundBesideTheScene) {
  Teuchos::ParameterList list = mesh_list("Gmsh");
  list.sublist("Gmsh").set("File", std::string("io/gmsh/plates.msh"));
  const Mesh mesh = scene_mesh(list, IXOS_TEST_DIRECTORY);
  EXPECT_EQ(mesh.cells(), 8);
  EXPECT_EQ(list.sublist("Gmsh").get<std::string>("File"), IXOS_TEST_DIRECTORY "/io/gmsh/plates.msh");
  list.sublist("Gmsh").set("Dimension", 3);
  try {
    scene_mesh(list, IXOS_TEST_DIRECTORY);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("is a mesh of 2 dimensions, but the scene wants 3"), std::string::npos)
        << error.what();
  }
}

TEST(SceneMeshTest, AGivenMeshTakesThePlaceOfAnyOther) {
  Teuchos::ParameterList scene("Scene");
  scene.sublist("Mesh").set("Type", "Box");
  scene.sublist("Mesh").sublist("Box").set("Dimension", 3);
  scene.sublist("Mesh")
      .sublist("Sets")
      .sublist("lower")
      .set("Kind", "Nodes")
      .set("Upper", Teuchos::Array<double>(Teuchos::tuple(0.5, 0.5)));
  const Teuchos::ParameterList changed = with_given_mesh(scene, 2, false);
  EXPECT_EQ(changed.sublist("Mesh").get<std::string>("Type"), "Given");
  EXPECT_FALSE(changed.sublist("Mesh").isParameter("Box"));
  EXPECT_EQ(changed.sublist("Mesh").sublist("Given").get<int>("Dimension"), 2);

  EXPECT_FALSE(is_axisymmetric(changed.sublist("Mesh")));
  EXPECT_TRUE(is_axisymmetric(with_given_mesh(scene, 2, true).sublist("Mesh")));
  EXPECT_TRUE(is_axisymmetric(with_given_mesh(with_given_mesh(scene, 2, true), 2, false).sublist("Mesh")));

  Mesh square;
  square.coordinates = {0, 0, 1, 0, 1, 1, 0, 1};
  square.blocks = {{"body", CellType::Quad4, {0, 1, 2, 3}}};
  const Teuchos::ParameterList complete = validated(changed.sublist("Mesh"), scene_parameters().sublist("Mesh"));
  const Mesh whole = scene_mesh(complete, square);
  ASSERT_EQ(whole.node_sets.size(), 1U);
  EXPECT_EQ(whole.node_sets[0].name, "lower");
  EXPECT_EQ(whole.node_sets[0].nodes, std::vector<int>{0});
  square.blocks[0].nodes = {3, 2, 1, 0};
  try {
    scene_mesh(complete, square);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("Mesh: block \"body\", cell 1 at (0.5, 0.5): inverted"), std::string::npos)
        << error.what();
  }
}

TEST(SceneMeshTest, SetsTakeEveryParameterOfTheirList) {
  using Numbers = Teuchos::Array<double>;
  const auto sides = [](const char* name, const auto& value, const char* other = nullptr, double number = 0) {
    Teuchos::ParameterList list = mesh_list("Box");
    list.sublist("Box").set("Divisions", Teuchos::Array<int>(Teuchos::tuple(4, 2)));
    list.sublist("Box").set("Lengths", Numbers(Teuchos::tuple(4.0, 2.0)));
    Teuchos::ParameterList& set = list.sublist("Sets").sublist("chosen");
    set = scene_parameters().sublist("Mesh").sublist("Sets").sublist(any_name);
    set.set(name, value);
    if (other != nullptr) set.set(other, number);
    return scene_mesh(list, ".").side_sets.back().sides.size();
  };
  EXPECT_EQ(sides("Kind", std::string("Sides")), 12U);  // the whole boundary
  EXPECT_EQ(sides("From", std::string("left")), 2U);
  EXPECT_EQ(sides("Lower", Numbers(Teuchos::tuple<double>(0, 2))), 4U);
  EXPECT_EQ(sides("Upper", Numbers(Teuchos::tuple<double>(4, 0))), 4U);
  EXPECT_EQ(sides("Plane Normal", Numbers(Teuchos::tuple<double>(3, 0))), 2U);
  EXPECT_EQ(sides("Sphere Radius", 1.0), 2U);
  EXPECT_EQ(sides("Sphere Center", Numbers(Teuchos::tuple<double>(2, 0)), "Sphere Radius", 1.0), 2U);
  EXPECT_EQ(sides("Normal", Numbers(Teuchos::tuple<double>(1, 0))), 2U);
  EXPECT_EQ(sides("Normal", Numbers(Teuchos::tuple<double>(1, 0)), "Normal Angle", 90.0), 10U);
  EXPECT_EQ(sides("Upper", Numbers(Teuchos::tuple<double>(4, -0.5)), "Tolerance", 0.6), 4U);
}

}  // namespace
}  // namespace ixos
