// Obstacles that move: the work of a wall, a wave that turns, and the choice of the frame.
#include <gtest/gtest.h>

#include <cmath>

#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/half_space.hpp"
#include "interaction/van_der_waals.hpp"
#include "mesh/generators/shapes.hpp"
#include "model/conditions.hpp"
#include "model/surface_interaction.hpp"
#include "support/refusal.hpp"
#include "support/reports.hpp"
#include "support/solids.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

const double adhesion = 0.01549567;  // the work of adhesion of the law below

Table table_of(const std::string& scheme) {
  if (scheme == "Newmark") return newmark(0.25, 0.5);
  if (scheme == "Bathe Composite") return bathe_composite(0.5, bathe_default_split(0.5));
  if (scheme == "Gautam-Sauer Composite") return gautam_sauer_composite(0.25, 0.5, 5, Path::Kinematic);
  if (scheme == "Average Vector Field") return average_vector_field(4, 8);
  if (scheme == "Exact Average Vector Field") return average_vector_field(4, 0);
  if (scheme == "Energy-Momentum") return energy_momentum();
  if (scheme == "Midpoint") return midpoint();
  if (scheme == "Generalized-Alpha") return generalized_alpha(0.8);
  if (scheme == "Central Difference") return central_difference(0.9);
  return static_equilibrium();
}

const char* const schemes_with_inertia[] = {"Newmark",
                                            "Bathe Composite",
                                            "Gautam-Sauer Composite",
                                            "Average Vector Field",
                                            "Exact Average Vector Field",
                                            "Energy-Momentum",
                                            "Midpoint",
                                            "Generalized-Alpha",
                                            "Central Difference"};

/// A block of 2 by 1 whose bottom is at y = 0.3; E = 1, density 1.
std::unique_ptr<Model> block(Inertia inertia) {
  BoxShape shape;
  shape.lower = {0, 0.3, 0};
  shape.lengths = {2, 1, 0};
  shape.divisions = {4, 2, 1};
  return test::model_of(box(shape), test::elastic(neo_hooke, 0.3), inertia);
}

std::shared_ptr<const TimeFunction> linear(double rate) {
  return function_of_time([rate](double t) { return TimeValue{rate * t, rate, 0}; });
}

RigidMotion translation(double vx, double vy) {
  RigidMotionOptions options;
  options.translation = {linear(vx), linear(vy)};
  return {2, options};
}

SurfaceInteraction before(std::shared_ptr<const Obstacle> obstacle, RigidMotion motion) {
  SurfaceInteraction wall;
  wall.side_set = "bottom";
  wall.law = gap_law(VanDerWaals(2.5, 25));
  wall.obstacle = std::move(obstacle);
  wall.motion = std::move(motion);
  return wall;
}

double energy(const Model& model, const State& state) {
  return StateReport(model, state).momenta().kinetic_energy + StateReport(model, state).energy(Part::Elastic) +
         StateReport(model, state).energy(Part::Interaction);
}

/// A wall that leaves a held surface works against the traction: int T dg times the length, whatever the step.
TEST(MovedObstaclesTest, AWallThatLeavesAHeldBodyWorksAgainstTheLaw) {
  const VanDerWaals law(2.5, 25);
  for (const char* scheme : {"Exact Average Vector Field", "Energy-Momentum", "Static", "Newmark"}) {
    auto model = block(std::string(scheme) == "Static" ? Inertia::None : Inertia::Consistent);
    add_interaction(*model, before(flat_wall({}), translation(0, -0.01)));
    for (const char* set : {"bottom", "top"}) prescribe(*model, set, "all", nullptr);
    Integrator integrator = test::direct(*model, table_of(scheme));
    integrator.initialize(test::at_rest(*model), test::at_rest(*model), 0);
    const bool exact = std::string(scheme) == "Exact Average Vector Field" || std::string(scheme) == "Energy-Momentum";
    const int steps = exact ? 10 : 100;
    for (int n = 0; n < steps; ++n) {
      const StepResult result = integrator.step(20.0 / steps);
      ASSERT_TRUE(result.converged) << scheme << ": " << result.reason;
    }
    const double work = 2 * (law.energy(0.5) - law.energy(0.3));
    EXPECT_NEAR(integrator.external_work(), work, exact ? 1e-13 : 3e-5) << scheme;
    EXPECT_NEAR(StateReport(*model, integrator.state()).energy(Part::Interaction), 2 * law.energy(0.5), 1e-14);
    EXPECT_NEAR(StateReport(*model, integrator.state()).interaction_report().least_gap, 0.5, 1e-12);
  }
}

