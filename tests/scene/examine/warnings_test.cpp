#include "scene/examine/warnings.hpp"

#include <gtest/gtest.h>

#include "mesh/connected_parts.hpp"
#include "parameters/validation.hpp"
#include "scene/output/output_options.hpp"
#include "scene/read/interactions.hpp"
#include "scene/read/materials.hpp"
#include "scene/read/parameters.hpp"
#include "scene/read/scene_mesh.hpp"
#include "scene/read/time_integrator_options.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

const Scales nanometres{1e-9, 2e9, 1e-9};

/// The facts of a scene, without its model.
SceneFacts facts_of(const Teuchos::ParameterList& user, const Scales& scales = nanometres) {
  Teuchos::ParameterList list = validated(user, scene_parameters());
  const SceneNode scene(list, "");
  const OutputOptions output = read_output(scene.sublist("Output"));
  const TimeIntegratorOptions integrator = read_time_integrator(scene.sublist("Time Integrator"), output);
  const StepControlOptions& control = integrator.step_control;
  const auto materials = read_materials(scene.sublist("Materials"));
  const auto interactions = read_interactions(scene.sublist("Interactions"));
  const Mesh mesh = scene_mesh(list.sublist("Mesh"), ".");
  const Histories histories(scene.sublist("Histories"), control.initial_time, control.final_time);
  const Inertia inertia = integrator.scheme == "Static"               ? Inertia::None
                          : integrator.scheme == "Central Difference" ? Inertia::Lumped
                                                                      : Inertia::Consistent;
  const std::vector<int> parts = connected_parts(mesh);
  SceneFacts facts = scene_facts(scene, characteristic_numbers(scene, materials, interactions, mesh, parts), materials,
                                 interactions, mesh, parts, histories, control, inertia);
  facts.scales = scales;
  return facts;
}

using Assignments = std::vector<std::string>;

std::string all_of(const std::string& file, const Assignments& assignments, const Scales& scales = nanometres) {
  std::string text;
  for (const Warning& warning : scene_warnings(facts_of(test::scene_file(file, assignments), scales)))
    text += warning.name + ": " + warning.message + "\n";
  return text;
}

void expect_warning(const std::string& file, const Assignments& assignments, const std::string& name,
                    const std::string& words) {
  for (const Warning& warning : scene_warnings(facts_of(test::scene_file(file, assignments))))
    if (warning.name == name) return test::expect_contains(warning.message, words);
  ADD_FAILURE() << "no warning \"" << name << "\", but:\n" << all_of(file, assignments);
}

TEST(WarningsTest, NoSceneOfTheProjectDrawsOne) {
  for (const char* file :
       {"ball.xml", "strip.xml", "block-on-wall.xml", "spatula.xml", "spatula-stiff.xml", "spatula-vibration.xml"})
    EXPECT_EQ(all_of(file, {}), "") << file;
}

TEST(WarningsTest, StepsBeyondAThirdOfARelaxationTime) {
  const std::string branches = "Materials/Ball/Maxwell Branches/", step = "Time Integrator/Time Step Control/";
  const Assignments two{branches + "Relaxation Times={3, 0.0145}", branches + "Moduli={0.1, 0.1}",
                        "Time Integrator/Type=Average Vector Field", step + "Time Step=0.005"};
  EXPECT_EQ(all_of("ball.xml", two), "") << "Backward Euler dissipates in any step";
  Assignments second = two;
  second.push_back(branches + "History Update=Second Order");
  expect_warning(
      "ball.xml", second, "relaxation",
      "Materials/Ball: steps of up to 0.005 T0 are longer than a third of the shortest relaxation time, 0.0145 "
      "T0: with the History Update \"Second Order\" they may dissipate less than 0; use a Time Step of at most "
      "0.0048, or \"Backward Euler\"");
  second.push_back(step + "Time Step=0.004");
  EXPECT_EQ(all_of("ball.xml", second), "");
  second.push_back(step + "Type=Adaptive");
  second.push_back(step + "Adaptive/Tolerance=0.001");
  expect_warning("ball.xml", second, "relaxation", "use a Maximum Time Step of at most 0.0048");
  second.push_back(step + "Adaptive/Maximum Time Step=0.004");
  EXPECT_EQ(all_of("ball.xml", second), "");
}

