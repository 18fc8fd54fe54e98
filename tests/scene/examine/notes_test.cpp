#include "scene/examine/notes.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "scene/explain/explanation.hpp"
#include "scene/simulation.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::counts;
using test::list;
using test::number;
using test::numbers;
using test::word;

using Lines = std::vector<std::string>;

Lines notes(const std::string& lists) { return Simulation(test::scene(lists), test::self()).hints(); }

std::string body(double height, const std::vector<double>& lengths, const std::string& map = "",
                 const std::string& material = number("Poisson's Ratio", 0.4)) {
  return list("Mesh", word("Type", "Box") +
                          list("Box", numbers("Lower", {0, height}) + numbers("Lengths", lengths) +
                                          counts("Divisions", {8, 4})) +
                          (map.empty() ? "" : list("Map", word("Y", map)))) +
         list("Materials", list("Rubber", material));
}
std::string wall(const std::string& more = "") {
  return list("Interactions", list("Wall", word("Side Set", "bottom") + more));
}
std::string pulled(const std::string& components = "y") {
  return list("Histories",
              list("Pull", word("Type", "Rate Ramp") + list("Rate Ramp", number("Rate", 0.1) + number("Length", 1)))) +
         list("Boundary Conditions",
              list("Pull", word("Node Set", "top") + word("Components", components) + word("History", "Pull")));
}
std::string held(const std::string& set, const std::string& components) {
  return list("Boundary Conditions", list("Hold", word("Node Set", set) + word("Components", components)));
}
const std::string slow = test::time_integrator("Static", 0.1, 5);
const std::string moving = test::time_integrator("Average Vector Field", 0.01, 2);
constexpr double equilibrium = 0.254709287789268;

TEST(NotesTest, ABondThatBeginsOutOfRangeNeverForms) {
  const auto glue = [](bool on_touch) {
    return word("Law", "Bilinear Damage") +
           list("Bilinear Damage",
                number("Work of Adhesion", 0.02) + number("Strength", 0.05) + number("Stiffness", 0.5) +
                    (on_touch ? R"(<Parameter name="Bond on Touch" type="bool" value="true"/>)" : ""));
  };
  const std::string falls = list("Initial Conditions", numbers("Velocity", {0, -1})) + moving;
  const Simulation far(test::scene(body(1, {4, 2}) + wall(glue(false)) + falls), test::self());
  const auto bonds = [](const Simulation& s) {
    Lines found;
    for (const Warning& warning : s.warnings())
      if (warning.name == "bond") found.push_back(warning.message);
    return found;
  };
  EXPECT_EQ(bonds(far),
            Lines{"Interactions/Wall: the surface begins at a gap of 1 L0, beyond the range of its law, 0.8 L0: a bond "
                  "that begins out of range never forms, and the surface only repels; set Bond on Touch, or let the "
                  "surface begin at the obstacle"});
  const std::string text = explain(far);
  EXPECT_EQ(text.find("work of adhesion W"), std::string::npos) << text;
  test::expect_contains(text, "Wall: never bonds, so it has no work of adhesion");
  const Simulation touches(test::scene(body(1, {4, 2}) + wall(glue(true)) + falls), test::self());
  EXPECT_EQ(bonds(touches), Lines());
  test::expect_contains(explain(touches), "work of adhesion W 0.02 E0 L0");
  EXPECT_EQ(bonds(Simulation(test::scene(body(0, {4, 2}) + wall(glue(false)) + falls), test::self())), Lines());
  // A wall that starts where it stands forms no bond either; one that starts at the surface may.
  const auto moved = [&](double start) {
    const std::string up = list(
        "Histories", list("Up", word("Type", "Sine") + list("Sine", number("Offset", start) + number("Amplitude", 0.1) +
                                                                        number("Frequency", 1))));
    return bonds(
        Simulation(test::scene(body(1, {4, 2}) +
                               wall(glue(false) + list("Motion", test::texts("Translation", "{-, Up}"))) + up + falls),
                   test::self()));
  };
  EXPECT_EQ(moved(0).size(), 1U);
  EXPECT_EQ(moved(1), Lines());
}

TEST(NotesTest, AFootThatIsPulledStraightSlides) {
  const auto foot = [](const std::string& mesh, const std::string& interaction, const std::string& pull) {
    return notes(mesh + interaction + pull + slow);
  };
  const std::string block = body(equilibrium, {4, 4});
  const Lines found = foot(block, wall(), pulled());
  ASSERT_EQ(found.size(), 1U);
  test::expect_contains(found[0], "Interactions/Wall: Boundary Conditions/Pull pulls the foot off without friction");
  test::expect_contains(found[0], "give the interaction a Friction");
  const std::string friction = list("Friction", word("Type", "Constant Stress") + number("Stress", 0.05));
  EXPECT_EQ(foot(block, wall(friction), pulled()), Lines());
  EXPECT_EQ(foot(block, wall(word("Law", "Penalty")), pulled()), Lines()) << "nothing pulls it back";
  EXPECT_EQ(foot(block, wall(), held("top", "y")), Lines());
  EXPECT_EQ(foot(body(equilibrium, {40, 4}), wall(), pulled()), Lines()) << "a film";
  EXPECT_EQ(foot(body(equilibrium, {4, 4}, "", number("Poisson's Ratio", 0.0)), wall(), pulled()), Lines());
  EXPECT_EQ(
      foot(block, wall(word("Obstacle", "Sphere") + list("Sphere", number("Radius", 20) + numbers("Center", {0, -20}))),
           pulled()),
      Lines())
      << "curved";
}

