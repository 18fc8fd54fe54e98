// The paper's ball: what each scheme does on it, and that it does not depend on the number of ranks.
#include <gtest/gtest.h>

#include <cmath>

#include "scene/simulation.hpp"
#include "support/comparison.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::world;

double energy(Simulation& s) {
  const State& state = s.integrator().state();
  return s.model().momenta(state.u.data(), state.v.data()).kinetic_energy + s.model().elastic_energy(state.u.data()) +
         s.model().interaction_energy(state.u.data());
}

struct Fate {
  double end_time;
  double initial_energy;
  double largest_error;  ///< |E - E_0|
};

Fate run_ball(const std::string& scheme, const Comm& comm) {
  Simulation s(test::scene_file("ball.xml", {"Time Integrator/Type=" + scheme}), comm);
  Fate fate{0, energy(s), 0};
  for (int step = 0; step < 10000; ++step) {
    if (!s.integrator().step(0.001).converged) break;
    fate.largest_error = std::max(fate.largest_error, std::abs(energy(s) - fate.initial_energy));
  }
  fate.end_time = s.integrator().time();
  return fate;
}

TEST(BallTest, NewmarkGainsEnergyAndFails) {
  const Fate fate = run_ball("Newmark", test::self());
  EXPECT_GT(fate.end_time, 1.5);
  EXPECT_LT(fate.end_time, 5.0);
  EXPECT_GT(fate.largest_error, 100 * std::abs(fate.initial_energy));
}

TEST(BallTest, BatheReachesTheEndAndLosesEnergy) {
  const Fate fate = run_ball("Bathe Composite", test::self());
  EXPECT_NEAR(fate.end_time, 10, 1e-9);
}

TEST(BallTest, CompositeReachesTheEndWithBoundedEnergy) {
  const Fate fate = run_ball("Gautam-Sauer Composite", test::self());
  EXPECT_NEAR(fate.end_time, 10, 1e-9);
  // Relative to the work of adhesion times the diameter.
  EXPECT_LT(fate.largest_error, 0.2 * 0.155);
}

TEST(BallTest, AverageVectorFieldHoldsTheEnergy) {
  const Fate fate = run_ball("Average Vector Field", test::self());
  EXPECT_NEAR(fate.end_time, 10, 1e-9);
  EXPECT_NEAR(fate.initial_energy, -0.002, 0.0005);
  EXPECT_LT(fate.largest_error, 1e-8 * std::abs(fate.initial_energy));
}

// The motion is chaotic: a rounding error of 1e-16 is 1e-10 after the first impact.
TEST(BallTest, TwoRanksMoveAsOneToTheFirstImpact) {
  for (const char* scheme : {"Newmark", "Bathe Composite", "Gautam-Sauer Composite", "Average Vector Field"}) {
    const auto scene = test::scene_file("ball.xml", {std::string("Time Integrator/Type=") + scheme});
    Simulation whole(scene, world());
    Simulation alone(scene, test::self());
    for (int step = 0; step < 500; ++step) {
      ASSERT_TRUE(whole.integrator().step(0.001).converged);
      ASSERT_TRUE(alone.integrator().step(0.001).converged);
    }
    EXPECT_LT(test::distance(test::gathered(whole.model(), whole.integrator().state().u),
                             test::gathered(alone.model(), alone.integrator().state().u)),
              1e-8)
        << scheme;
  }
}

TEST(BallTest, TwoRanksConserveAsOneDoesAfterTheFirstImpact) {
  Simulation s(test::scene_file("ball.xml", {"Time Integrator/Type=Average Vector Field"}), world());
  const double before = energy(s);
  const State& state = s.integrator().state();
  for (int step = 0; step < 1500; ++step) ASSERT_TRUE(s.integrator().step(0.001).converged);
  EXPECT_NEAR(energy(s), before, 1e-8 * std::abs(before));
  // The wall pushes along y only, and the ball is symmetric: no momentum along x.
  EXPECT_NEAR(s.model().momenta(state.u.data(), state.v.data()).linear[0], 0, 1e-12);
}

}  // namespace
}  // namespace ixos
