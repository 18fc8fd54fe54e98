#include "scene/read/driving.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "mesh/connected_parts.hpp"
#include "parameters/validation.hpp"
#include "scene/read/parameters.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::list;
using test::number;
using test::numbers;
using test::word;

constexpr std::array<double, 3> up{0, 1, 0};

/// Two squares, one beside the other: nodes 0 to 3 and 4 to 7.
Mesh squares() {
  Mesh mesh;
  mesh.coordinates = {0, 0, 1, 0, 1, 1, 0, 1, 3, 0, 4, 0, 4, 1, 3, 1};
  mesh.blocks = {{"first", CellType::Quad4, {0, 1, 2, 3}}, {"second", CellType::Quad4, {4, 5, 6, 7}}};
  mesh.side_sets = {{"top", {{1, 0, 2}}}};
  mesh.node_sets = {{"left", {0, 3}}, {"right", {5, 6}}};
  return mesh;
}

Driving driving(const std::string& conditions, const std::string& histories = "", const GivenHistories& given = {},
                bool axisymmetric = false, const std::string& initial = "") {
  const Teuchos::ParameterList scene =
      validated(test::scene(list("Materials", list("Rubber", number("Density", 1))) +
                            list("Boundary Conditions", conditions) + list("Histories", histories) +
                            list("Initial Conditions", initial) + test::time_integrator("Newmark", 0.1, 10)),
                scene_parameters());
  const SceneNode node(scene, "");
  StepControlOptions control;
  control.final_time = 10;
  control.time_step = 0.1;
  Mesh mesh = squares();
  mesh.axisymmetric = axisymmetric;
  return Driving(node, Histories(node.sublist("Histories"), 0, 10, given), control, mesh, connected_parts(mesh));
}

std::string condition(const std::string& name, const std::string& set, const std::string& components,
                      const std::string& history = "") {
  return list(
      name, word("Node Set", set) + word("Components", components) + (history.empty() ? "" : word("History", history)));
}

std::string ramp(const std::string& name, double rate) {
  return list(name, word("Type", "Rate Ramp") + list("Rate Ramp", number("Rate", rate) + number("Length", 2)));
}

TEST(DrivingTest, AMotionConcernsItsOwnBodyOnly) {
  const Driving both = driving(condition("Pull", "right", "y", "Up"), ramp("Up", 3));
  EXPECT_TRUE(both.of_part(0, up).pulls.empty());
  EXPECT_FALSE(both.of_part(0, up).held);
  const Drive second = both.of_part(4, up);
  EXPECT_TRUE(second.held);
  ASSERT_EQ(second.pulls.size(), 1U);
  EXPECT_NEAR(second.pulls[0].away, 3 * (10 - 1), 1e-12);
  EXPECT_EQ(second.pulls[0].along, 0);
  EXPECT_EQ(second.approach, 0);
  EXPECT_NEAR(both.of_part(4, {0, -1, 0}).approach, 27, 1e-12);
}

TEST(DrivingTest, EachBodyStartsWithTheVelocityOfItsBlocks) {
  const auto down = list("Down", test::texts("Blocks", "{second}") + numbers("Velocity", {0, -2}));
  const Driving both = driving("", "", {}, false, numbers("Velocity", {0, -0.5}) + down);
  EXPECT_NEAR(both.of_part(0, up).approach, 5, 1e-12);
  EXPECT_NEAR(both.of_part(4, up).approach, 20, 1e-12);
  EXPECT_FALSE(both.moves());
  EXPECT_TRUE(
      driving("", "", {}, false, list("Spin", test::texts("Blocks", "{second}") + numbers("Angular Velocity", {1})))
          .moves());
}

TEST(DrivingTest, LoadsActOnTheBodiesOfTheirSets) {
  const auto load = [](const std::string& type, const std::string& place) {
    return list("Load", word("Type", type) + numbers("Vector", {3, -4}) + place);
  };
  for (const auto& [conditions, first, second] :
       {std::tuple{load("Body Force", ""), 1U, 1U}, std::tuple{load("Body Force", word("Block", "second")), 0U, 1U},
        std::tuple{load("Traction", word("Side Set", "top")), 0U, 1U},
        std::tuple{load("Point Force", word("Node Set", "left")), 1U, 0U}}) {
    const Driving loaded = driving(conditions);
    EXPECT_TRUE(loaded.has_loads());
    EXPECT_EQ(loaded.of_part(0, up).pulls.size(), first) << conditions;
    EXPECT_EQ(loaded.of_part(4, up).pulls.size(), second) << conditions;
  }
  const Pull pull = driving(load("Body Force", "")).of_part(0, up).pulls.at(0);
  EXPECT_EQ(pull.away, 0);
  EXPECT_EQ(pull.towards, 4);
  EXPECT_EQ(pull.along, 3);
}