TEST(WarningsTest, SoundScenesDrawNone) {
  const std::string ball = "ball.xml", strip = "strip.xml", block = "block-on-wall.xml";
  const std::string step = "Time Integrator/Time Step Control/Time Step=", type = "Time Integrator/Type=";
  const std::vector<std::pair<std::string, Assignments>> scenes = {
      {ball, {"Mesh/Disk/Diameter=20", "Mesh/Disk/Center={0, 13}", "Mesh/Disk/Core Divisions=8"}},
      {ball, {"Materials/Ball/Young's Modulus=0.5"}},
      {ball, {"Materials/Ball/Young's Modulus=50"}},
      {ball, {"Materials/Ball/Poisson's Ratio=0.45"}},
      {ball, {"Materials/Ball/Density=1e-6"}},
      {ball, {"Interactions/Wall/Gamma W=50"}},
      {ball, {"Interactions/Wall/Law=Morse", "Initial Conditions/Velocity={0, -1}"}},
      {ball, {type + "Average Vector Field", step + "0.002"}},
      {ball,
       {"Interactions/Wall/Obstacle=Sphere", "Interactions/Wall/Sphere/Radius=50",
        "Interactions/Wall/Sphere/Center={0, -50}"}},
      {ball, {"Initial Conditions/Velocity={1, -5}", "Interactions/Wall/Contact Element=Q1C2"}},
      {strip, {"Mesh/Box/Lengths={400, 10}", "Mesh/Box/Divisions={640, 16}"}},
      {strip, {"Mesh/Box/Lengths={200, 5}", "Mesh/Box/Divisions={320, 8}"}},
      {strip, {"Materials/Strip/Young's Modulus=0.5"}},
      {strip, {step + "0.5", "Mesh/Box/Divisions={160, 8}"}},
      {strip, {"Histories/Pull/Rate Ramp/Rate=5"}},
      {strip, {type + "Static", step + "1"}},
      {strip, {"Interactions/Wall/Contact Element=Q1C1"}},
      {strip, {"Interactions/Wall/Cutoff=2"}},
      {strip, {"Materials/Strip/Stiffness Damping=0.01", "Materials/Strip/Model=Saint Venant-Kirchhoff"}},
      {block, {"Mesh/Box/Divisions={16, 16, 16}"}},
      {block, {type + "Central Difference"}},
      {block, {"Materials/Rubber/Element Formulation=Mean Dilatation", "Materials/Rubber/Poisson's Ratio=0.49"}}};
  EXPECT_GE(scenes.size(), 20U);
  for (std::size_t i = 0; i < scenes.size(); ++i)
    EXPECT_EQ(all_of(scenes[i].first, scenes[i].second), "") << "scene " << i;
}

/// Silicone with tack, in micrometres, MPa and microseconds.
TEST(WarningsTest, ASoftMaterialInItsUnitsDrawsNone) {
  const Assignments silicone = {"Materials/Strip/Young's Modulus=2",    "Materials/Strip/Density=1e-3",
                                "Interactions/Wall/Law=Morse",          "Interactions/Wall/Morse/Work of Adhesion=0.05",
                                "Interactions/Wall/Morse/Strength=0.1", "Interactions/Wall/Morse/Equilibrium Gap=0.25"};
  EXPECT_EQ(all_of("strip.xml", silicone, {1e-6, 1e6, 1e-6}), "");
}

