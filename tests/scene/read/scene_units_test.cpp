#include "scene/read/scene_units.hpp"

#include <gtest/gtest.h>

#include <Teuchos_Array.hpp>
#include <cmath>

#include "base/error.hpp"
#include "parameters/parameter_entries.hpp"
#include "parameters/validation.hpp"
#include "scene/read/parameters.hpp"
#include "scene/scene_changes.hpp"
#include "scene/scene_file.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"
#include "test_folders.hpp"
#include "units/documented_unit.hpp"

namespace ixos {
namespace {

using Teuchos::ParameterList;

/// Returns the complete scene of xml/<name> with assignments.
ParameterList complete(const std::string& name, const std::vector<std::string>& assignments) {
  return complete_scene(test::scene_file(name, assignments));
}

void expect_refused(const std::string& name, const std::vector<std::string>& assignments, const std::string& words) {
  test::expect_contains(test::refusal([&] { complete(name, assignments); }), words);
}

/// Expects that every double below `valid` has brackets, "[-]" if it is a pure number, and that these hold units.
void check_documentation(const ParameterList& valid, const UnitSystem& units, int& count) {
  const bool is_table = valid.name() == "Custom" || valid.isParameter("Elastic Weights");  // coefficients of a scheme
  for (const auto& [name, entry] : entries(valid)) {
    if (entry.isList()) check_documentation(valid.sublist(name), units, count);
    if (!entry.isType<double>() && !entry.isType<Teuchos::Array<double>>()) continue;
    EXPECT_TRUE(is_table || entry.docString().find('[') != std::string::npos)
        << name << " has no unit: " << entry.docString();
    for (const DocumentedUnit& unit : documented_units(entry.docString())) {
      EXPECT_NO_THROW(units.unit(unit.expression)) << name << ": " << entry.docString();
      ++count;
    }
  }
}

TEST(SceneUnitsTest, UnitsInTheDocumentationOfAllParametersAreUnits) {
  int count = 0;
  check_documentation(scene_parameters(), scene_units({}), count);
  EXPECT_GT(count, 50);
}

TEST(SceneUnitsTest, ASceneInSIUnitsIsThatInPlainNumbersToTheBit) {
  const std::vector<std::string> si{"Mesh/Box/Lengths={0.2 um, 100 Å}",
                                    "Mesh/Box/Lower={0, 0.254709287789268} nm",
                                    "Mesh/Sets/contact/Upper={150 nm, 1 nm}",
                                    "Materials/Strip/Young's Modulus=2000 N/mm^2",
                                    "Materials/Strip/Density=1 g/cm^3",
                                    "Materials/Strip/Mass Damping=3 MHz",
                                    "Materials/Strip/Viscosity=7 ps",
                                    "Interactions/Wall/Cutoff=2.1 nm",
                                    "Histories/Pull/Rate Ramp/Rate=1 m/s",
                                    "Histories/Pull/Rate Ramp/Length=0.055 us",
                                    "Initial Conditions/Velocity={0, -3.3 mm/s}",
                                    "Boundary Conditions/Load/Type=Point Force",
                                    "Boundary Conditions/Load/Node Set=left",
                                    "Boundary Conditions/Load/Vector={0, 0.3} mN/m",
                                    "Time Integrator/Time Step Control/Final Time=160 ns",
                                    "Time Integrator/Time Step Control/Time Step=100 ps",
                                    "Time Integrator/Stop/Peeled/Probe/Limit=10 nm",
                                    "Output/Checkpoint/Wall-Clock Interval=10 min"};
  const std::vector<std::string> plain{"Mesh/Box/Lengths={200, 10}",
                                       "Mesh/Box/Lower={0, 0.254709287789268}",
                                       "Mesh/Sets/contact/Upper={150, 1}",
                                       "Materials/Strip/Young's Modulus=1",
                                       "Materials/Strip/Density=5e-7",
                                       "Materials/Strip/Mass Damping=0.003",
                                       "Materials/Strip/Viscosity=0.007",
                                       "Interactions/Wall/Cutoff=2.1",
                                       "Histories/Pull/Rate Ramp/Rate=1",
                                       "Histories/Pull/Rate Ramp/Length=55",
                                       "Initial Conditions/Velocity={0, -0.0033}",
                                       "Boundary Conditions/Load/Type=Point Force",
                                       "Boundary Conditions/Load/Node Set=left",
                                       "Boundary Conditions/Load/Vector={0, 0.00015}",
                                       "Time Integrator/Time Step Control/Final Time=160",
                                       "Time Integrator/Time Step Control/Time Step=0.1",
                                       "Time Integrator/Stop/Peeled/Probe/Limit=10",
                                       "Output/Checkpoint/Wall-Clock Interval=600"};
  const ParameterList converted = complete("strip.xml", si);
  for (const SceneChange& change : scene_changes(complete("strip.xml", plain), converted))
    ADD_FAILURE() << change.text();
  const ParameterList back = complete_scene(read_scene_text(scene_text(converted), "effective.xml"));
  EXPECT_TRUE(scene_changes(converted, back).empty());
}

TEST(SceneUnitsTest, PlainNumbersStayAsTheyAre) {
  for (const char* name :
       {"ball.xml", "strip.xml", "spatula.xml", "spatula-stiff.xml", "block-on-wall.xml", "spatula-vibration.xml"}) {
    const ParameterList scene = test::scene_file(name);
    EXPECT_TRUE(complete_scene(scene) == validated(scene, scene_parameters())) << name;
  }
}

TEST(SceneUnitsTest, UnitsOfTheSceneAreScaleFactors) {
  const std::vector<std::string> soft{"Units/Energy Density=2 MPa", "Materials/Ball/Density=1000 kg/m^3",
                                      "Materials/Ball/Young's Modulus=2 MPa"};
  const ParameterList material = complete("ball.xml", soft).sublist("Materials").sublist("Ball");
  EXPECT_EQ(material.get<double>("Density"), 5e-4);
  EXPECT_EQ(material.get<double>("Young's Modulus"), 1);
  // Plain numbers mean L0, E0, T0: whoever changes E0 alone sees what they mean now.
  const ParameterList left = complete("ball.xml", {"Units/Energy Density=2 MPa"});
  const std::string values = values_in_si(left, scene_units(left));
  test::expect_contains(values, "Materials/Ball/Density: 5e-07 E0 T0^2/L0^2 = 1 kg/m^3\n");
  test::expect_contains(values, "Materials/Ball/Young's Modulus: 1 E0 = 2 MPa\n");
  const ParameterList mistaken = complete("ball.xml", {"Materials/Ball/Density=1000"});
  test::expect_contains(values_in_si(mistaken, scene_units(mistaken)),
                        "Materials/Ball/Density: 1000 E0 T0^2/L0^2 = 2e+12 kg/m^3\n");
}

TEST(SceneUnitsTest, FilesMayHaveUnitsInStringsAndInNumbers) {
  for (const char* type : {"string", "double"}) {
    const ParameterList scene =
        test::scene("<ParameterList name=\"Materials\"><ParameterList name=\"A\"><Parameter name=\"Density\" type=\"" +
                    std::string(type) + "\" value=\"1000 kg/m^3\"/></ParameterList></ParameterList>" +
                    test::time_integrator("Newmark", 0.1, 1));
    EXPECT_EQ(complete_scene(scene).sublist("Materials").sublist("A").get<double>("Density"), 5e-7) << type;
  }
  for (const char* type : {"string", "Array(double)"}) {
    const ParameterList scene = test::scene(
        "<ParameterList name=\"Initial Conditions\"><Parameter name=\"Velocity\" type=\"" + std::string(type) +
        "\" value=\"{0, -1 m/s}\"/></ParameterList>" + test::time_integrator("Newmark", 0.1, 1));
    const auto velocity =
        complete_scene(scene).sublist("Initial Conditions").get<Teuchos::Array<double>>("Velocity").toVector();
    EXPECT_EQ(velocity, (std::vector<double>{0, -1})) << type;
  }
}

TEST(SceneUnitsTest, WrongDimensionsAreRefusedByName) {
  expect_refused("ball.xml", {"Materials/Ball/Density=1000 kg/m^2"},
                 "Materials/Ball/Density: \"1000 kg/m^2\" is a mass per area; a density is needed, as in "
                 "\"1000 kg/m^3\"");
  expect_refused("ball.xml", {"Materials/Ball/Viscosity=1 Pa s"}, "is a dynamic viscosity; a time is needed");
  expect_refused("ball.xml", {"Materials/Ball/Poisson's Ratio=0.2 m"}, "is a length; a pure number is needed");
  expect_refused("ball.xml", {"Materials/Ball/Young's Modulus=2 mpa"}, "did you mean \"MPa\"?");
  expect_refused("ball.xml", {"Mesh/Disk/Center={0, 7 ns}"}, "Mesh/Disk/Center: \"{0, 7 ns}\" is a time");
  expect_refused("ball.xml", {"Materials/Ball/Density=1e300 Tg/fm^3"}, "it is beyond the range of numbers");
  expect_refused("ball.xml", {"Units/Time=1 nm"}, "Units/Time: \"1 nm\" is a length; a time is needed");
  expect_refused("spatula.xml", {"Mesh/Spatula/Inclination=1 m"}, "an angle is needed, as in \"45 deg\"");
}

TEST(SceneUnitsTest, TheUseOfAParameterDecidesItsUnit) {
  const std::string load = "Boundary Conditions/Load/";
  const std::vector<std::string> force{load + "Type=Point Force", load + "Node Set=right"};
  const auto with = [](std::vector<std::string> settings, const std::string& more) {
    settings.push_back(more);
    return settings;
  };
  expect_refused("strip.xml", with(force, load + "Vector={0, 1 nN}"),
                 "is a force; a force per length or energy per area is needed for a Point Force in 2D");
  expect_refused("block-on-wall.xml", with(force, load + "Vector={0, 0, 1} N/m"), "a force is needed");
  expect_refused("strip.xml",
                 {"Mesh/Type=Exodus", "Mesh/Exodus/File=a.e", load + "Type=Point Force", load + "Vector={0, 1 nN}"},
                 "state it as Dimension beside File");
  expect_refused("strip.xml", {load + "Type=Gravity", load + "Vector={0, 1} N/m^3"}, "an acceleration is needed");
  expect_refused("strip.xml", {load + "Type=Traction", load + "Vector={0, 1} m/s^2"}, "a stress or energy density");
  const std::string stop = "Time Integrator/Stop/Peeled/Probe/";
  expect_refused("strip.xml", {stop + "Quantity=vy", stop + "Limit=1 nm"}, "a velocity is needed");
  // A history of a motion has lengths, one of a load has numbers; one of both can have no unit.
  const std::string pull = "Histories/Pull/";
  EXPECT_NO_THROW(complete("strip.xml", {pull + "Type=Constant", pull + "Constant/Value=1 nm"}));
  expect_refused("strip.xml", {pull + "Type=Constant", pull + "Constant/Value=1 s"}, "for a motion");
  expect_refused("strip.xml",
                 {pull + "Type=Constant", pull + "Constant/Value=1 nm", load + "Type=Traction", load + "History=Pull"},
                 "a pure number is needed for a load");
}

TEST(SceneUnitsTest, TheDimensionOfAMeshFromAFileCompletesItsUnits) {
  const std::string load = "Boundary Conditions/Load/";
  const ParameterList scene = complete(
      "strip.xml", {"Mesh/Type=Exodus", "Mesh/Exodus/File=a.e", load + "Type=Point Force", load + "Vector={0, 0.5}"});
  const auto values = [&](int dimension) { return values_in_si(scene, scene_units(scene), dimension); };
  test::expect_contains(values(2), load + "Vector: {0, 0.5} E0 L0 = {0 N/m, 1 N/m}\n");
  test::expect_contains(values(3), load + "Vector: {0, 0.5} E0 L0^2 = {0 N, 1 nN}\n");
  EXPECT_EQ(values(0).find(load + "Vector"), std::string::npos) << "nothing tells whether it is per depth";
}

TEST(SceneUnitsTest, AParameterHasTheUnitOfItsUse) {
  const std::string load = "Boundary Conditions/Load/";
  const ParameterList scene = complete("strip.xml", {load + "Type=Body Force", load + "Vector={0, 1}"});
  EXPECT_EQ(unit_of(scene, "Materials/Strip/Young's Modulus"), "E0");
  EXPECT_EQ(unit_of(scene, load + "Vector"), "E0/L0");
  EXPECT_EQ(unit_of(scene, "Materials/Strip/Poisson's Ratio"), "");
  EXPECT_EQ(unit_of(scene, "Materials/Strip/Young"), "");
}

TEST(SceneUnitsTest, TheSceneOfTheGuideIsTheBall) {
  const std::string file = std::string(IXOS_TEST_DIRECTORY) + "/guide/ball-si.xml";
  const ParameterList scene = complete_scene(read_scene_file(file)), ball = complete("ball.xml", {});
  for (const char* list : {"Mesh", "Materials"})
    EXPECT_TRUE(scene_changes(ball.sublist(list), scene.sublist(list)).empty()) << list;
  const ParameterList& wall = scene.sublist("Interactions").sublist("Wall");
  EXPECT_NEAR(wall.get<double>("Hamaker Constant"), 2 * M_PI * M_PI * 0.064 / 25, 1e-16);
  EXPECT_EQ(wall.get<double>("Length Scale"), 0.4);
  EXPECT_EQ(scene.sublist("Boundary Conditions").sublist("Weight").get<Teuchos::Array<double>>("Vector").toVector(),
            (std::vector<double>{0, -9.81e-9}));
}

}  // namespace
}  // namespace ixos
