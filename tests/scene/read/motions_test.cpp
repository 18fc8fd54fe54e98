#include "scene/read/motions.hpp"

#include <gtest/gtest.h>

#include "model/traits.hpp"
#include "scene/explain/explanation.hpp"
#include "scene/simulation.hpp"
#include "support/refusal.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::list;
using test::number;
using test::numbers;
using test::texts;
using test::word;
using test::world;

/// A plate of 3 by 2 with a wall 0.3 below that moves.
Teuchos::ParameterList plate(const std::string& motion, const std::string& mesh = "") {
  return test::scene(list("Mesh", word("Type", "Box") + mesh +
                                      list("Box", numbers("Lengths", {3, 2}) + test::counts("Divisions", {3, 2}))) +
                     list("Materials", list("Rubber", number("Density", 1))) +
                     list("Histories", test::expression("Press", "0.01*t", "0.01", "0") +
                                           test::expression("Turn", "0.02*t", "0.02", "0")) +
                     list("Interactions", list("Wall", word("Side Set", "bottom") + numbers("Point", {0, -0.3}) +
                                                           list("Motion", motion))) +
                     test::time_integrator("Newmark", 0.1, 1));
}

std::string refusal(const std::string& motion, const std::string& mesh = "") {
  return test::refusal([&] { Simulation(plate(motion, mesh), world()); });
}

TEST(MotionsTest, AnObstacleFollowsItsHistories) {
  Simulation s(plate(texts("Translation", "{-, Press}")), world());
  const auto gap = [&](double time) {
    Place place = s.integrator().state().place();
    place.time = time;
    return StateReport(s.model(), place).interaction_report().least_gap;
  };
  EXPECT_NEAR(gap(0), 0.3, 1e-14);
  EXPECT_NEAR(gap(5), 0.25, 1e-14);
  EXPECT_TRUE(has_moved_obstacles(s.model()));
  test::expect_contains(explain(s), "The obstacle is driven by history Press; its work is part of external_work");
  EXPECT_FALSE(has_moved_obstacles(Simulation(plate(""), world()).model()));
  EXPECT_FALSE(has_moved_obstacles(Simulation(plate(texts("Translation", "{-, -}")), world()).model()));
}

TEST(MotionsTest, RefusesWhatIsNoMotion) {
  EXPECT_EQ(refusal(texts("Translation", "{Press}")),
            "Interactions/Wall/Motion/Translation has 1 elements, not 2, which the dimension of the mesh requires");
  test::expect_contains(refusal(texts("Translation", "{-, Pres}")), "Interactions/Wall/Motion/Translation");
  test::expect_contains(refusal(word("Rotation", "Turn") + numbers("Axis", {0, 1})), "Interactions/Wall/Motion/Axis");
}

TEST(MotionsTest, OnAnAxisymmetricMeshAnObstacleMovesAlongTheAxis) {
  const std::string geometry = word("Geometry", "Axisymmetric");
  EXPECT_EQ(refusal(texts("Translation", "{-, Press}"), geometry), "");
  for (const std::string& motion : {texts("Translation", "{Press, -}"), word("Rotation", "Turn")})
    test::expect_contains(refusal(motion, geometry),
                          "moves off the axis of an axisymmetric mesh: it may translate along y only");
}

}  // namespace
}  // namespace ixos
