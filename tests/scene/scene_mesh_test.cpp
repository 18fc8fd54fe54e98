#include "scene/scene_mesh.hpp"

#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <cmath>

#include "base/error.hpp"
#include "mesh/generators/spatula.hpp"
#include "scene/parameters.hpp"

namespace ixos {
namespace {

/// The list "Mesh" with all defaults, of that type and without further sets.
Teuchos::ParameterList mesh_list(const std::string& type) {
  Teuchos::ParameterList list = scene_parameters().sublist("Mesh");
  list.remove("Sets");
  list.sublist("Sets");
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

}  // namespace
}  // namespace ixos
