// Rigid bodies: runs resume bit for bit, and ranks agree.
#include <gtest/gtest.h>

#include "run/restart_fixture.hpp"
#include "support/comparison.hpp"
#include "support/rigid_scene.hpp"

namespace ixos::test {
namespace {

const char* const schemes[] = {"Energy-Momentum", "Average Vector Field", "Newmark", "Bathe Composite"};

std::string scene_of(int dimension, const std::string& scheme, const std::string& output) {
  const std::string held = word("Force History", "Push");
  const std::string push =
      numbers("Force", dimension == 3 ? std::vector<double>{0, 0, -1} : std::vector<double>{0, -1});
  RigidScene options;
  options.dimension = dimension;
  options.mass = 3;
  options.gap = 0.3;
  options.plate = dimension == 2 ? 5 : 0;
  options.body = push + held;
  options.more = list("Histories", expression("Push", "0.1*t")) + list("Output", output);
  return ball_on_block_lists(options) + list("Time Integrator", word("Type", scheme) + steps(0.02, 0.6));
}

using RestartRigidTest = RestartTest;

TEST_F(RestartRigidTest, RunsGoOn) {
  for (const int dimension : {2, 3})
    for (const char* const scheme : schemes) {
      SCOPED_TRACE(std::string(scheme) + std::to_string(dimension));
      expect_goes_on(scene_of(dimension, scheme, checkpoints(13, 100)), {13, 26});
    }
}

TEST_F(RestartRigidTest, RanksAgree) {
  for (const int dimension : {2, 3})
    for (const char* const scheme : schemes) {
      SCOPED_TRACE(std::string(scheme) + std::to_string(dimension));
      const std::string text = scene_of(dimension, scheme, "");
      Simulation whole(test::scene(text), world()), alone(test::scene(text), self());
      for (int step = 0; step < 30; ++step) {
        ASSERT_TRUE(whole.integrator().step(0.02).converged);
        ASSERT_TRUE(alone.integrator().step(0.02).converged);
      }
      const State &one = whole.integrator().state(), &other = alone.integrator().state();
      EXPECT_LT(distance(gathered(whole.model(), one.u), gathered(alone.model(), other.u)), 1e-9);
      for (std::size_t i = 0; i < RigidBody::numbers; ++i) {
        EXPECT_NEAR(one.u[whole.model().first_number(0) + i], other.u[alone.model().first_number(0) + i], 1e-9);
        EXPECT_NEAR(one.v[whole.model().first_number(0) + i], other.v[alone.model().first_number(0) + i], 1e-8);
      }
      EXPECT_NEAR(whole.integrator().external_work(), alone.integrator().external_work(), 1e-10);
      EXPECT_NE(alone.integrator().external_work(), 0);
    }
}

}  // namespace
}  // namespace ixos::test
