// The paper's ball: what each scheme does on it, and that it does not depend on the number of ranks.
#include <gtest/gtest.h>

#include <cmath>

#include "interaction/van_der_waals.hpp"
#include "io/exodus_mesh.hpp"
#include "mesh/generators.hpp"
#include "scene/simulation.hpp"
#include "support/comparison.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::world;

struct Fate {
  double end_time;
  double initial_energy;
  double last_energy;
  double largest_error;  ///< |E - E_0|
};

Fate run_ball(const std::string& scheme) {
  Simulation s(test::scene_file("ball.xml", {"Time Integrator/Type=" + scheme}), test::self());
  Fate fate{0, test::total_energy(s), 0, 0};
  for (int step = 0; step < 10000; ++step) {
    if (!s.integrator().step(0.001).converged) break;
    fate.last_energy = test::total_energy(s);
    fate.largest_error = std::max(fate.largest_error, std::abs(fate.last_energy - fate.initial_energy));
  }
  fate.end_time = s.integrator().time();
  return fate;
}

/// Work of adhesion times the diameter: the energy that sticking sets free.
const double adhesion_energy = 10 * std::cbrt(15.0) * M_PI / (8 * 25 * 2.5);

/// Long runs on one rank say nothing new on two.
bool second_run() { return world()->getSize() > 1; }

TEST(BallTest, NewmarkGainsEnergyAndFails) {
  if (second_run()) GTEST_SKIP();
  const Fate fate = run_ball("Newmark");
  EXPECT_GT(fate.end_time, 1.5);
  EXPECT_LT(fate.end_time, 5.0);
  EXPECT_GT(fate.last_energy, fate.initial_energy + adhesion_energy);
}

TEST(BallTest, BatheReachesTheEndAndLosesEnergy) {
  if (second_run()) GTEST_SKIP();
  const Fate fate = run_ball("Bathe Composite");
  EXPECT_NEAR(fate.end_time, 10, 1e-9);
  EXPECT_LT(fate.last_energy, fate.initial_energy - 0.05 * adhesion_energy);
}

TEST(BallTest, CompositeReachesTheEndWithBoundedEnergy) {
  if (second_run()) GTEST_SKIP();
  const Fate fate = run_ball("Gautam-Sauer Composite");
  EXPECT_NEAR(fate.end_time, 10, 1e-9);
  EXPECT_LT(fate.largest_error, adhesion_energy);  // Newmark's is far above
}

TEST(BallTest, AverageVectorFieldHoldsTheEnergy) {
  if (second_run()) GTEST_SKIP();
  const Fate fate = run_ball("Average Vector Field");
  EXPECT_NEAR(fate.end_time, 10, 1e-9);
  EXPECT_NEAR(fate.initial_energy, -0.002, 0.0005);
  EXPECT_LT(fate.largest_error, 1e-8 * std::abs(fate.initial_energy));
}

TEST(BallTest, EnergyMomentumHoldsTheEnergyForTenThousandSteps) {
  if (second_run()) GTEST_SKIP();
  const Fate fate = run_ball("Energy-Momentum");
  EXPECT_NEAR(fate.end_time, 10, 1e-9);
  EXPECT_LT(fate.largest_error, 1e-8 * std::abs(fate.initial_energy));
}

// The motion is chaotic: a rounding error of 1e-16 is 1e-10 after the first impact.
TEST(BallTest, RanksSolversAndMeshFilesMoveAsOneToTheFirstImpact) {
  const std::string mesh = testing::TempDir() + "ball.e";
  if (world()->getRank() == 0) {
    DiskShape shape;
    shape.center = {0, 7 + VanDerWaals(2.5, 25).equilibrium_gap()};
    write_exodus_mesh(disk(shape), mesh, "ball");
  }
  world()->barrier();
  const struct {
    const char* scheme;
    std::vector<std::string> settings;
  } cases[] = {{"Newmark", {}},
               {"Bathe Composite", {}},
               {"Gautam-Sauer Composite", {}},
               {"Average Vector Field", {}},
               {"Gautam-Sauer Composite", {"Linear Solver/Linear Solver Type=Belos"}},
               {"Gautam-Sauer Composite",
                {"Linear Solver/Linear Solver Type=Belos", "Linear Solver/Preconditioner Type=Ifpack2",
                 "Linear Solver/Linear Solver Types/Belos/Solver Type=Block GMRES"}},
               {"Gautam-Sauer Composite", {"Mesh/Type=Exodus", "Mesh/Exodus/File=" + mesh}}};
  for (const auto& [scheme, settings] : cases) {
    std::vector<std::string> assignments{std::string("Time Integrator/Type=") + scheme};
    Simulation alone(test::scene_file("ball.xml", assignments), test::self());
    assignments.insert(assignments.end(), settings.begin(), settings.end());
    Simulation whole(test::scene_file("ball.xml", assignments), world());
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
  const double before = test::total_energy(s);
  const State& state = s.integrator().state();
  for (int step = 0; step < 1500; ++step) ASSERT_TRUE(s.integrator().step(0.001).converged);
  EXPECT_NEAR(test::total_energy(s), before, 1e-8 * std::abs(before));
  // The wall pushes along y only, and the ball is symmetric: no momentum along x.
  EXPECT_NEAR(s.model().momenta(state.u.data(), state.v.data()).linear[0], 0, 1e-12);
}

}  // namespace
}  // namespace ixos
