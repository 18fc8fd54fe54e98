#include "time/integrator.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "model/term_sums.hpp"
#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/comparison.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::block_2d;
using test::time_integrator;
using test::world;

const char* const all_schemes[] = {
    "Newmark",   "Bathe Composite", "Gautam-Sauer Composite", "Average Vector Field", "Generalized-Alpha",
    "HHT-Alpha", "Midpoint"};

/// Presses the top of a 3 by 2 block down by 6 sin(2 pi t/80) between side walls that move with `history`. A step of 20
/// asks for a height of -4 at its end and of -1 in its middle. Between walls the area of the elements is then negative,
/// so some point is inverted whatever the other nodes do, and every scheme fails. A step of 0.02 moves the top by 0.01.
std::string press(const std::string& history = "") {
  const std::string motion = history.empty() ? "" : test::word("History", history);
  std::string conditions = test::list(
      "Press", test::word("Node Set", "top") + test::word("Components", "y") + test::word("History", "Press"));
  for (const char* side : {"left", "right"})
    conditions += test::list(side, test::word("Node Set", side) + test::word("Components", "x") + motion);
  return conditions;
}

const std::string pressing =
    test::list("Press", test::word("Type", "Sine") +
                            test::list("Sine", test::number("Amplitude", -6) + test::number("Frequency", 1.0 / 80)));
/// Saves the time of further iterations; the failure is certain.
const std::string few_iterations = test::list("Nonlinear Solver", test::count("Maximum Iterations", 10));

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
    const std::string floor = test::list("Floor", test::word("Node Set", "bottom") + test::word("Components", "y"));
    const auto scene =
        test::scene(block_2d(1.0) + time_integrator(scheme, 0.02, 1) + few_iterations +
                    test::list("Histories", pressing) + test::list("Boundary Conditions", floor + press()));
    Simulation disturbed(scene, world());
    Simulation smooth(scene, world());
    for (int step = 0; step < 5; ++step) {
      EXPECT_FALSE(disturbed.integrator().step(20).converged) << scheme;
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
  TermSums(model).force(Part::Elastic, {nullptr, nullptr, u.data()}, end_rule(), force.data());
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
  TermSums(model).force(Part::Elastic, {nullptr, nullptr, s.integrator().state().u.data()}, end_rule(), force.data());
  for (std::size_t i = 0; i < static_cast<std::size_t>(model.space().owned()); ++i)
    EXPECT_NEAR(inertia[i], -force[i], 1e-13);
}

TEST(IntegratorTest, StagesThatShareAPreconditionerSolveAsExactly) {
  // One factorisation of the first stage's first tangent serves both stages of all steps.
  const std::string body = block_2d(1.0) + time_integrator("Bathe Composite", 0.1, 1);
  const std::string kept = test::word("Linear Solver Type", "Belos") + test::word("Preconditioner Type", "Direct") +
                           test::list("Reuse", test::number("Setup Cost", 1e9));
  Simulation shared(test::scene(body + test::list("Linear Solver", kept)), world());
  Simulation direct(test::scene(body + test::list("Linear Solver", test::word("Linear Solver Type", "Direct"))),
                    world());
  EXPECT_EQ(shared.integrator().tangents(), 1U);
  for (int step = 0; step < 10; ++step) {
    ASSERT_TRUE(shared.integrator().step(0.1).converged);
    ASSERT_TRUE(direct.integrator().step(0.1).converged);
  }
  EXPECT_LT(test::distance(shared.integrator().state().u, direct.integrator().state().u), 1e-10);
}