TEST(DrivingTest, ABodySlidesOnlyWhereItIsNotHeld) {
  const std::string wind = list("Wind", word("Type", "Body Force") + numbers("Vector", {3, 4}));
  const auto along = [&](const std::string& more, const std::array<double, 3>& normal) {
    return driving(wind + more).of_part(0, normal).pulls.at(0).along;
  };
  EXPECT_NEAR(along("", up), 3, 1e-15);
  EXPECT_EQ(along(condition("Guide", "left", "x"), up), 0);
  EXPECT_NEAR(along(condition("Guide", "right", "x"), up), 3, 1e-15) << "the other body";
  EXPECT_NEAR(along(condition("Guide", "left", "y"), up), 3, 1e-15);
  // Before an inclined wall, a body that is held in x moves in y only, which changes the gap.
  const std::array<double, 3> inclined{0.6, 0.8, 0};
  EXPECT_NEAR(along("", inclined), std::abs(-3 * 0.8 + 4 * 0.6), 1e-12);
  EXPECT_NEAR(along(condition("Guide", "left", "x"), inclined), 0, 1e-12);
  EXPECT_EQ(along(condition("Guide", "left", "all"), inclined), 0);
}

TEST(DrivingTest, ABodyOfRevolutionDoesNotSlideOffItsAxis) {
  const std::string load = list("Squeeze", word("Type", "Body Force") + numbers("Vector", {3, 4}));
  EXPECT_EQ(driving(load, "", {}, true).of_part(0, up).pulls.at(0).along, 0);
  EXPECT_EQ(driving(load, "", {}, true).of_part(4, up).pulls.at(0).towards, 0);
  EXPECT_EQ(driving(load, "", {}, true).of_part(4, up).pulls.at(0).away, 4);
  // Before a coaxial cylinder it can move along the axis.
  EXPECT_EQ(driving(load, "", {}, true).of_part(0, {1, 0, 0}).pulls.at(0).along, 4);
}

TEST(DrivingTest, ASymmetryHoldsNoBodyAlongTheNormal) {
  EXPECT_FALSE(driving(condition("Symmetry", "left", "x")).of_part(0, up).held);
  EXPECT_TRUE(driving(condition("Symmetry", "left", "x")).of_part(0, {1, 0, 0}).held);
  EXPECT_TRUE(driving(condition("Clamp", "left", "all")).of_part(0, up).held);
}

TEST(DrivingTest, WhatTheProgramGivesIsUnforeseen) {
  const std::string load =
      list("Load", word("Type", "Body Force") + numbers("Vector", {3, -4}) + word("History", "Up"));
  const GivenHistories given{{"Up", constant(1)}};
  const Driving motion = driving(condition("Pull", "right", "y", "Up"), ramp("Up", 3), given);
  EXPECT_TRUE(motion.moves());
  EXPECT_TRUE(motion.motions().empty()) << "the list's history was taken instead";
  EXPECT_TRUE(motion.of_part(4, up).held);
  EXPECT_EQ(motion.of_part(4, up).pulls.size(), 0U);
  const Driving loaded = driving(load, "", given);
  EXPECT_TRUE(loaded.has_loads());
  EXPECT_FALSE(loaded.moves());
  EXPECT_EQ(loaded.of_part(0, up).pulls.at(0).towards, 0) << "of unknown size";
}

TEST(DrivingTest, VelocitiesThatJumpLater) {
  const auto motion = [](const std::string& history) {
    return driving(condition("Pull", "right", "y", "Up"), list("Up", history)).motions().at(0);
  };
  const Motion smooth = motion(word("Type", "Rate Ramp") + list("Rate Ramp", number("Rate", 3) + number("Length", 5)));
  // The trapezoidal rule's error for the cosine's acceleration in a step h: h^3/12 of its second derivative.
  EXPECT_LT(smooth.velocity_jump, 3 * std::pow(M_PI / 5, 3) / 2 * 1e-3 / 12 * 1.01);
  const Motion sudden = motion(word("Type", "Rate Ramp") +
                               list("Rate Ramp", number("Rate", 3) + number("Length", 0.01) + number("Start", 1.52)));
  EXPECT_NEAR(sudden.velocity_jump, 3, 1e-12);
  EXPECT_NEAR(sudden.jump_time, 1.6, 1e-12);
}

TEST(DrivingTest, AnObstacleMayBeginAnywhereButNotJumpLater) {
  const Teuchos::ParameterList scene = validated(
      test::scene(list("Materials", list("Rubber", "")) +
                  list("Histories", test::expression("Fly", "2+5*t", "5", "0") +
                                        list("Hit", word("Type", "Rate Ramp") +
                                                        list("Rate Ramp", number("Rate", 3) + number("Length", 0.01) +
                                                                              number("Start", 1.52)))) +
                  test::time_integrator("Newmark", 0.1, 10)),
      scene_parameters());
  const SceneNode node(scene, "");
  StepControlOptions control;
  control.final_time = 10;
  control.time_step = 0.1;
  const Mesh mesh = squares();
  const Histories histories(node.sublist("Histories"), 0, 10);
  Driving driving(node, histories, control, mesh, connected_parts(mesh));
  MotionOptions obstacle;
  obstacle.translation = {"Fly", "Hit"};
  driving.add_obstacle(node, obstacle, histories);
  ASSERT_EQ(driving.motions().size(), 2U);
  EXPECT_EQ(driving.motions()[0].start, 0);
  EXPECT_NEAR(driving.motions()[0].velocity_jump, 0, 1e-12);
  EXPECT_NEAR(driving.motions()[0].range, 50, 1e-12);
  EXPECT_NEAR(driving.motions()[1].velocity_jump, 3, 1e-12);
  EXPECT_NEAR(driving.motions()[1].jump_time, 1.6, 1e-12);
  EXPECT_TRUE(driving.of_part(0, up).pulls.empty()) << "no body is pulled";
}

}  // namespace
}  // namespace ixos