/// Silicone in millimetres, MPa and milliseconds: densities in g/mm^3, works of adhesion in N/mm.
TEST(WarningsTest, SoundScenesInMillimetresDrawNone) {
  const Scales millimetres{1e-3, 1e6, 1e-3};
  const Assignments sticky = {"Interactions/Wall/Law=Morse", "Interactions/Wall/Morse/Work of Adhesion=1e-3",
                              "Interactions/Wall/Morse/Strength=0.01", "Interactions/Wall/Morse/Equilibrium Gap=0.05"};
  const auto with = [&sticky](Assignments more) {
    more.insert(more.end(), sticky.begin(), sticky.end());
    return more;
  };
  const Assignments film = {"Materials/Strip/Young's Modulus=2",
                            "Materials/Strip/Density=1e-3",
                            "Mesh/Box/Lower={0, 0.05}",
                            "Mesh/Box/Lengths={60, 2}",
                            "Mesh/Box/Divisions={240, 8}",
                            "Output/Probes/P/Point={0, 0.05}",
                            "Output/Probes/edge/Point={60, 0.05}",
                            "Mesh/Sets/contact/Upper={45, 1}",
                            "Histories/Pull/Rate Ramp/Rate=0.1"};
  EXPECT_EQ(all_of("strip.xml", with(film), millimetres), "");
  Assignments slow = film;  // a test that takes a minute, without inertia and without a density
  slow.insert(slow.end(), {"Time Integrator/Type=Static", "Materials/Strip/Density=1"});
  EXPECT_EQ(all_of("strip.xml", with(slow), millimetres), "");
  const Assignments ball = {"Materials/Ball/Young's Modulus=2",
                            "Materials/Ball/Density=1e-3",
                            "Mesh/Disk/Center={0, 5.5}",
                            "Initial Conditions/Velocity={0, -0.5}",
                            "Mesh/Disk/Core Divisions=8",
                            "Time Integrator/Time Step Control/Final Time=20",
                            "Time Integrator/Time Step Control/Time Step=0.01"};
  EXPECT_EQ(all_of("ball.xml", with(ball), millimetres), "");
}

TEST(WarningsTest, MaterialsBeyondAllKnownOnes) {
  // 1000 E0 T0^2/L0^2 are 2e12 kg/m^3.
  expect_warning("ball.xml", {"Materials/Ball/Density=1000"}, "material",
                 "Materials/Ball: the density is 2e+12 kg/m^3, but known materials have 2 to 3e+04 kg/m^3");
  expect_warning("ball.xml", {"Materials/Ball/Young's Modulus=2e9"}, "material", "Young's modulus is 4e+18 Pa");
  expect_warning("ball.xml", {"Interactions/Wall/Gamma W=1e-6"}, "material", "Interactions/Wall: the work of adhesion");
  // Units of energy a thousand times too small, the numbers left as they were.
  EXPECT_NE(all_of("ball.xml", {}, {1e-9, 2e6, 1e-9}).find("material: Materials/Ball: the density is 1 kg/m^3"),
            std::string::npos);
}

TEST(WarningsTest, AdhesionThatCrumplesTheBody) {
  // W/E = 0.0155/1e-3, and the ball's diameter is 10.
  expect_warning("ball.xml", {"Materials/Ball/Young's Modulus=1e-3"}, "elastic length",
                 "the work of adhesion over Young's modulus is 15.5 L0, 1.5 times the body's thickness of 10 L0");
}

TEST(WarningsTest, FacesLongerThanTheCohesiveZone) {
  // 4.14 times 0.01, and faces of 0.625 with 4 intervals each
  expect_warning("strip.xml", {"Materials/Strip/Young's Modulus=0.01"}, "cohesive zone",
                 "the cohesive zone, 0.0414 L0, is shorter than the distance of the surface's nodes, 0.156 L0");
}

TEST(WarningsTest, StepsAndRunsAgainstWaves) {
  expect_warning("ball.xml", {"Materials/Ball/Density=1000"}, "wave and run",
                 "a wave needs 300 T0 to cross the body, but the run lasts 10 T0");
  expect_warning("strip.xml", {"Time Integrator/Time Step Control/Time Step=20"}, "wave and step",
                 "the time step of 20 T0 is 149 times as long as a wave needs to cross the body, 0.134 T0");
  EXPECT_EQ(all_of("strip.xml", {"Time Integrator/Type=Static", "Materials/Strip/Density=1000"}), "");
}

TEST(WarningsTest, StepsAgainstTheGap) {
  expect_warning("ball.xml", {"Time Integrator/Time Step Control/Time Step=0.02"}, "gap and step",
                 "the time step of 0.02 T0 is 6.18 times as long as the attracted body needs");
}