TEST(IntegratorEmptyRanksTest, MoveAsOneRankDoes) {
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

/// A damped block on a shaking table below a wall that attracts it.
std::string shaken_block(const std::string& histories = "", const std::string& conditions = "") {
  std::string body = block_2d(0.0);
  body.insert(body.find(test::number("Density", 1)),
              test::number("Mass Damping", 0.1) + test::number("Stiffness Damping", 0.02));
  return body +
         test::list("Interactions",
                    test::list("Wall", test::word("Side Set", "top") + test::numbers("Normal", {0, -1}) +
                                           test::numbers("Point", {0, 2.6}) + test::number("Gamma W", 2.0) +
                                           test::word("Contact Element", "Q1C2"))) +
         test::list("Histories",
                    histories + test::list("Shake", test::word("Type", "Sine") +
                                                        test::list("Sine", test::number("Amplitude", 0.1) +
                                                                               test::number("Frequency", 0.4)))) +
         test::list("Boundary Conditions",
                    conditions +
                        test::list("Table", test::word("Node Set", "bottom") + test::word("History", "Shake")) +
                        test::list("Weight", test::word("Type", "Body Force") + test::numbers("Vector", {0, 0.01})));
}

TEST(IntegratorTest, AFailedStepChangesNoForceAndNoWorkEither) {
  for (const char* scheme : all_schemes)
    for (double large : {20.0, 25.0}) {
      const auto scene =
          test::scene(shaken_block(pressing, press("Shake")) + time_integrator(scheme, 0.01, 10) + few_iterations);
      Simulation disturbed(scene, world());
      Simulation smooth(scene, world());
      for (int step = 0; step < 4; ++step) {
        ASSERT_FALSE(disturbed.integrator().step(large).converged) << scheme;
        ASSERT_TRUE(disturbed.integrator().step(0.01).converged) << scheme;
        ASSERT_TRUE(smooth.integrator().step(0.01).converged) << scheme;
      }
      const State& one = disturbed.integrator().state();
      const State& two = smooth.integrator().state();
      EXPECT_EQ(one.u, two.u) << scheme;
      EXPECT_EQ(one.reaction, two.reaction) << scheme;
      EXPECT_EQ(one.load, two.load) << scheme;
      EXPECT_EQ(disturbed.integrator().external_work(), smooth.integrator().external_work()) << scheme;
      EXPECT_EQ(disturbed.integrator().dissipated_energy(), smooth.integrator().dissipated_energy()) << scheme;
    }
}

TEST(IntegratorTest, AllPredictorsLeadToOneMotion) {
  for (const char* scheme : all_schemes) {
    std::vector<double> first;
    for (const char* predictor : {"Last Displacement", "Constant Velocity", "Constant Acceleration", "Newmark",
                                  "Extrapolation", "Quadratic", "Nearest"}) {
      const std::string integrator = time_integrator(scheme, 0.05, 10);
      const std::string name = "<ParameterList name=\"Time Integrator\">";
      Simulation s(
          test::scene(shaken_block() + name + test::word("Predictor", predictor) + integrator.substr(name.size())),
          world());
      // The step changes on the way: an extrapolation has to know.
      for (double dt : {0.05, 0.05, 0.02, 0.08, 0.05}) ASSERT_TRUE(s.integrator().step(dt).converged) << predictor;
      const auto u = test::gathered(s.model(), s.integrator().state().u);
      if (first.empty()) first = u;
      EXPECT_LT(test::distance(u, first), 1e-9) << scheme << ", " << predictor;
    }
  }
}

TEST(IntegratorTest, NoxOwnLineSearchesDescendThePotential) {
  // A driven block, the step so large that prescribed values take a step of their own.
  for (const char* method : {"Backtrack"}) {
    const auto scene = test::scene(
        shaken_block() + time_integrator("Newmark", 0.2, 10) +
        test::list("Nonlinear Solver", test::list("NOX", test::list("Line Search", test::word("Method", method)))));
    const auto plain = test::scene(shaken_block() + time_integrator("Newmark", 0.2, 10));
    Simulation s(scene, world()), reference(plain, world());
    for (int n = 0; n < 5; ++n) {
      const StepResult result = s.integrator().step(0.2);
      ASSERT_TRUE(result.converged) << method << ": " << result.reason;
      ASSERT_TRUE(reference.integrator().step(0.2).converged);
    }
    EXPECT_LT(test::distance(s.integrator().state().u, reference.integrator().state().u), 1e-9) << method;
  }
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