/// A body at rest before a wall that moves is a body that moves before a wall at rest.
TEST(MovedObstaclesTest, OnlyTheRelativeMotionCounts) {
  const double vx = 0.004, vy = 0.006, dt = 0.05;
  std::vector<std::shared_ptr<const Obstacle>> obstacles = {
      flat_wall({}), make_obstacle("Sphere", 2, {{"Radius", 3.0}, {"Center", {0.8, -3.0}}})};
  for (const auto& obstacle : obstacles)
    for (const char* scheme : schemes_with_inertia) {
      const Inertia inertia = std::string(scheme) == "Central Difference" ? Inertia::Lumped : Inertia::Consistent;
      std::vector<double> ends[2];
      for (const bool wall_moves : {false, true}) {
        auto model = block(inertia);
        add_interaction(*model, before(obstacle, wall_moves ? translation(vx, vy) : translation(0, 0)));
        std::vector<double> v = test::at_rest(*model);
        for (std::size_t k = 0; k < v.size() && !wall_moves; ++k) v[k] = k % 2 == 0 ? -vx : -vy;
        Integrator integrator = test::direct(*model, table_of(scheme), 1e-13);
        integrator.initialize(test::at_rest(*model), v, 0);
        for (int n = 0; n < 60; ++n) {
          const StepResult result = integrator.step(dt);
          ASSERT_TRUE(result.converged) << scheme << ": " << result.reason;
        }
        ends[wall_moves ? 1 : 0] = integrator.state().u;
      }
      for (std::size_t k = 0; k < ends[0].size(); ++k)
        EXPECT_NEAR(ends[1][k], ends[0][k] + (k % 2 == 0 ? vx : vy) * 60 * dt, 1e-10) << scheme;
    }
}

/// A sine wall that swings and turns before the block.
std::unique_ptr<Model> block_before_a_wave(Inertia inertia) {
  auto model = block(inertia);
  RigidMotionOptions options;
  options.translation = {linear(0.01), function_of_time([](double t) {
                           const double a = 0.02, w = 1.5;
                           return TimeValue{a * std::sin(w * t), a * w * std::cos(w * t), -a * w * w * std::sin(w * t)};
                         })};
  options.angle = function_of_time([](double t) {
    const double a = 0.03, w = 0.7;
    return TimeValue{a * std::sin(w * t), a * w * std::cos(w * t), -a * w * w * std::sin(w * t)};
  });
  options.point = {1, 0};
  const auto wave = make_obstacle("Sine Wall", 2, {{"Amplitude", 0.02}, {"Period", 1.5}});
  SurfaceInteraction wall = before(wave, RigidMotion(2, options));
  wall.cutoff = 2;  // within the wave's reach
  add_interaction(*model, wall);
  return model;
}

struct Balance {
  double error = 0, work = 0;
};

Balance balance(const char* scheme, double dt, int steps) {
  auto model = block_before_a_wave(Inertia::Consistent);
  Integrator integrator = test::direct(*model, table_of(scheme), 1e-12);
  integrator.initialize(test::at_rest(*model), test::at_rest(*model), 0);
  const double first = energy(*model, integrator.state());
  Balance result;
  for (int n = 0; n < steps; ++n) {
    const StepResult step = integrator.step(dt);
    EXPECT_TRUE(step.converged) << scheme << ", step " << n << ": " << step.reason;
    if (!step.converged) break;
    result.error =
        std::max(result.error, std::abs(energy(*model, integrator.state()) - integrator.external_work() - first));
    result.work = std::max(result.work, std::abs(integrator.external_work()));
  }
  return result;
}

