// Scenes in space that are plane, and their form in two dimensions.
#include "study/advice/plane_scene.hpp"

#include <gtest/gtest.h>

#include <Teuchos_Array.hpp>

#include "scene/read/parameters.hpp"
#include "scene/read/scene_units.hpp"
#include "scene/scene_file.hpp"
#include "support/plane_block.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;
using Numbers = std::vector<double>;

List scene(const std::vector<std::string>& settings = {}) {
  List result = read_scene_text(test::plane_block, "block");
  for (const std::string& setting : settings) set_parameter(result, scene_parameters(), setting);
  return result;
}
Numbers numbers(const List& list, const char* name) { return list.get<Teuchos::Array<double>>(name).toVector(); }
std::string why(const std::vector<std::string>& settings) { return why_spatial(complete_scene(scene(settings))); }

TEST(PlaneSceneTest, ABlockBetweenSmoothWallsIsPlane) {
  EXPECT_EQ(why({}), "");
  EXPECT_EQ(why({"Interactions/Wall/Obstacle=Cylinder", "Interactions/Wall/Cylinder/Radius=5",
                 "Interactions/Wall/Cylinder/Axis={0, 2, 0}"}),
            "");
}

TEST(PlaneSceneTest, TellsWhatNeedsSpace) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"Mesh/Type=Disk"}, "Mesh: it is no box"},
      {{"Mesh/Map/Z=z + y"}, "Mesh: it is mapped"},
      {{"Mesh/Sets/contact/Upper={1.5, 1.9, 9}"}, "Mesh/Sets/contact: its box ends within the depth"},
      {{"Mesh/Sets/contact/From=surface"}, "Mesh/Sets/contact: it is a part of surface"},
      {{"Mesh/Sets/contact/From="}, "Mesh/Sets/contact: it may have sides of front and back"},
      {{"Mesh/Sets/contact/From=", "Mesh/Sets/contact/Normal={0, 0, -1}", "Mesh/Sets/contact/Normal Angle=90"},
       "Mesh/Sets/contact: it may have sides of front and back"},
      {{"Boundary Conditions/Front/Components=z"}, "the face front may leave its plane"},
      {{"Boundary Conditions/Back/Node Set=left"}, "the face back may leave its plane"},
      {{"Boundary Conditions/More/Node Set=front", "Boundary Conditions/More/Components=x"},
       "Boundary Conditions/More: it moves front otherwise than along y"},
      {{"Histories/Pull/Type=Constant", "Histories/Pull/Constant/Value=1", "Boundary Conditions/Left/History=Pull"},
       "Boundary Conditions/Left: it moves along y"},
      {{"Boundary Conditions/Wind/Type=Gravity", "Boundary Conditions/Wind/Vector={0, 1, 0}"},
       "Boundary Conditions/Wind: its vector points along y"},
      {{"Interactions/Wall/Side Set=back"}, "Interactions/Wall: it acts on back"},
      {{"Interactions/Wall/Normal={0, 0.1, 1}"}, "Interactions/Wall: its wall looks along y"},
      {{"Interactions/Wall/Factor=1 + y"}, "Interactions/Wall: it has a factor"},
      {{"Interactions/Wall/Obstacle=Sphere", "Interactions/Wall/Sphere/Radius=5"},
       "Interactions/Wall: its obstacle is a Sphere"},
      {{"Interactions/Wall/Obstacle=Cylinder", "Interactions/Wall/Cylinder/Radius=5"},
       "Interactions/Wall: its cylinder does not lie along y"},
      {{"Initial Conditions/Velocity={0, 1, 0}"}, "Initial Conditions: the body turns or moves along y"},
      {{"Initial Conditions/Angular Velocity={0, 1, 0}"}, "Initial Conditions: the body turns or moves along y"}};
  for (const auto& [settings, reason] : cases) EXPECT_EQ(why(settings), reason);
}

TEST(PlaneSceneTest, TheSceneInTwoDimensionsIsComplete) {
  const List flat =
      plane_scene(scene({"Boundary Conditions/Top/Node Set=top", "Boundary Conditions/Top/Components=z"}));
  const List& box = flat.sublist("Mesh").sublist("Box");
  EXPECT_EQ(box.get<int>("Dimension"), 2);
  EXPECT_EQ(numbers(box, "Lower"), (Numbers{0, 0.4}));
  EXPECT_EQ(numbers(box, "Lengths"), (Numbers{2, 1}));
  EXPECT_EQ(box.get<Teuchos::Array<int>>("Divisions").toVector(), (std::vector<int>{8, 4}));
  EXPECT_EQ(numbers(flat.sublist("Mesh").sublist("Sets").sublist("contact"), "Upper"), (Numbers{1.5, 9}));
  const List& conditions = flat.sublist("Boundary Conditions");
  EXPECT_FALSE(conditions.isSublist("Front"));
  EXPECT_FALSE(conditions.isSublist("Back"));
  EXPECT_EQ(conditions.sublist("Left").get<std::string>("Components"), "x");
  EXPECT_EQ(conditions.sublist("Top").get<std::string>("Components"), "y");
  EXPECT_EQ(numbers(flat.sublist("Initial Conditions"), "Velocity"), (Numbers{0, -20}));
  EXPECT_EQ(flat.sublist("Output").get<Teuchos::Array<std::string>>("Reactions").toVector(),
            std::vector<std::string>{"left"});
  EXPECT_EQ(numbers(flat.sublist("Output").sublist("Probes").sublist("force"), "Point"), (Numbers{2, 1.4}));
  EXPECT_NO_THROW(complete_scene(flat));
  // With defaults it is the same scene.
  EXPECT_EQ(scene_text(complete_scene(plane_scene(complete_scene(scene())))),
            scene_text(complete_scene(plane_scene(scene()))));
}

TEST(PlaneSceneTest, ColumnsOfTheOtherSceneAndTheirScale) {
  EXPECT_EQ(plane_column("contact_force_z"), "contact_force_y");
  EXPECT_EQ(plane_column("reaction_left_x"), "reaction_left_x");
  EXPECT_EQ(plane_column("force_uz"), "force_uy");
  EXPECT_EQ(plane_column("linear_momentum_z"), "linear_momentum_y");
  EXPECT_EQ(plane_column("elastic_energy"), "elastic_energy");
  for (const char* spatial : {"contact_force_y", "force_vy", "angular_momentum_y", "contact_moment_Wall_x"})
    EXPECT_EQ(plane_column(spatial), std::nullopt) << spatial;
  const List probes = scene().sublist("Output").sublist("Probes");
  for (const char* whole : {"contact_force_z", "reaction_left_x", "elastic_energy", "external_work", "contact_measure",
                            "linear_momentum_x", "dissipated_viscosity"})
    EXPECT_TRUE(grows_with_depth(whole, probes)) << whole;
  for (const char* local : {"force_uz", "min_gap", "min_gap_network", "time_step", "norm_energy_density"})
    EXPECT_FALSE(grows_with_depth(local, probes)) << local;
}

}  // namespace
}  // namespace ixos
