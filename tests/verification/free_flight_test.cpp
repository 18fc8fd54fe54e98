// A solid of three dimensions in free flight: what its motion keeps.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "scene/simulation.hpp"
#include "support/comparison.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::world;

/// The spatula without a wall.
std::string free_spatula(const std::string& motion) {
  return test::list("Mesh", test::word("Type", "Spatula") + test::list("Spatula", test::count("Target Cells", 400))) +
         test::list("Materials", test::list("Keratin", "")) + test::list("Initial Conditions", motion);
}

/// Steps of 0.01, 0.02, 0.04, ... 1.28: the first is short as Newton's tolerance knows what rounding does to the forces
/// of a body that has moved, but not of one that moves in the step.
void fly(Simulation& s, const std::string& scheme) {
  for (double step = 0.01; step < 1.5; step *= 2) ASSERT_TRUE(s.integrator().step(step).converged) << scheme;
}

Momenta momenta(const Simulation& s) { return test::report_of(s).momenta(); }

TEST(FreeFlightTest, ASpatulaInUniformMotionKeepsItsMomentaAndItsShape) {
  const std::vector<double> velocity{1.0, -0.5, 2.0};
  for (const char* scheme : {"Newmark", "Bathe Composite", "Gautam-Sauer Composite", "Average Vector Field"}) {
    Simulation s(
        test::scene(free_spatula(test::numbers("Velocity", velocity)) + test::time_integrator(scheme, 1.0, 10)),
        world());
    const Momenta before = momenta(s);
    const double mass = before.linear[0] / velocity[0];
    // In steps of a thousand times the elastic time: nothing but rounding moves in the body.
    for (int step = 0; step < 3; ++step) ASSERT_TRUE(s.integrator().step(1.0).converged) << scheme;
    const Momenta after = momenta(s);
    EXPECT_NEAR(before.kinetic_energy, mass * 5.25 / 2, 1e-12 * mass);
    EXPECT_NEAR(after.kinetic_energy, before.kinetic_energy, 1e-10 * before.kinetic_energy) << scheme;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(before.linear[i], mass * velocity[i], 1e-12 * mass);
      EXPECT_NEAR(after.linear[i], before.linear[i], 1e-10 * mass) << scheme;
      EXPECT_NEAR(after.angular[i], before.angular[i], 1e-7 * mass) << scheme;  // arms of 300
    }
    double largest = 0;
    const std::vector<double>& u = s.integrator().state().u;
    for (std::size_t k = 0; k < u.size(); ++k)
      largest = std::max(largest, std::abs(u[k] - s.integrator().time() * velocity[k % 3]));
    EXPECT_LT(s.model().space().maximum(largest), 1e-9) << scheme;
    EXPECT_LT(test::ReportAt(s.model(), u.data()).energy(Part::Elastic), 1e-15) << scheme;
  }
}

// Spin stretches it, so it breathes; these schemes keep its angular momentum nevertheless, in steps of up to
// 0.14 rad.
TEST(FreeFlightTest, ASpinningSpatulaKeepsItsAngularMomentum) {
  for (const char* scheme : {"Midpoint", "Energy-Momentum"}) {
    Simulation s(test::scene(free_spatula(test::numbers("Velocity Gradient", {0, -0.1, 0.05, 0.1, 0, 0, -0.05, 0, 0}) +
                                          test::numbers("Origin", {0, 0, 60})) +
                             test::time_integrator(scheme, 1.0, 10)),
                 world());
    const Momenta before = momenta(s);
    const double energy = test::total_energy(s);
    const double size = std::hypot(before.angular[0], before.angular[1], before.angular[2]);
    fly(s, scheme);
    const Momenta after = momenta(s);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(after.angular[i], before.angular[i], 1e-9 * size) << scheme;
    EXPECT_GT(test::report_of(s).energy(Part::Elastic), 0) << scheme;
    if (scheme == std::string("Midpoint")) continue;  // its steps are too long to hold the energy
    EXPECT_NEAR(test::total_energy(s), energy, 1e-9 * energy) << scheme;
  }
}

}  // namespace
}  // namespace ixos
