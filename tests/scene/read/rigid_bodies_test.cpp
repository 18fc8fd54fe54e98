#include "scene/read/rigid_bodies.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/explain/explanation.hpp"
#include "scene/simulation.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::list;
using test::number;
using test::numbers;
using test::texts;
using test::word;
using test::world;

struct Scene {
  std::string body{};
  std::string interaction = word("Rigid Body", "Ball");
  std::string scheme = "Newmark";
  std::string mesh{};
  std::string more{};
  int dimension = 2;
};

/// A block with a half-space of a body 1 above it.
Teuchos::ParameterList scene(const Scene& own) {
  const bool solid = own.dimension == 3;
  const std::string box =
      list("Box", test::count("Dimension", own.dimension) +
                      numbers("Lengths", solid ? std::vector<double>{2, 2, 1} : std::vector<double>{2, 1}) +
                      test::counts("Divisions", solid ? std::vector<int>{2, 2, 1} : std::vector<int>{2, 1}));
  const std::string wall = word("Side Set", "top") +
                           numbers("Normal", solid ? std::vector<double>{0, 0, -1} : std::vector<double>{0, -1}) +
                           numbers("Point", solid ? std::vector<double>{0, 0, 2} : std::vector<double>{0, 2});
  return test::scene(
      list("Mesh", word("Type", "Box") + own.mesh + box) + list("Materials", list("Rubber", number("Density", 1))) +
      list("Histories", test::expression("Press", "0.01*t", "0.01", "0")) +
      list("Rigid Bodies", list("Ball", own.body)) + list("Interactions", list("Wall", wall + own.interaction)) +
      own.more + test::time_integrator(own.scheme, 0.1, 1));
}

std::string refusal(const Scene& own) {
  return test::refusal([&] { Simulation(scene(own), world()); });
}

RigidBodyOptions body_of(const Scene& own) {
  return Simulation(scene(own), world()).model().rigid_bodies()[0].options();
}

TEST(RigidBodiesSceneTest, ShapesHaveTheirMassAndInertia) {
  const std::string sphere = word("Shape", "Sphere") + number("Density", 2) + number("Radius", 3);
  EXPECT_DOUBLE_EQ(body_of({sphere}).mass, 2 * M_PI * 9);
  EXPECT_DOUBLE_EQ(body_of({sphere}).inertia[2][2], 2 * M_PI * 9 * 9 / 2);
  Scene own{sphere};
  own.dimension = 3;
  EXPECT_DOUBLE_EQ(body_of(own).mass, 2 * 4.0 / 3 * M_PI * 27);
  EXPECT_DOUBLE_EQ(body_of(own).inertia[0][0], 0.4 * 2 * 4.0 / 3 * M_PI * 27 * 9);
  own.body = word("Shape", "Box") + number("Density", 2) + numbers("Sides", {1, 2, 3});
  EXPECT_DOUBLE_EQ(body_of(own).mass, 12);
  EXPECT_DOUBLE_EQ(body_of(own).inertia[1][1], 12 * (1 + 9) / 12.0);
  own.body = word("Shape", "Cylinder") + number("Density", 2) + number("Radius", 1) + number("Height", 3) +
             numbers("Direction", {5, 0, 0});
  EXPECT_DOUBLE_EQ(body_of(own).inertia[0][0], 6 * M_PI / 2);
  EXPECT_DOUBLE_EQ(body_of(own).inertia[2][2], 6 * M_PI * (0.25 + 9 / 12.0));
  own.body = number("Mass", 2) + numbers("Inertia", {2, 3, 4, 0.1, 0.2, 0.3});
  EXPECT_DOUBLE_EQ(body_of(own).inertia[0][1], 0.1);
  EXPECT_DOUBLE_EQ(body_of(own).inertia[2][1], 0.2);
  EXPECT_DOUBLE_EQ(body_of(own).inertia[0][2], 0.3);
  EXPECT_DOUBLE_EQ(body_of({sphere, word("Rigid Body", "Ball"), "Newmark", word("Geometry", "Axisymmetric")}).mass,
                   2 * 4.0 / 3 * M_PI * 27);
}