TEST(WarningsTest, MotionsThatJump) {
  const std::string pull = "Boundary Conditions/Pull: ";
  expect_warning("strip.xml", {"Histories/Pull/Type=Constant", "Histories/Pull/Constant/Value=2"}, "jump at the start",
                 pull + "the motion begins with a jump to 2 L0");
  expect_warning("strip.xml",
                 {"Histories/Pull/Type=Expression", "Histories/Pull/Expression/Value=40*t",
                  "Histories/Pull/Expression/Velocity=40", "Histories/Pull/Expression/Acceleration=0"},
                 "jump at the start",
                 pull + "the velocity of the motion jumps by 40 L0/T0 at t = 0 T0, 0.027 of the wave speed");
  const std::string rate = "Histories/Pull/Rate Ramp/";
  expect_warning("strip.xml", {rate + "Rate=40", rate + "Length=0.01", rate + "Start=1.05"}, "jump",
                 "jumps by 40 L0/T0 at t = 1.1 T0");
  expect_warning("strip.xml",
                 {"Histories/Pull/Type=Ramp", "Histories/Pull/Ramp/Value=3", "Histories/Pull/Ramp/Length=0.08",
                  "Histories/Pull/Ramp/Shape=Quintic"},
                 "jump", pull + "1 of the whole motion of 3 L0 happens in one step of 0.1 T0");
}

TEST(WarningsTest, ObstaclesThatJump) {
  const std::string wall = "Interactions/Wall/Motion", rate = "Histories/Pull/Rate Ramp/";
  const Assignments moved = {wall + "/Translation={-, Pull}", "Boundary Conditions/Pull/History="};
  const auto with = [&](Assignments more) {
    more.insert(more.begin(), moved.begin(), moved.end());
    return more;
  };
  expect_warning("strip.xml", with({rate + "Rate=40", rate + "Length=0.01", rate + "Start=1.05"}), "jump",
                 wall + ": the velocity of the motion jumps by 40 L0/T0 at t = 1.1 T0, 0.027 of the wave speed");
  // A wall may begin at any place and speed, as a body may that flies towards it.
  for (const Assignments& begins :
       {Assignments{"Histories/Pull/Type=Constant", "Histories/Pull/Constant/Value=-2"},
        Assignments{"Histories/Pull/Type=Expression", "Histories/Pull/Expression/Value=-40*t",
                    "Histories/Pull/Expression/Velocity=-40", "Histories/Pull/Expression/Acceleration=0"}})
    EXPECT_EQ(all_of("strip.xml", with(begins)).find("jump"), std::string::npos) << begins[1];
}

TEST(WarningsTest, FastMotionsThatBeginSmoothlyDrawNone) {
  EXPECT_EQ(all_of("strip.xml", {"Histories/Pull/Rate Ramp/Rate=100"}), "");
}

TEST(WarningsTest, ExplicitSchemesDivideTheStepOfAShortMotion) {
  const Assignments motion = {"Time Integrator/Type=Central Difference", "Histories/Pull/Type=Ramp",
                              "Histories/Pull/Ramp/Value=0.05", "Histories/Pull/Ramp/Length=0.08"};
  EXPECT_EQ(all_of("block-on-wall.xml", motion), "");
}

TEST(WarningsTest, AGuideAcrossTheNormalHoldsNoBody) {
  expect_warning("ball.xml",
                 {"Time Integrator/Time Step Control/Time Step=0.02", "Boundary Conditions/Guide/Node Set=center",
                  "Boundary Conditions/Guide/Components=x"},
                 "gap and step", "the time step of 0.02 T0 is 6.18 times as long");
  EXPECT_EQ(all_of("ball.xml",
                   {"Time Integrator/Time Step Control/Time Step=0.02", "Boundary Conditions/Guide/Node Set=center"}),
            "");
}

