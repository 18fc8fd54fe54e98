#include "parameters/validation.hpp"

#include <gtest/gtest.h>

#include <Teuchos_Array.hpp>
#include <cmath>
#include <sstream>

#include "base/error.hpp"
#include "scene/read/parameters.hpp"
#include "scene/scene_file.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using Teuchos::ParameterList;

std::string refusal(const std::string& lists) {
  try {
    validated(test::scene(lists), scene_parameters());
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

const std::string times =
    test::list("Time Step Control", test::number("Time Step", 0.1) + test::number("Final Time", 1));
const std::string integrator = test::list("Time Integrator", times);

TEST(ValidationTest, MessagesNameThePlaceTheValueAndWhatIsAllowed) {
  const struct {
    std::string lists, message;
  } cases[] = {
      {integrator + test::list("Materiels", ""),
       "Materiels: there is no list \"Materiels\" here; did you mean \"Materials\"?"},
      {integrator + test::list("Materials", test::list("A", test::number("Densty", 1))),
       "Materials/A/Densty: there is no parameter \"Densty\" here; did you mean \"Density\"?"},
      {integrator + test::list("Materials", test::list("A", test::number("Density", -1))),
       "Materials/A/Density: -1 is not allowed: it must be greater than 0"},
      {integrator + test::list("Materials", test::list("A", test::number("Poisson's Ratio", 0.5))),
       "Materials/A/Poisson's Ratio: 0.5 is not allowed: it must be greater than -1 and less than 0.5"},
      {integrator + test::list("Materials", test::list("A", test::word("Density", "heavy"))),
       "Materials/A/Density: heavy is of type string, but it must be of type double"},
      {integrator + test::list("Mesh", test::word("Type", "Disc")),
       "Mesh/Type: \"Disc\" does not exist; did you mean \"Disk\"? Allowed: \"Disk\", \"Ball\", \"Box\""},
      {integrator + test::list("Interactions", test::list("Wall", "")),
       "Interactions/Wall/Side Set is missing: Side set of the surface that interacts."},
      {"", "Time Integrator/Time Step Control/Final Time is missing: Time at which the run ends [T0]."},
      {integrator + test::number("Mesh", 1), "Mesh is a list, not a parameter"},
      {integrator + test::list("Mesh", test::list("Type", "")), "Mesh/Type is a parameter, not a list"},
  };
  for (const auto& c : cases) {
    const std::string message = refusal(c.lists);
    EXPECT_EQ(message.substr(0, c.message.size()), c.message);
  }
}

TEST(ValidationTest, NotANumberIsRefusedEverywhere) {
  const std::string nan = test::list(
      "Time Integrator",
      test::list("Time Step Control", test::number("Time Step", std::nan("")) + test::number("Final Time", 1)));
  EXPECT_NE(refusal(nan).find("Time Step"), std::string::npos) << refusal(nan);
  EXPECT_NE(refusal(integrator + test::list("Initial Conditions", test::numbers("Velocity", {0, std::nan("")})))
                .find("Initial Conditions/Velocity: nan is not allowed"),
            std::string::npos);
}

TEST(ValidationTest, DefaultsAreFilledInAndIntegersServeAsDoubles) {
  const ParameterList complete =
      validated(test::scene(integrator + test::list("Materials", test::list("A", test::count("Density", 2)))),
                scene_parameters());
  EXPECT_EQ(complete.sublist("Materials").sublist("A").get<double>("Density"), 2.0);
  EXPECT_EQ(complete.sublist("Materials").sublist("A").get<double>("Poisson's Ratio"), 0.2);
  EXPECT_EQ(complete.sublist("Time Integrator").get<std::string>("Type"), "Gautam-Sauer Composite");
}

TEST(ValidationTest, OnlyTheChosenVariantIsFilledIn) {
  const ParameterList complete =
      validated(test::scene(test::list("Time Integrator", test::word("Type", "Newmark") + times)), scene_parameters());
  EXPECT_TRUE(complete.sublist("Time Integrator").isSublist("Newmark"));
  EXPECT_FALSE(complete.sublist("Time Integrator").isSublist("Bathe Composite"));
}

TEST(ValidationTest, VariantsThatAreNotChosenAreCheckedAllTheSame) {
  EXPECT_NE(
      refusal(test::list("Time Integrator", test::word("Type", "Newmark") + times +
                                                test::list("Bathe Composite", test::number("Spectral Radius", 2))))
          .find("Time Integrator/Bathe Composite/Spectral Radius: 2 is not allowed"),
      std::string::npos);
}

/// A wall with these entries.
std::string wall(const std::string& entries) {
  return integrator + test::list("Interactions", test::list("Wall", test::word("Side Set", "surface") + entries));
}

TEST(ValidationTest, ParametersOfWhatIsNotChosenAreRefused) {
  const std::string sphere = test::list("Sphere", test::number("Radius", 2));
  const struct {
    std::string lists, message;
  } cases[] = {
      {wall(test::word("Law", "Morse") + test::number("Gamma L", 2.5)),
       "Interactions/Wall: \"Gamma L\" belongs to Law \"Van der Waals\", but Law is \"Morse\"; remove it, or set Law "
       "to \"Van der Waals\""},
      {wall(test::list("Morse", test::number("Strength", 1))),
       "Interactions/Wall: \"Morse\" belongs to Law \"Morse\", but Law is \"Van der Waals\"; remove it, or set Law to "
       "\"Morse\""},
      {wall(sphere), "Interactions/Wall: \"Sphere\" belongs to Obstacle \"Sphere\", but Obstacle is \"Half-Space\""},
      {wall(test::word("Obstacle", "Sphere") + sphere + test::numbers("Point", {0, 1})),
       "Interactions/Wall: \"Point\" belongs to Obstacle \"Half-Space\", but Obstacle is \"Sphere\""},
      {integrator + test::list("Mesh", test::word("Type", "Disk") + test::list("Box", "")),
       "Mesh: \"Box\" belongs to Type \"Box\", but Type is \"Disk\""},
      {integrator +
           test::list("Histories", test::list("Pull", test::word("Type", "Constant") + test::list("Sine", ""))),
       "Histories/Pull: \"Sine\" belongs to Type \"Sine\", but Type is \"Constant\""},
  };
  for (const auto& c : cases) {
    const std::string message = refusal(c.lists);
    EXPECT_EQ(message.substr(0, c.message.size()), c.message);
  }
}

TEST(ValidationTest, ParametersThatLawsShareAreAcceptedWithEachOfThem) {
  for (const char* law : {"Neo-Hooke", "Linear Elastic", "Saint Venant-Kirchhoff"})
    EXPECT_EQ(refusal(integrator + test::list("Materials", test::list("A", test::word("Model", law) +
                                                                               test::number("Young's Modulus", 3)))),
              "accepted");
}

TEST(ValidationTest, LawsOfRubberHaveTheirOwnConstants) {
  const auto material = [](const std::string& entries) {
    return refusal(integrator + test::list("Materials", test::list("A", test::word("Model", "Gent") + entries)));
  };
  EXPECT_EQ(material(test::list("Gent", test::number("Limit", 3) + test::word("Volumetric Energy", "Convex"))),
            "accepted");
  EXPECT_EQ(material(test::number("Young's Modulus", 3)),
            "Materials/A: \"Young's Modulus\" belongs to Model \"Neo-Hooke\" or \"Linear Elastic\" or \"Saint "
            "Venant-Kirchhoff\", but Model is \"Gent\"; remove it, or set Model to \"Neo-Hooke\" or \"Linear "
            "Elastic\" or \"Saint Venant-Kirchhoff\"");
}

TEST(ValidationTest, ACompleteSceneIsValidWhateverItChooses) {
  const ParameterList complete =
      validated(test::scene(wall(test::word("Law", "Morse") + test::word("Obstacle", "Sphere") +
                                 test::list("Sphere", test::number("Radius", 2)))),
                scene_parameters());
  const ParameterList& list = complete.sublist("Interactions").sublist("Wall");
  EXPECT_TRUE(list.isSublist("Morse"));
  for (const char* name : {"Gamma L", "Gamma W", "Point", "Normal"}) EXPECT_FALSE(list.isParameter(name)) << name;
  EXPECT_TRUE(validated(read_scene_text(scene_text(complete), "text"), scene_parameters()) == complete);
}

TEST(SceneFileTest, ValuesAreReadStrictly) {
  for (const auto& [type, value] :
       {std::pair{"double", "abc"}, std::pair{"double", "1.5x"}, std::pair{"int", "1e-3"}, std::pair{"int", "1.5"},
        std::pair{"bool", "maybe"}, std::pair{"Array(double)", "{1, b}"}, std::pair{"Array(double)", "{1, 2"},
        std::pair{"doubel", "1"}, std::pair{"double", ""}}) {
    const std::string xml = std::string("<ParameterList><Parameter name=\"x\" type=\"") + type + "\" value=\"" + value +
                            "\"/></ParameterList>";
    EXPECT_THROW(read_scene_text(xml, "text"), InputError) << type << " " << value;
  }
}

TEST(SceneFileTest, RepeatedNamesAndStrangeElementsAreRefused) {
  EXPECT_THROW(test::scene(test::number("x", 1) + test::number("x", 2)), InputError);
  EXPECT_THROW(test::scene(test::list("x", "") + test::list("x", "")), InputError);
  EXPECT_THROW(test::scene("<Foo/>"), InputError);
  EXPECT_THROW(read_scene_text("<ParameterList>", "text"), InputError);
  EXPECT_THROW(read_scene_text("", "text"), InputError);
  EXPECT_THROW(read_scene_text("<Scene/>", "text"), InputError);
  EXPECT_THROW(test::scene("<Parameter type=\"int\" value=\"1\"/>"), InputError);
}

TEST(SceneFileTest, WhatIsWrittenReadsBackToTheLastDigit) {
  const std::string path = testing::TempDir() + "round_trip.xml";
  ParameterList scene = test::scene(
      test::list("A", test::number("third", 1.0 / 3) + test::numbers("v", {0.1, -1e-300}) + test::count("n", 7)));
  scene.set("w", "a < b & \"c\"");
  write_scene_file(scene, path);
  const ParameterList back = read_scene_file(path);
  EXPECT_EQ(back.sublist("A").get<double>("third"), 1.0 / 3);
  EXPECT_EQ(back.sublist("A").get<Teuchos::Array<double>>("v")[1], -1e-300);
  EXPECT_EQ(back.sublist("A").get<int>("n"), 7);
  EXPECT_EQ(back.get<std::string>("w"), "a < b & \"c\"");
}

TEST(SceneFileTest, AssignmentsFollowTheTypesOfTheScene) {
  ParameterList scene;
  for (const char* assignment : {"Time Integrator/Newmark/Beta=0.3", "Materials/Any Name/Density=1e-6",
                                 "Mesh/Disk/Center={1, 2}", "Output/Energies=false", "Linear Solver/Free/Form=3"})
    set_parameter(scene, scene_parameters(), assignment);
  EXPECT_EQ(scene.sublist("Time Integrator").sublist("Newmark").get<double>("Beta"), 0.3);
  EXPECT_EQ(scene.sublist("Materials").sublist("Any Name").get<double>("Density"), 1e-6);
  EXPECT_EQ(scene.sublist("Mesh").sublist("Disk").get<Teuchos::Array<double>>("Center")[1], 2);
  EXPECT_FALSE(scene.sublist("Output").get<bool>("Energies"));
  EXPECT_EQ(scene.sublist("Linear Solver").sublist("Free").get<int>("Form"), 3);
  for (const char* wrong :
       {"Time Integrator/Newmark/Bta=0.3", "Mesh=1", "NoSuchList/x=1", "Mesh/Type", "=1", "Materials/A/Density=heavy"})
    EXPECT_THROW(set_parameter(scene, scene_parameters(), wrong), InputError) << wrong;
}

TEST(SceneFileTest, AnAssignedChoiceTakesThePlaceOfAnother) {
  ParameterList scene =
      test::scene(wall(test::number("Gamma L", 2.5) + test::number("Cutoff", 2) + test::numbers("Point", {0, 1})) +
                  test::list("Mesh", test::word("Type", "Disk") + test::list("Disk", test::count("Rings", 3)) +
                                         test::list("Sets", test::list("Bottom", test::word("From", "surface")))));
  const auto assign = [&scene](const char* assignment) { set_parameter(scene, scene_parameters(), assignment); };
  assign("Interactions/Wall/Morse/Strength=0.1");
  assign("Interactions/Wall/Law=Morse");
  assign("Mesh/Type=Box");
  const ParameterList& wall = scene.sublist("Interactions").sublist("Wall");
  EXPECT_FALSE(wall.isParameter("Gamma L"));
  EXPECT_TRUE(wall.isParameter("Point")) << "another choice";
  EXPECT_TRUE(wall.isParameter("Cutoff")) << "belongs to no law";
  EXPECT_EQ(wall.sublist("Morse").get<double>("Strength"), 0.1);
  EXPECT_FALSE(scene.sublist("Mesh").isSublist("Disk"));
  EXPECT_TRUE(scene.sublist("Mesh").isSublist("Sets"));
  EXPECT_NO_THROW(validated(scene, scene_parameters()));
  // An assignment after the choice adds what the choice leaves out.
  assign("Interactions/Wall/Gamma W=20");
  EXPECT_THROW(validated(scene, scene_parameters()), InputError);
  // Lists of schemes wait for the scheme to be chosen.
  assign("Time Integrator/Newmark/Beta=0.3");
  assign("Time Integrator/Type=Bathe Composite");
  EXPECT_TRUE(scene.sublist("Time Integrator").isSublist("Newmark"));
}

}  // namespace
}  // namespace ixos