TEST(MovedObstaclesTest, TheBalanceBeforeAMovingWaveCloses) {
  for (const char* scheme : {"Exact Average Vector Field", "Average Vector Field", "Energy-Momentum"}) {
    const Balance result = balance(scheme, 0.02, 1000);
    EXPECT_LT(result.error, 1e-9 * 2 * adhesion) << scheme;
    EXPECT_GT(result.work, 1e-2 * 2 * adhesion) << scheme << ": the wave works";
  }
}

/// The other schemes show their own error, of order 2.
TEST(MovedObstaclesTest, TheBalanceOfOtherSchemesConverges) {
  for (const char* scheme : {"Newmark", "Bathe Composite", "Gautam-Sauer Composite", "Midpoint"}) {
    const double coarse = balance(scheme, 0.02, 50).error, fine = balance(scheme, 0.01, 100).error;
    EXPECT_LT(coarse, 1e-2 * 2 * adhesion) << scheme;
    EXPECT_LT(fine, 0.3 * coarse + 1e-12) << scheme;
  }
}

/// An attempt that is not accepted leaves no trace, and the model reports on the state that was accepted last.
TEST(MovedObstaclesTest, AStepBackRepeatsBitForBit) {
  for (const char* scheme : {"Newmark", "Bathe Composite", "Average Vector Field", "Generalized-Alpha"}) {
    auto model = block_before_a_wave(Inertia::Consistent);
    Integrator integrator = test::direct(*model, table_of(scheme));
    integrator.initialize(test::at_rest(*model), test::at_rest(*model), 0);
    for (int n = 0; n < 3; ++n) ASSERT_TRUE(integrator.step(0.02).converged);
    const double before = StateReport(*model, integrator.state()).energy(Part::Interaction);
    ASSERT_TRUE(integrator.attempt(0.07).converged);
    EXPECT_EQ(StateReport(*model, integrator.state()).energy(Part::Interaction), before) << scheme;
  }
}

// Nothing else drives the body.
TEST(MovedObstaclesTest, AMotionThatEndsInNoNumberEndsTheStep) {
  for (const char* scheme : {"Newmark", "Average Vector Field", "Central Difference"}) {
    auto model = block(Inertia::Consistent);
    if (std::string(scheme) == "Central Difference") model = block(Inertia::Lumped);
    RigidMotionOptions options;
    options.translation = {nullptr, expression("-0.01*sqrt(0.045-t)*0", "0", "0")};
    add_interaction(*model, before(flat_wall({}), {2, options}));
    Integrator integrator = test::direct(*model, table_of(scheme));
    integrator.initialize(test::at_rest(*model), test::at_rest(*model), 0);
    for (int n = 0; n < 4; ++n) ASSERT_TRUE(integrator.step(0.01).converged) << scheme;
    const StepResult result = integrator.step(0.01);
    EXPECT_FALSE(result.converged);
    EXPECT_EQ(result.newton_iterations, 0) << scheme;
    test::expect_contains(result.reason, "an obstacle's motion or a load is not a finite number between t = 0.04 and");
  }
}

TEST(MovedObstaclesTest, RefusesAWallThatStartsInTheBodyAndOneThatLeavesTheAxis) {
  const auto refusal = [](double vy, double start) {
    return test::refusal([&] {
      auto model = block(Inertia::Consistent);
      SurfaceInteraction wall = before(flat_wall({}), translation(0, vy));
      wall.initial_time = start;
      add_interaction(*model, wall);
    });
  };
  EXPECT_EQ(refusal(0.1, 2), "");
  EXPECT_NE(refusal(0.1, 4).find("starts in or below the wall, least gap -0.1 at node"), std::string::npos)
      << refusal(0.1, 4);
  const std::string dimensions = test::refusal([&] {
    auto model = block(Inertia::Consistent);
    add_interaction(*model, before(flat_wall({}), RigidMotion(3, {})));
  });
  EXPECT_NE(dimensions.find("has an obstacle whose motion has 3 dimensions, but the mesh has 2"), std::string::npos);
}

}  // namespace
}  // namespace ixos
