// The estimate of the local error against the error of one step.
#include "time/step_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/comparison.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::world;

/// Estimate over error of the step from step * dt on.
double quality(const std::string& scheme, const std::string& parameters, int step, double dt) {
  const auto scene =
      test::scene(test::block_2d(1.0) + test::time_integrator(scheme, dt, 1, parameters) + test::list("Output", ""));
  Simulation s(scene, world()), fine(scene, world());
  Integrator& integrator = s.integrator();
  for (int n = 0; n < step; ++n) {
    EXPECT_TRUE(integrator.attempt(dt).converged);
    integrator.error();  // from the first on a velocity is kept
    integrator.accept();
  }
  fine.integrator().initialize(integrator.state().u, integrator.state().v, integrator.time());
  EXPECT_TRUE(integrator.attempt(dt).converged);
  const double estimate = integrator.error();
  integrator.accept();
  for (int n = 0; n < 40; ++n) EXPECT_TRUE(fine.integrator().step(dt / 40).converged);
  return estimate / test::distance(test::gathered(s.model(), integrator.state().u),
                                   test::gathered(fine.model(), fine.integrator().state().u));
}

TEST(StepErrorTest, EstimatesAreTheErrorInTheLimit) {
  for (const std::string& scheme : test::moving_schemes()) {
    const double later = quality(scheme, "", 12, 0.02);
    EXPECT_NEAR(later, 1, 0.15) << scheme;
    const double finer = quality(scheme, "", 24, 0.01);
    EXPECT_LT(std::abs(finer - 1), std::max(0.75 * std::abs(later - 1), 0.05)) << scheme;
  }
  EXPECT_NEAR(quality("Generalized-Alpha", test::number("Spectral Radius", 0.9), 12, 0.01), 1, 0.1);
  EXPECT_NEAR(quality("Bathe Composite", test::number("Spectral Radius", 0.6) + test::number("Split", 0), 12, 0.01), 1,
              0.1);
  EXPECT_NEAR(quality("Gautam-Sauer Composite", test::number("Beta", 0.3) + test::number("Gamma", 0.6), 12, 0.01), 1,
              0.1);
}

TEST(StepErrorTest, TheFirstStepHasOneToo) {
  for (const char* scheme : {"Newmark", "Average Vector Field", "Bathe Composite", "Central Difference"})
    EXPECT_NEAR(quality(scheme, "", 0, 0.005), 1, 0.15) << scheme;
}

TEST(StepErrorEmptyRanksTest, JudgeWithTheOthers) {
  // Four nodes: on six ranks some have none, and momentum-form schemes solve for the first acceleration together.
  Simulation s(test::scene(test::oscillator() + test::time_integrator("Average Vector Field", 0.1, 1)), world());
  for (int n = 0; n < 3; ++n) {
    ASSERT_TRUE(s.integrator().attempt(0.1).converged);
    EXPECT_GT(s.integrator().error(), 1e-12);
    s.integrator().accept();
  }
}

TEST(StepErrorTest, AnAttemptChangesNothing) {
  Simulation s(test::scene(test::block_2d(1.0) + test::time_integrator("Newmark", 0.1, 1)), world());
  Integrator& integrator = s.integrator();
  const State before = integrator.state();
  EXPECT_THROW(integrator.accept(), std::logic_error);
  EXPECT_THROW(integrator.error(), std::logic_error);
  ASSERT_TRUE(integrator.attempt(0.2).converged);
  ASSERT_TRUE(integrator.attempt(0.1).converged);
  EXPECT_EQ(integrator.state().u, before.u);
  EXPECT_EQ(integrator.time(), 0);
  integrator.accept();
  EXPECT_EQ(integrator.time(), 0.1);
  EXPECT_THROW(integrator.accept(), std::logic_error);
}

}  // namespace
}  // namespace ixos
