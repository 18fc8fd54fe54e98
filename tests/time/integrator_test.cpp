#include "time/integrator.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/comparison.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::block_2d;
using test::time_integrator;
using test::world;

const char* const all_schemes[] = {"Newmark", "Bathe Composite", "Gautam-Sauer Composite", "Average Vector Field"};

TEST(IntegratorTest, AFailedStepChangesNothing) {
  for (const char* scheme : all_schemes) {
    // One Newton iteration cannot solve a large step: the step fails.
    Simulation s(test::scene(block_2d(1.0) + time_integrator(scheme, 0.1, 1) +
                             test::list("Nonlinear Solver", test::count("Maximum Iterations", 1))),
                 world());
    Integrator& integrator = s.integrator();
    const State before = integrator.state();
    const StepResult result = integrator.step(0.5);
    EXPECT_FALSE(result.converged) << scheme;
    EXPECT_FALSE(result.reason.empty());
    EXPECT_EQ(integrator.time(), 0);
    EXPECT_EQ(integrator.state().u, before.u) << scheme;
    EXPECT_EQ(integrator.state().v, before.v) << scheme;
    EXPECT_EQ(integrator.state().a, before.a) << scheme;
  }
}

TEST(IntegratorTest, AfterAFailureTheRunGoesOnAsIfNothingHadHappened) {
  for (const char* scheme : all_schemes) {
    const auto scene = test::scene(block_2d(1.0) + time_integrator(scheme, 0.02, 1) +
                                   test::list("Nonlinear Solver", test::count("Maximum Iterations", 6)));
    Simulation disturbed(scene, world());
    Simulation smooth(scene, world());
    for (int step = 0; step < 5; ++step) {
      EXPECT_FALSE(disturbed.integrator().step(1e3).converged) << scheme;
      ASSERT_TRUE(disturbed.integrator().step(0.02).converged) << scheme;
      ASSERT_TRUE(smooth.integrator().step(0.02).converged) << scheme;
    }
    EXPECT_EQ(disturbed.integrator().state().u, smooth.integrator().state().u) << scheme;
    EXPECT_EQ(disturbed.integrator().state().v, smooth.integrator().state().v) << scheme;
  }
}

TEST(IntegratorTest, InitialAccelerationSatisfiesTheBalance) {
  // A uniformly stretched bar, released: M a_0 = -f(u_0), so the total of M a_0 is zero and a_0 is not.
  Simulation s(test::scene(block_2d(0.0) + time_integrator("Newmark", 0.01, 1)), world());
  const Model& model = s.model();
  std::vector<double> u(static_cast<std::size_t>(model.space().local()));
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = 0.1 * model.mesh().coordinates[i];
  s.integrator().initialize(u, std::vector<double>(u.size(), 0.0), 0.0);
  std::vector<double> inertia(u.size(), 0.0), force(u.size());
  model.mass()->multiply(s.integrator().state().a.data(), inertia.data());
  model.elastic_force({nullptr, nullptr, u.data()}, end_rule(), force.data());
  double largest = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(model.space().owned()); ++i) {
    EXPECT_NEAR(inertia[i], -force[i], 1e-13);
    largest = std::max(largest, std::abs(force[i]));
  }
  EXPECT_GT(model.space().maximum(largest), 0.01);
}

TEST(IntegratorTest, CollocatedAccelerationSatisfiesTheBalanceAtTheEndOfTheStep) {
  Simulation s(test::scene(block_2d(1.0) + time_integrator("Gautam-Sauer Composite", 0.05, 1)), world());
  for (int step = 0; step < 4; ++step) ASSERT_TRUE(s.integrator().step(0.05).converged);
  const Model& model = s.model();
  const std::vector<double>& a = s.integrator().acceleration();
  std::vector<double> inertia(a.size(), 0.0), force(a.size());
  model.mass()->multiply(a.data(), inertia.data());
  model.elastic_force({nullptr, nullptr, s.integrator().state().u.data()}, end_rule(), force.data());
  for (std::size_t i = 0; i < static_cast<std::size_t>(model.space().owned()); ++i)
    EXPECT_NEAR(inertia[i], -force[i], 1e-13);
}

TEST(IntegratorTest, EmptyRanksDoNoHarm) {
  // Four nodes: on six ranks, two are empty.
  const auto scene = test::scene(test::oscillator() + time_integrator("Bathe Composite", 0.1, 1));
  Simulation whole(scene, world());
  Simulation alone(scene, test::self());
  for (int step = 0; step < 10; ++step) {
    ASSERT_TRUE(whole.integrator().step(0.1).converged);
    ASSERT_TRUE(alone.integrator().step(0.1).converged);
  }
  EXPECT_LT(test::distance(test::gathered(whole.model(), whole.integrator().state().u),
                           test::gathered(alone.model(), alone.integrator().state().u)),
            1e-12);
}

TEST(IntegratorTest, AStepThatInvertsAnElementIsShortened) {
  // A block that contracts so fast that the first Newton step turns it inside out: only a shorter one can be evaluated.
  std::string body = block_2d(0.0);
  const std::string gradient = test::numbers("Velocity Gradient", {0.15, -0.0, 0.0, -0.05});
  ASSERT_NE(body.find(gradient), std::string::npos);
  body.replace(body.find(gradient), gradient.size(), test::numbers("Velocity Gradient", {-2.4, 0, 0, -2.4}));
  Simulation s(test::scene(body + time_integrator("Newmark", 0.4, 1)), world());
  const StepResult step = s.integrator().step(0.4);
  EXPECT_TRUE(step.converged) << step.reason;
}

TEST(IntegratorTest, TwoRanksMoveAsOne) {
  for (const std::string& body : {test::block_2d(1.0), test::block_3d(0.7)})
    for (const char* scheme : all_schemes) {
      const auto scene = test::scene(body + time_integrator(scheme, 0.05, 1));
      Simulation whole(scene, world());
      Simulation alone(scene, test::self());
      for (int step = 0; step < 10; ++step) {
        ASSERT_TRUE(whole.integrator().step(0.05).converged);
        ASSERT_TRUE(alone.integrator().step(0.05).converged);
      }
      EXPECT_LT(test::distance(test::gathered(whole.model(), whole.integrator().state().u),
                               test::gathered(alone.model(), alone.integrator().state().u)),
                1e-10)
          << scheme;
    }
}

}  // namespace
}  // namespace ixos