TEST(RigidBodiesSceneTest, EachMistakeHasItsMessage) {
  const std::string whole = number("Mass", 1) + numbers("Inertia", {1});
  EXPECT_EQ(refusal({whole}), "");
  EXPECT_EQ(refusal({""}), "Rigid Bodies/Ball/Mass is missing: a body that moves in time needs it");
  EXPECT_EQ(refusal({number("Mass", 1)}),
            "Rigid Bodies/Ball: the rigid body \"Ball\" turns and has the inertia 0; it must be above 0");
  EXPECT_EQ(refusal({whole + texts("Held", "{z}")}),
            "Rigid Bodies/Ball/Held: there is no direction \"z\" here; allowed: \"x\", \"y\", \"rz\"");
  EXPECT_EQ(refusal({whole + numbers("Centre", {1})}),
            "Rigid Bodies/Ball/Centre has 1 elements, not 2, which the dimension of the mesh requires");
  test::expect_contains(refusal({whole + texts("Held", "{x}") + numbers("Velocity", {1, 0})}),
                        "Rigid Bodies/Ball/Velocity: the body is held along that direction");
  test::expect_contains(refusal({whole, word("Rigid Body", "Bell")}), "did you mean \"Ball\"?");
  test::expect_contains(
      refusal({whole, word("Rigid Body", "Ball") + list("Motion", texts("Translation", "{-, Press}"))}),
      "Interactions/Wall/Motion: moves an obstacle that belongs to a Rigid Body");
  test::expect_contains(refusal({whole, word("Rigid Body", "Ball"), "Central Difference"}),
                        "Rigid Bodies: the scheme \"Central Difference\" is explicit: its longest stable step");
  test::expect_contains(refusal({whole, "", "Static"}), "Rigid Bodies/Ball: nothing holds the body");
  test::expect_contains(refusal({whole + word("Rotation", "Press")}),
                        "Rigid Bodies/Ball/Rotation: with it each direction must be Held or have a history");
  test::expect_contains(refusal({whole + texts("Translation", "{Press, -}") + texts("Held", "{x}")}),
                        "Rigid Bodies/Ball/Translation: it moves the body along a direction in which it is Held");
  test::expect_contains(refusal({word("Shape", "Sphere") + number("Radius", 1)}),
                        "Rigid Bodies/Ball/Density is missing: the Shape needs it");
  test::expect_contains(refusal({whole + numbers("Moment", {1, 2})}), "Rigid Bodies/Ball/Moment has 2 elements, not 1");
  const std::string grip = word("Node Set", "bottom") + word("Rigid Body", "Ball");
  Scene own{whole};
  own.more = list("Grips", list("Glue", grip + texts("Translation", "{-, Press}")));
  test::expect_contains(refusal(own), "Grips/Glue/Rigid Body: moves the grip");
  own.more = list("Grips", list("Glue", grip + word("Type", "Springs") + numbers("Stiffness", {1, 1})));
  test::expect_contains(refusal(own), "Grips/Glue/Rigid Body: carries the nodes of a Rigid grip");
  own.more = list("Grips", list("Glue", grip)) +
             list("Boundary Conditions", list("Floor", word("Node Set", "bottom") + word("Components", "y")));
  test::expect_contains(refusal(own), "a condition holds or moves a degree of freedom that a rigid body carries");
}

TEST(RigidBodiesSceneTest, WhatHasNoEffectIsRefused) {
  const std::string whole = texts("Translation", "{-, Press}") + texts("Held", "{x, rz}");
  EXPECT_EQ(refusal({whole}), "");
  test::expect_contains(refusal({whole + numbers("Force", {0, 1})}), "Rigid Bodies/Ball/Force: has no effect");
  test::expect_contains(refusal({whole + numbers("Spin", {1})}), "Rigid Bodies/Ball/Spin: has no effect");
  Scene own{number("Mass", 1) + texts("Translation", "{Press, -}")};
  own.mesh = word("Geometry", "Axisymmetric");
  test::expect_contains(refusal(own), "Rigid Bodies/Ball/Translation: it moves the body off the axis");
  own = {number("Mass", 1) + numbers("Inertia", {1})};
  own.scheme = "Generalized-Alpha";
  own.more = list("Grips", list("Glue", word("Node Set", "bottom") + word("Rigid Body", "Ball")));
  test::expect_contains(refusal(own), "weights forces of both ends of a step");
  own.body += texts("Held", "{rz}");
  EXPECT_EQ(refusal(own), "");
}

TEST(RigidBodiesSceneTest, TheExplanationNamesThem) {
  const std::string text = explain(Simulation(scene({number("Mass", 2) + texts("Held", "{x, rz}")}), world()));
  test::expect_contains(text, "Rigid body Ball: mass 2, centre (0, 0), moves along or about y");
  test::expect_contains(text, "The obstacle belongs to the rigid body Ball");
}

}  // namespace
}  // namespace ixos
