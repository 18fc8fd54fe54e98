#include "scene/examine/supports.hpp"

#include <gtest/gtest.h>

#include "scene/simulation.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::count;
using test::counts;
using test::list;
using test::number;
using test::numbers;
using test::word;

const std::string plate =
    list("Mesh", word("Type", "Box") + list("Box", numbers("Lengths", {4, 2}) + counts("Divisions", {4, 2})));
const std::string material = list("Materials", list("Rubber", ""));

std::string held(const std::string& name, const std::string& set, const std::string& components) {
  return list(name, word("Node Set", set) + word("Components", components));
}

/// Returns the warnings of missing supports, a line each.
std::string of(const std::string& scene, const std::string& scheme = "Static") {
  std::string text;
  const Simulation simulation(test::scene(scene + test::time_integrator(scheme, 0.1, 1)), test::self());
  for (const Warning& warning : simulation.warnings())
    if (warning.name == support_warning) text += warning.message + "\n";
  return text;
}
std::string of_plate(const std::string& conditions, const std::string& more = "") {
  return of(plate + material + list("Boundary Conditions", conditions) + more);
}

TEST(SupportsTest, EachRigidMotionThatNothingHoldsIsNamed) {
  EXPECT_EQ(of_plate(held("A", "left", "all")), "");
  EXPECT_EQ(of_plate(held("A", "left", "x") + held("B", "bottom", "y")), "");
  test::expect_contains(of_plate(""),
                        "nothing holds any translation and the rotation of the body \"body\" around (2, 1)");
  test::expect_contains(of_plate(held("A", "bottom", "y")), "nothing holds the translation along (1, 0) of the body");
  test::expect_contains(of_plate(held("A", "left", "x")), "nothing holds the translation along (0, 1) of the body");
  test::expect_contains(of_plate(held("A", "left", "x")), "Static needs supports");
  EXPECT_EQ(of(plate + material, "Newmark"), "") << "inertia holds it";
}

TEST(SupportsTest, WallsHoldTheirNormalsAndFrictionHoldsAll) {
  const auto wall = [](const std::string& more) {
    return list("Interactions", list("Wall", word("Side Set", "bottom") + numbers("Point", {0, -0.25}) + more));
  };
  test::expect_contains(of_plate("", wall("")), "nothing holds the translation along (1, 0) of the body");
  EXPECT_EQ(of_plate(held("A", "left", "x"), wall("")), "");
  EXPECT_EQ(of_plate("", wall(list("Friction", word("Type", "Constant Stress") + number("Stress", 0.01)))), "");
}

TEST(SupportsTest, GripsHoldWhatTheyAreStiffIn) {
  const auto grip = [](const std::string& type, const std::vector<double>& stiffness) {
    return list("Grips", list("G", word("Type", type) + word("Node Set", "right") +
                                       (stiffness.empty() ? "" : numbers("Stiffness", stiffness))));
  };
  EXPECT_EQ(of_plate("", grip("Rigid", {})), "");
  EXPECT_EQ(of_plate("", grip("Springs", {1, 1})), "");
  test::expect_contains(of_plate("", grip("Springs", {1, 0})),
                        "nothing holds the translation along (0, 1) of the body");
}

TEST(SupportsTest, ABodyOfRevolutionNeedsOneSupport) {
  const std::string disk = list("Mesh", word("Type", "Box") + word("Geometry", "Axisymmetric") +
                                            list("Box", numbers("Lengths", {4, 2}) + counts("Divisions", {4, 2})));
  test::expect_contains(of(disk + material + list("Boundary Conditions", held("A", "right", "x"))),
                        "nothing holds the translation along the axis of the body");
  EXPECT_EQ(of(disk + material + list("Boundary Conditions", held("A", "top", "y"))), "");
}

TEST(SupportsTest, InSpaceAPlaneOfSymmetryLeavesThreeMotions) {
  const std::string brick = list(
      "Mesh", word("Type", "Box") +
                  list("Box", count("Dimension", 3) + numbers("Lengths", {1, 1, 1}) + counts("Divisions", {2, 2, 2})));
  const std::string bottom = held("Z", "bottom", "z"), left = held("X", "left", "x"), front = held("Y", "front", "y");
  const auto of_brick = [&](const std::string& conditions) {
    return of(brick + material + list("Boundary Conditions", conditions));
  };
  EXPECT_EQ(of_brick(bottom + left + front), "");
  test::expect_contains(of_brick(bottom + left), "nothing holds the translation along (0, 1, 0) of the body");
  test::expect_contains(of_brick(bottom),
                        "nothing holds translations normal to (0, 0, 1) and the rotation about the axis");
}

/// Two plates, one above the other, that interact.
std::string two_plates(const std::string& conditions) {
  const std::string box = word("Type", "Box") + list("Box", numbers("Lengths", {4, 2}) + counts("Divisions", {4, 2}));
  const std::string parts = list("Parts", list("lower", box) + list("upper", box + numbers("Translation", {0, 2.25})));
  return list("Mesh", word("Type", "Parts") + parts) +
         list("Materials", list("A", word("Block", "lower_body")) + list("B", word("Block", "upper_body"))) +
         list("Interactions", list("Bond", word("Side Set", "lower_top") + word("Primary Side Set", "upper_bottom"))) +
         list("Boundary Conditions", conditions);
}

TEST(SupportsTest, TwoBodiesHoldEachOtherAlongTheirNormals) {
  const std::string lower = held("A", "lower_bottom", "all"), upper = held("B", "upper_left", "x");
  EXPECT_EQ(of(two_plates(lower + upper)), "");
  // The upper one slides on the lower one.
  const std::string sliding = of(two_plates(lower));
  test::expect_contains(sliding,
                        "nothing holds the translation along (1, 0) of the body \"upper_body\" around (2, 3.25)");
  EXPECT_EQ(sliding.find("lower_body"), std::string::npos) << sliding;
  // Both fall together.
  test::expect_contains(
      of(two_plates(held("A", "lower_left", "x") + upper)),
      "nothing holds the translation along (0, 1) of the bodies \"lower_body\", \"upper_body\" around "
      "(2, 2.125), which move as one");
}

}  // namespace
}  // namespace ixos
