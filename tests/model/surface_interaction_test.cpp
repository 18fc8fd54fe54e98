#include "model/surface_interaction.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "interaction/van_der_waals.hpp"
#include "mesh/generators/shapes.hpp"
#include "support/refusal.hpp"
#include "support/solids.hpp"

namespace ixos {
namespace {

/// A plate of 3 by 2 L0 whose bottom is at y = 0.4.
std::unique_ptr<Model> plate() {
  BoxShape shape;
  shape.lower = {0, 0.4, 0};
  shape.lengths = {3, 2, 0};
  shape.divisions = {6, 4, 1};
  return test::model_of(box(shape), test::elastic(linear_elastic, 0.2), Inertia::Consistent);
}

SurfaceInteraction wall_below() {
  SurfaceInteraction wall;
  wall.side_set = "bottom";
  wall.law = gap_law(VanDerWaals(2.5, 25));
  wall.obstacle = flat_wall({});
  return wall;
}

TEST(SurfaceInteractionTest, AParallelSurfaceFeelsTheTractionOfItsGap) {
  auto model = plate();
  SurfaceInteraction wall = wall_below();
  wall.name = "floor";
  add_interaction(*model, wall);
  const std::vector<double> rest = test::at_rest(*model);
  const InteractionReport report = model->interaction_report(rest.data());
  EXPECT_NEAR(report.force[0], 0, 1e-15);
  EXPECT_NEAR(report.force[1], 3 * VanDerWaals(2.5, 25).traction(0.4), 1e-14);
  EXPECT_NEAR(report.least_gap, 0.4, 1e-15);
  EXPECT_EQ(model->force_terms().back().name, "floor");
}

TEST(SurfaceInteractionTest, NothingActsBeyondTheCutoff) {
  auto model = plate();
  SurfaceInteraction wall = wall_below();
  wall.cutoff = 0.35;
  add_interaction(*model, wall);
  EXPECT_EQ(model->interaction_report(test::at_rest(*model).data()).force[1], 0);
}

TEST(SurfaceInteractionTest, UnsoundOnesAreRefused) {
  auto model = plate();
  const auto message = [&](const std::function<void(SurfaceInteraction&)>& spoil) {
    SurfaceInteraction wall = wall_below();
    spoil(wall);
    return test::refusal([&] { add_interaction(*model, wall); });
  };
  test::expect_contains(message([](SurfaceInteraction& i) { i.law = nullptr; }),
                        "the interaction of the surface \"bottom\" has no law");
  test::expect_contains(message([](SurfaceInteraction& i) { i.obstacle = nullptr; }), "has no obstacle");
  test::expect_contains(message([](SurfaceInteraction& i) { i.side_set = "botom"; }), "did you mean \"bottom\"?");
  test::expect_contains(message([](SurfaceInteraction& i) { i.cutoff = 0.3; }), "0.3 cuts off the attraction");
  test::expect_contains(message([](SurfaceInteraction& i) { i.cutoff = -1; }), "-1 cuts off the attraction");
  test::expect_contains(message([](SurfaceInteraction& i) { i.points = 65; }), "65 Gauss points");
  test::expect_contains(message([](SurfaceInteraction& i) { i.margin = 1; }), "step margin 1");
  test::expect_contains(message([](SurfaceInteraction& i) {
                          i.obstacle = flat_wall({{0.0, 0.5, 0.0}, {0.0, 1.0, 0.0}});
                        }),
                        "the surface \"bottom\" starts in or below the wall, least gap -0.1");
  EXPECT_FALSE(model->has_interactions());
}

}  // namespace
}  // namespace ixos
