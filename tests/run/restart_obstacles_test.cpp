// Curved obstacles that move and rough walls: runs resume bit for bit, and ranks agree.
#include <gtest/gtest.h>

#include <cmath>

#include "run/restart_fixture.hpp"
#include "support/comparison.hpp"
#include "support/reports.hpp"
#include "test_folders.hpp"

namespace ixos::test {
namespace {

/// A block of 3 by 1 L0 that falls on an obstacle, which moves and, if `turning`, turns about (1, 0).
std::string thrown(const std::string& obstacle, bool turning, const std::string& more) {
  const std::string motion =
      list("Motion", texts("Translation", "{Along, Up}") +
                         (turning ? word("Rotation", "Turn") + numbers("Point", {1, 0}) : std::string()));
  return list("Mesh", word("Type", "Box") + list("Box", numbers("Lower", {-1.5, 0.4}) + numbers("Lengths", {3, 1}) +
                                                            counts("Divisions", {8, 2}))) +
         list("Materials", list("Rubber", number("Density", 1))) +
         list("Histories", expression("Along", "0.02*t", "0.02", "0") +
                               expression("Up", "0.01*sin(2*t)", "0.02*cos(2*t)", "-0.04*sin(2*t)") +
                               expression("Turn", "0.02*t", "0.02", "0")) +
         list("Interactions", list("Wall", word("Side Set", "bottom") + obstacle + motion)) +
         list("Initial Conditions", numbers("Velocity", {0.02, -0.1})) + more;
}

std::string sphere(const std::string& more) {
  return thrown(word("Obstacle", "Sphere") + list("Sphere", number("Radius", 3) + numbers("Center", {0.2, -3.0})) +
                    word("Contact Element", "Q1C2"),
                true, more);
}

/// Over hills of 0.16 L0, 20 L0 long.
std::string hills(const std::string& more) {
  const std::string field =
      word("File", IXOS_TEST_DIRECTORY "/interaction/hills.txt") + numbers("Spacing", {0.25, 1}) + word("Level", "Top");
  return thrown(word("Obstacle", "Height Field") + list("Height Field", field) + number("Cutoff", 2), false, more);
}

/// Integrators with a mean in closed form, with the discrete gradient, and with points in time in two stages.
std::vector<std::string> integrators(double step, double end) {
  const std::string mean =
      word("Type", "Average Vector Field") + list("Average Vector Field", count("Interaction Points", 0));
  std::vector<std::string> lists;
  for (const std::string& scheme : {mean, word("Type", "Energy-Momentum"), word("Type", "Bathe Composite")})
    lists.push_back(scheme + steps(step, end));
  return lists;
}

using RestartObstaclesTest = RestartTest;

TEST_F(RestartObstaclesTest, RunsBeforeAMovedSphereGoOn) {
  for (const std::string& integrator : integrators(0.05, 1)) {
    SCOPED_TRACE(integrator);
    expect_goes_on(sphere(list("Output", checkpoints(8, 100)) + list("Time Integrator", integrator)), {8});
  }
}

TEST_F(RestartObstaclesTest, RunsBeforeARoughWallGoOn) {
  for (const std::string& integrator : integrators(0.05, 1)) {
    SCOPED_TRACE(integrator);
    expect_goes_on(hills(list("Output", checkpoints(8, 100)) + list("Time Integrator", integrator)), {8});
  }
}

TEST_F(RestartObstaclesTest, RanksAgree) {
  for (const auto& before : {sphere, hills})
    for (const std::string& integrator : integrators(0.05, 1)) {
      SCOPED_TRACE(integrator);
      const std::string scene = before(list("Time Integrator", integrator));
      Simulation whole(test::scene(scene), world()), alone(test::scene(scene), self());
      for (int step = 0; step < 20; ++step) {
        ASSERT_TRUE(whole.integrator().step(0.05).converged);
        ASSERT_TRUE(alone.integrator().step(0.05).converged);
      }
      const std::vector<double>&u = whole.integrator().state().u, &v = alone.integrator().state().u;
      EXPECT_LT(distance(gathered(whole.model(), u), gathered(alone.model(), v)), 1e-8);
      EXPECT_NEAR(total_energy(whole), total_energy(alone), 1e-10);
      EXPECT_NEAR(whole.integrator().external_work(), alone.integrator().external_work(), 1e-10);
      EXPECT_GT(std::abs(alone.integrator().external_work()), 1e-6) << "the obstacle works";
      EXPECT_NEAR(test::report_of(whole).interaction_report().least_gap,
                  test::report_of(alone).interaction_report().least_gap, 1e-8);
    }
}

}  // namespace
}  // namespace ixos::test