TEST(NotesTest, AStartFarFromEquilibriumTellsTheShift) {
  const auto start = [](double height) { return notes(body(height, {8, 4}) + wall() + held("top", "xy") + slow); };
  const Lines far = start(2);
  ASSERT_EQ(far.size(), 1U);
  test::expect_contains(far[0], "Interactions/Wall: the surface begins at a least gap of 2 L0, beyond its largest");
  test::expect_contains(far[0], fmt::format("shift the mesh by (0, {:.6g}) L0", equilibrium - 2));
  const Lines pressed = start(0.15);
  ASSERT_EQ(pressed.size(), 1U);
  test::expect_contains(pressed[0], "where it is repelled more than it ever is attracted");
  test::expect_contains(pressed[0], fmt::format("shift the mesh by (0, {:.6g}) L0", equilibrium - 0.15));
  EXPECT_EQ(start(equilibrium), Lines());
  // The shift is along the obstacle's normal, whatever that is.
  const Lines oblique = notes(body(0, {8, 4}) + wall(numbers("Normal", {0.6, 0.8}) + numbers("Point", {-0.6, -0.8})) +
                              held("top", "xy") + slow);
  ASSERT_EQ(oblique.size(), 1U);
  test::expect_contains(oblique[0], fmt::format("shift the mesh by ({:.6g}, {:.6g}) L0", 0.6 * (equilibrium - 1),
                                                0.8 * (equilibrium - 1)));
}

TEST(NotesTest, BodiesOnTheirWayBeginFarOnPurpose) {
  EXPECT_EQ(notes(body(2, {8, 4}) + wall() + list("Initial Conditions", numbers("Velocity", {0, -1})) + moving),
            Lines());
  EXPECT_EQ(notes(body(0.6, {8, 4}) + wall() + moving), Lines()) << "attraction moves it";
  const std::string down =
      list("Histories", list("Down", word("Type", "Ramp") + list("Ramp", number("Value", -1) + number("Length", 5))));
  EXPECT_EQ(notes(body(2, {8, 4}) + wall() + down +
                  list("Boundary Conditions",
                       list("Down", word("Node Set", "top") + word("History", "Down") + word("Components", "y"))) +
                  slow),
            Lines());
}

TEST(NotesTest, AHalfWithoutItsConditionOfSymmetry) {
  const std::string round = body(equilibrium, {8, 4}, "y + x^2/60");
  const auto half = [&](const std::string& conditions, const std::string& interactions = wall()) {
    return notes(round + interactions + conditions + moving);
  };
  const Lines found = half("");
  ASSERT_EQ(found.size(), 1U);
  test::expect_contains(found[0], "Interactions/Wall: the surface meets the plane x = 0 at a right angle");
  test::expect_contains(found[0], "hold the nodes of the plane by a Displacement of the Components x");
  EXPECT_EQ(half(held("left", "x")), Lines());
  EXPECT_EQ(half(list("Grips", list("Holder", word("Node Set", "left")))), Lines());
  EXPECT_EQ(half(list("Boundary Conditions", list("Press", word("Type", "Traction") + word("Side Set", "left") +
                                                               numbers("Vector", {0.001, 0})))),
            Lines());
  const std::string guide = list("Left", word("Side Set", "left") + word("Law", "Penalty") + numbers("Normal", {1, 0}) +
                                             numbers("Point", {-1, 0}));
  EXPECT_EQ(half("", list("Interactions", list("Wall", word("Side Set", "bottom")) + guide)), Lines());
  // Displacements along the plane, or of few of its nodes, do not hold it.
  EXPECT_EQ(half(held("left", "y")).size(), 1U);
  EXPECT_EQ(half(held("top", "x")).size(), 1U);
}

TEST(NotesTest, WholeBodiesAndScenesOfTheProjectDrawNone) {
  EXPECT_EQ(notes(body(equilibrium, {8, 4}) + wall() + moving), Lines()) << "a box with free ends";
  EXPECT_EQ(notes(body(equilibrium, {8, 4}, "y + (x - 4)^2/60") + wall() + moving), Lines()) << "a whole bowl";
  EXPECT_EQ(notes(list("Mesh", word("Type", "Box") + word("Geometry", "Axisymmetric") +
                                   list("Box", numbers("Lower", {0, equilibrium}) + numbers("Lengths", {8, 4}) +
                                                   counts("Divisions", {8, 4})) +
                                   list("Map", word("Y", "y + x^2/60"))) +
                  list("Materials", list("Rubber", "")) + wall() + moving),
            Lines())
      << "its axis";
  for (const char* file : {"ball.xml", "strip.xml", "film-peel.xml", "gecko-drag.xml", "hertz.xml", "jkr.xml",
                           "afm.xml", "restitution.xml", "two-balls.xml"})
    EXPECT_EQ(Simulation(test::scene_file(file), test::self()).hints(), Lines()) << file;
}

}  // namespace
}  // namespace ixos