TEST(WarningsTest, GapsWithoutAttraction) {
  expect_warning("ball.xml", {"Mesh/Disk/Center={0, 60}"}, "no attraction", "the surface comes no nearer than 55 L0");
  expect_warning("strip.xml",
                 {"Mesh/Box/Lower={0, 5}", "Mesh/Sets/contact/Upper={150, 6}", "Interactions/Wall/Cutoff=2",
                  "Output/Probes/P/Point={0, 5}", "Output/Probes/edge/Point={200, 5}"},
                 "no attraction", "where the attraction is 0 of its largest value");
  EXPECT_EQ(all_of("ball.xml", {"Mesh/Disk/Center={0, 60}", "Initial Conditions/Velocity={0, -10}"}), "");
}

TEST(WarningsTest, AttractionWithoutRepulsion) {
  const std::string law = "Interactions/Wall/Law=";
  for (const char* name : {"Smooth Dugdale", "Triangle"})
    expect_warning("ball.xml", {law + name}, "no repulsion",
                   "the law only attracts, and no other interaction of the side set repels: nothing stops the "
                   "surface at the obstacle (largest attraction 0.062 of Young's modulus, limit 0.0001)");
  const std::string falling = "Initial Conditions/Velocity={0, -1}";
  EXPECT_EQ(all_of("ball.xml", {law + "Smooth Dugdale", falling, "Materials/Ball/Young's Modulus=1000"}), "");
  for (const char* partner : {"Penalty", "Log Barrier", "Mie"})
    EXPECT_EQ(all_of("ball.xml", {law + "Smooth Dugdale", falling, "Interactions/Stop/Side Set=surface",
                                  std::string("Interactions/Stop/Law=") + partner}),
              "")
        << partner;
}

TEST(WarningsTest, OneLayerOfCells) {
  expect_warning("strip.xml", {"Mesh/Box/Divisions={320, 1}"}, "bending",
                 "100 % of the surface (limit 50 %) has one layer of cells behind it, 10 L0 thick on a body of 200 L0");
  EXPECT_EQ(all_of("strip.xml", {"Mesh/Box/Divisions={320, 1}", "Materials/Strip/Element Formulation=Enhanced",
                                 "Interactions/Wall/Contact Element=Q1C1"}),
            "");
  for (const char* element : {"Q2C2", "Q2C4"})  // quadratic cells bend
    EXPECT_EQ(all_of("strip.xml", {"Mesh/Box/Divisions={320, 1}", "Mesh/Cell Order=2",
                                   std::string("Interactions/Wall/Contact Element=") + element}),
              "")
        << element;
}

TEST(WarningsTest, ObstaclesOfAnotherPeriod) {
  const std::string wall = "Interactions/Wall/";
  const auto with = [&](const std::string& period) {
    return Assignments{"Mesh/Periodic/Ends/Side Set=left", "Mesh/Periodic/Ends/Primary Side Set=right",
                       wall + "Obstacle=Sine Wall",        wall + "Cutoff=1",
                       wall + "Sine Wall/Amplitude=0.01",  wall + "Sine Wall/Period=" + period};
  };
  expect_warning("strip.xml", with("30"), "period",
                 "Interactions/Wall: the obstacle does not repeat with the mesh: at (");
  EXPECT_EQ(all_of("strip.xml", with("20")).find("period: "), std::string::npos);
}

bool warns_of_locking(const std::string& file, const Assignments& assignments) {
  return all_of(file, assignments).find("locking: ") != std::string::npos;
}

TEST(WarningsTest, NearlyIncompressibleStandardCells) {
  const std::string ball = "Materials/Ball/";
  expect_warning("ball.xml", {ball + "Poisson's Ratio=0.4995"}, "locking",
                 "Materials/Ball: Poisson's ratio is 0.4995 (limit 0.45) and the cells are \"Standard\", which lock");
  for (const char* ratio : {"0.499", "0.49"})
    EXPECT_TRUE(warns_of_locking("ball.xml", {ball + "Poisson's Ratio=" + ratio})) << ratio;
  // The mode's (1 - nu)^2/(1 - 2 nu) + (1 - nu)/2 = 13.26, and 1 + 12.26/16^2
  expect_warning("block-on-wall.xml", {"Materials/Rubber/Poisson's Ratio=0.49", "Mesh/Box/Divisions={16, 16, 16}"},
                 "locking",
                 "one of them is 13.3 times as stiff in bending as the material, 16 layers of them may be 1.05");
  expect_warning("strip.xml", {"Materials/Strip/Poisson's Ratio=0.49"}, "locking", "use the Element Formulation");
  for (const char* remedy : {"Materials/Ball/Element Formulation=Mean Dilatation",
                             "Materials/Ball/Element Formulation=Enhanced", "Mesh/Cell Order=2"})
    EXPECT_FALSE(warns_of_locking("ball.xml", {ball + "Poisson's Ratio=0.4995", remedy})) << remedy;
  EXPECT_FALSE(warns_of_locking("ball.xml", {ball + "Poisson's Ratio=0.45"}));
}

TEST(WarningsTest, FewLayersOfLongCells) {
  // Cells of 10 by 5: 0.8^2/0.6 + 0.4 2^2 = 2.67, and 1 + 1.67/4
  const std::string divisions = "Mesh/Box/Divisions=";
  expect_warning(
      "strip.xml", {divisions + "{20, 2}"}, "locking",
      "2 layer(s) of linear cells, 2 times as long as thick, are 1.42 times as stiff in bending as the material "
      "(limit 1.3): one cell locks by 2.67");
  EXPECT_TRUE(warns_of_locking("strip.xml", {divisions + "{10, 3}"}));
  // 0.4 (1 + 4^2) = 6.8, and 1 + 5.8/4
  EXPECT_TRUE(
      warns_of_locking("strip.xml", {divisions + "{10, 2}", "Materials/Strip/Element Formulation=Mean Dilatation"}));
  EXPECT_FALSE(warns_of_locking("strip.xml", {divisions + "{40, 2}"}));
  EXPECT_FALSE(warns_of_locking("strip.xml", {divisions + "{20, 4}", "Materials/Strip/Element Formulation=Enhanced",
                                              "Interactions/Wall/Contact Element=Q1C1"}));
  EXPECT_FALSE(warns_of_locking("strip.xml", {divisions + "{20, 1}"})) << "that is \"bending\"";
  EXPECT_FALSE(warns_of_locking("strip.xml", {"Mesh/Box/Lengths={20, 10}", divisions + "{4, 2}"})) << "compact";
}

TEST(WarningsTest, TheCellsOfTheProjectsScenesDoNotLock) {
  for (const char* file :
       {"ball.xml", "strip.xml", "block-on-wall.xml", "crossed-cylinders.xml", "film-peel.xml", "gecko-drag.xml",
        "hairpin.xml", "hertz.xml", "jkr.xml", "pillar.xml", "rate-peel.xml", "restitution.xml", "spatula.xml",
        "spatula-stiff.xml", "spatula-vibration.xml", "spring-block.xml", "stamp.xml", "t-peel.xml", "waviness.xml"})
    EXPECT_FALSE(warns_of_locking(file, {})) << file;
}

/// 16 sides of 1.95 L0 on each disk.
TEST(WarningsTest, PointsThatDoNotResolveTheGap) {
  const std::string pair = "Interactions/Contact/";
  expect_warning("two-balls.xml", {pair + "Passes=Double Integral"}, "double integral",
                 "0.39 L0 apart or more on half of the faces, but must be closer than a third of the equilibrium gap, "
                 "0.0849 L0, where the surfaces touch; use 23 Surface Points");
  for (const Assignments& sound :
       {Assignments{pair + "Passes=Double Integral", pair + "Surface Points=23"}, Assignments{pair + "Passes=Two"}})
    EXPECT_EQ(all_of("two-balls.xml", sound).find("double integral"), std::string::npos);
  EXPECT_EQ(all_of("ball.xml", {"Interactions/Wall/Passes=Double Integral"}), all_of("ball.xml", {}));  // an obstacle
  // The left disk, the primary body, has 8 sides of 3.9 L0; the right one alone would be fine.
  const Assignments coarse{pair + "Passes=Double Integral", pair + "Surface Points=30",
                           "Mesh/Parts/left/Disk/Core Divisions=2"};
  expect_warning("two-balls.xml", coarse, "double integral", "use 46 Surface Points");
  expect_warning("two-balls.xml", {coarse[0], "Interactions/Contact/Gamma L=25"}, "double integral",
                 "use faces of at most 0.54 L0");
}

/// Twelve edges in the middles of those of the cube meet at 33.2 degrees on balls of 54 faces, none at more than 30 on
/// balls of 96.
TEST(WarningsTest, ASplineOverFacesThatAreTooLarge) {
  const std::string left = "Mesh/Parts/left/Ball/Core Divisions=", right = "Mesh/Parts/right/Ball/Core Divisions=";
  const std::string spline = "Interactions/Contact/Smoothing=Spline";
  for (const auto& [coarse, set] : {std::pair{left, "left_surface"}, std::pair{right, "right_surface"}})
    expect_warning(
        "two-spheres.xml", {left + "4", right + "4", coarse + "3", spline}, "coarse spline",
        std::string("12 edges of the surface \"") + set + "\" end inside it, but their faces meet at up to 33.2");
  for (const Assignments& sound : {Assignments{left + "4", right + "4", spline}, Assignments{left + "3", right + "3"}})
    EXPECT_EQ(all_of("two-spheres.xml", sound).find("coarse spline"), std::string::npos);
}

/// A traction on the block's upper side.
Assignments pressed(const std::string& vector) {
  const std::string press = "Boundary Conditions/Press/";
  return {press + "Type=Traction", press + "Side Set=top", press + "Vector=" + vector};
}

TEST(WarningsTest, AnObliquePullWithoutFriction) {
  expect_warning("strip.xml", {"Boundary Conditions/Guide/History=Pull"}, "no friction",
                 "acts at 45 degrees to the obstacle (limit 84), but there is no friction");
  expect_warning("ball.xml",
                 {"Boundary Conditions/Wind/Type=Body Force", "Boundary Conditions/Wind/Vector={1e-5, 1e-5}"},
                 "no friction", "Boundary Conditions/Wind acts at 45 degrees");
  expect_warning("block-on-wall.xml", pressed("{1, 0, -1}"), "no friction",
                 "Boundary Conditions/Press acts at 45 degrees");
}

TEST(WarningsTest, FrictionWithTheThresholdOfOneOfSeveralLaws) {
  const std::string second = "Interactions/Second/", friction = "Interactions/Wall/Friction/";
  const auto laws = [&](const std::string& type, const std::string& parameter, const std::string& place) {
    return Assignments{friction + "Type=" + type, friction + parameter + "=0.5", second + "Side Set=surface",
                       second + "Law=Penalty", second + "Point=" + place};
  };
  const std::string here = "{0, 0}";
  expect_warning("ball.xml", laws("Extended Amontons", "Coefficient", here), "friction of one law",
                 "Interactions/Wall: the threshold of the friction follows the law of this list alone, and \"Second\"");
  for (const Assignments& sound :
       {laws("Extended Amontons", "Coefficient", "{0, -1}"), laws("Constant Stress", "Stress", here)})
    EXPECT_EQ(all_of("ball.xml", sound).find("friction of one law"), std::string::npos);
}

// Where the obstacle will be, the warning does not tell.
TEST(WarningsTest, AMovedObstacleIsNotJudgedByItsStart) {
  const Assignments pulled{"Boundary Conditions/Guide/History=Pull"};
  Assignments moved = pulled;
  moved.emplace_back("Interactions/Wall/Motion/Translation={-, Pull}");
  EXPECT_NE(all_of("strip.xml", pulled).find("no friction"), std::string::npos);
  EXPECT_EQ(all_of("strip.xml", moved).find("no friction"), std::string::npos);
}

TEST(WarningsTest, PushesAndHeldBodiesDrawNone) {
  EXPECT_EQ(all_of("block-on-wall.xml", pressed("{0.01, 0, -1}")), "");
  EXPECT_EQ(all_of("block-on-wall.xml", pressed("{1e-17, 0, -1}")), "");
  // A film that is clamped at its left end and pulled up along 45 degrees at its right one.
  EXPECT_EQ(all_of("strip.xml", {"Boundary Conditions/Guide/History=Pull", "Boundary Conditions/Clamp/Node Set=left",
                                 "Boundary Conditions/Clamp/Components=x"}),
            "");
}

}  // namespace
}  // namespace ixos
