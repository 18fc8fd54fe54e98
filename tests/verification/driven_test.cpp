// Driven motion, loads, reactions and their work.
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "histories/waveform.hpp"
#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/comparison.hpp"
#include "support/refusal.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::list;
using test::number;
using test::numbers;
using test::word;
using test::world;

const char* const all_schemes[] = {"Newmark", "Bathe Composite", "Gautam-Sauer Composite", "Average Vector Field",
                                   "Energy-Momentum"};

/// A block of 3 by 2, density 1, E 1, of this law; what else the scene holds is given.
std::string block(const std::string& law, const std::string& damping = "") {
  return list("Mesh", word("Type", "Box") +
                          list("Box", numbers("Lengths", {3, 2}) + test::counts("Divisions", {3, 2})) +
                          list("Sets", list("all", word("Kind", "Nodes")))) +
         list("Materials",
              list("Rubber", word("Model", law) + number("Poisson's Ratio", 0.3) + number("Density", 1) + damping));
}

std::string driven(const std::string& name, const std::string& set, const std::string& components,
                   const std::string& history) {
  return list(
      name, word("Node Set", set) + word("Components", components) + (history.empty() ? "" : word("History", history)));
}

/// Sum of the reactions in direction i over all constrained degrees of freedom.
double reaction(const Simulation& s, std::size_t i) {
  const std::vector<double>& forces = s.integrator().state().reaction;
  double sum = 0;
  for (std::size_t dof = i; dof < forces.size(); dof += 2) sum += forces[dof];
  s.model().space().sum(&sum, 1);
  return sum;
}

// All nodes moved alike: nothing but inertia and mass-proportional damping resists.
TEST(DrivenTest, ReactionOfARigidMotionIsMassTimesAccelerationAndDamping) {
  const double m = 6, alpha = 0.4, dt = 0.05;
  const auto u = [](double t) { return 0.3 * std::sin(2 * t) + 0.1 * t * t; };
  const auto v = [](double t) { return 0.6 * std::cos(2 * t) + 0.2 * t; };
  const auto a = [](double t) { return -1.2 * std::sin(2 * t) + 0.2; };
  for (const char* scheme : all_schemes) {
    Simulation s(
        test::scene(block("Neo-Hooke", number("Mass Damping", alpha)) +
                    list("Histories",
                         test::expression("Shake", "0.3*sin(2*t)+0.1*t^2", "0.6*cos(2*t)+0.2*t", "-1.2*sin(2*t)+0.2")) +
                    list("Boundary Conditions", driven("Hold", "all", "y", "") + driven("Shake", "all", "x", "Shake")) +
                    test::time_integrator(scheme, dt, 2)),
        world());
    const bool collocates = std::string(scheme) == "Newmark" || std::string(scheme) == "Bathe Composite";
    double before = v(0);
    EXPECT_NEAR(reaction(s, 0), m * a(0) + alpha * m * v(0), 1e-12) << scheme;
    for (int n = 1; n <= 20; ++n) {
      const StepResult result = s.integrator().step(dt);
      ASSERT_TRUE(result.converged) << scheme << ": " << result.reason;
      const double t = n * dt, du = u(t) - u(t - dt);
      // Momentum form: the mean of the step, with the scheme's own velocity.
      const double after = 2 * du / dt - before;
      const double mean = m * (after - before) / dt + alpha * m * du / dt;
      EXPECT_NEAR(reaction(s, 0), collocates ? m * a(t) + alpha * m * v(t) : mean, 2e-11) << scheme << ", step " << n;
      EXPECT_NEAR(reaction(s, 1), 0, 1e-11);
      before = after;
    }
  }
}

// The program sets the same motion before each step. It sets a wrong one first, and the step is repeated.
TEST(DrivenTest, AMotionThatTheProgramSetsBeforeEachAttempt) {
  const double m = 6, dt = 0.05;
  const auto shake = [](double t) {
    return TimeValue{0.3 * std::sin(2 * t), 0.6 * std::cos(2 * t), -1.2 * std::sin(2 * t)};
  };
  for (const char* scheme : {"Newmark", "Bathe Composite", "Central Difference"}) {
    const auto motion = std::make_shared<Waveform>();
    motion->set(0, shake(0), dt, shake(dt));
    Simulation s(
        test::scene(block("Neo-Hooke") +
                    list("Boundary Conditions", driven("Hold", "all", "y", "") + driven("Shake", "all", "x", "Stage")) +
                    test::time_integrator(scheme, dt, 2)),
        world(), ".", {{"Stage", motion}});
    for (int n = 1; n <= 20; ++n) {
      const double t = n * dt;
      motion->set(t - dt, shake(t - dt), t, {1, 2, 3});
      ASSERT_TRUE(s.integrator().attempt(dt).converged) << scheme;
      motion->set(t - dt, shake(t - dt), t, shake(t));
      ASSERT_TRUE(s.integrator().step(dt).converged) << scheme;
      EXPECT_NEAR(reaction(s, 0), m * shake(t).acceleration, 2e-11) << scheme << ", step " << n;
      EXPECT_NEAR(s.integrator().state().u[0], shake(t).value, 1e-13);
    }
    const StepResult beyond = s.integrator().step(dt);
    EXPECT_FALSE(beyond.converged) << "the motion ends at the end of the last step";
    EXPECT_NE(beyond.reason.find("is not a finite number"), std::string::npos) << beyond.reason;
  }
}

TEST(DrivenTest, AHistoryThatNobodyGivesIsRefused) {
  const Teuchos::ParameterList scene =
      test::scene(block("Neo-Hooke") + list("Boundary Conditions", driven("Shake", "all", "x", "Stage")) +
                  test::time_integrator("Newmark", 0.1, 1));
  EXPECT_THROW(Simulation(scene, world()), InputError);
  EXPECT_THROW(Simulation(scene, world(), ".", {{"Stage", nullptr}}), InputError);
  EXPECT_THROW(Simulation(scene, world(), ".", {{"Table", constant(0)}}), InputError);
}

TEST(DrivenTest, AHistoryThatNoConditionNamesIsRefused) {
  const auto message = [](const std::string& condition) {
    const std::string scene =
        block("Neo-Hooke") +
        list("Histories", list("Stage", word("Type", "Constant") + list("Constant", number("Value", 0)))) +
        list("Boundary Conditions", condition) + test::time_integrator("Newmark", 0.1, 1);
    return test::refusal([&] { Simulation(test::scene(scene), world(), ".", {{"Stgae", constant(0)}}); });
  };
  EXPECT_EQ(message(driven("Shake", "all", "x", "Stage")),
            "the program gives the history \"Stgae\", which no condition names; did you mean \"Stage\"?");
  EXPECT_EQ(message(""), "the program gives the history \"Stgae\", which no condition names");
}

TEST(DrivenTest, TheEnergyBalanceCloses) {
  // A block on a shaking table above a wall that attracts it; undamped and damped.
  const std::string wall = list("Interactions", list("Wall", word("Side Set", "top") + numbers("Normal", {0, -1}) +
                                                                 numbers("Point", {0, 3}) + number("Gamma W", 2.0)));
  for (const std::string& damping : {std::string(), number("Mass Damping", 0.3) + number("Stiffness Damping", 0.05)})
    for (const char* scheme : {"Average Vector Field", "Energy-Momentum"}) {
      const std::string scene =
          block("Neo-Hooke", damping) + wall +
          list("Histories", test::expression("Shake", "0.2*(1-cos(3*t))", "0.6*sin(3*t)", "1.8*cos(3*t)") +
                                test::expression("Push", "0.05*sin(5*t)", "", "")) +
          list("Boundary Conditions", driven("Guide", "bottom", "y", "") + driven("Table", "bottom", "x", "Shake") +
                                          list("Wind", word("Type", "Traction") + word("Side Set", "left") +
                                                           numbers("Vector", {1, 0.3}) + word("History", "Push"))) +
          test::time_integrator(scheme, 0.05, 3);
      Simulation s(test::scene(scene), world());
      const double start = test::total_energy(s);
      double swing = 0;
      for (int n = 0; n < 60; ++n) {
        ASSERT_TRUE(s.integrator().step(0.05).converged);
        const double change = test::total_energy(s) - start;
        swing = std::max(swing, std::abs(change));
        EXPECT_NEAR(change, s.integrator().external_work() - s.integrator().dissipated_energy(), 1e-11);
      }
      EXPECT_GT(swing, 0.05);
      EXPECT_GT(std::abs(s.integrator().external_work()), 0.05);
      EXPECT_EQ(s.integrator().dissipated_energy() > 1e-3, !damping.empty());
    }
}

TEST(DrivenTest, OfLinearMaterialsNewmarkAndTheCompositeSchemeCloseTheBalanceToo) {
  for (const char* scheme : {"Newmark", "Gautam-Sauer Composite", "Average Vector Field", "Energy-Momentum", "Midpoint",
                             "Generalized-Alpha"}) {
    // Of generalized-alpha, the member without numerical damping.
    const std::string parameters =
        std::string(scheme) == "Generalized-Alpha" ? number("Spectral Radius", 1) : std::string();
    Simulation s(
        test::scene(block("Linear Elastic", number("Mass Damping", 0.1) + number("Stiffness Damping", 0.03)) +
                    list("Histories", test::expression("Shake", "0.2*sin(3*t)", "0.6*cos(3*t)", "-1.8*sin(3*t)")) +
                    list("Boundary Conditions",
                         driven("Guide", "bottom", "y", "") + driven("Table", "bottom", "x", "Shake") +
                             list("Weight", word("Type", "Body Force") + numbers("Vector", {0, -0.02}))) +
                    test::time_integrator(scheme, 0.07, 5, parameters)),
        world());
    const double start = test::total_energy(s);
    for (int n = 0; n < 70; ++n) {
      ASSERT_TRUE(s.integrator().step(0.07).converged);
      EXPECT_NEAR(test::total_energy(s) - start, s.integrator().external_work() - s.integrator().dissipated_energy(),
                  2e-12)
          << scheme << ", step " << n;
    }
    EXPECT_GT(std::abs(s.integrator().external_work()), 0.05);
  }
}

TEST(DrivenTest, BathesBalanceClosesToSecondOrder) {
  const auto error = [](double dt) {
    Simulation s(
        test::scene(block("Neo-Hooke") +
                    list("Histories", test::expression("Shake", "0.2*(1-cos(t))", "0.2*sin(t)", "0.2*cos(t)")) +
                    list("Boundary Conditions", driven("Table", "bottom", "xy", "Shake")) +
                    test::time_integrator("Bathe Composite", dt, 2)),
        world());
    const double start = test::total_energy(s);
    for (int n = 0; n < static_cast<int>(std::lround(2 / dt)); ++n) EXPECT_TRUE(s.integrator().step(dt).converged);
    return std::abs(test::total_energy(s) - start - s.integrator().external_work());
  };
  const double coarse = error(0.1), fine = error(0.05);
  EXPECT_GT(coarse / fine, 3.0) << coarse << " " << fine;
  EXPECT_LT(fine, 1e-4);
}

TEST(DrivenTest, AFreeBodyUnderItsWeightFalls) {
  for (const char* scheme : all_schemes) {
    Simulation s(test::scene(block("Neo-Hooke") +
                             list("Boundary Conditions",
                                  list("Weight", word("Type", "Body Force") + numbers("Vector", {0.1, -0.5}))) +
                             test::time_integrator(scheme, 0.1, 1)),
                 world());
    for (int n = 0; n < 10; ++n) ASSERT_TRUE(s.integrator().step(0.1).converged);
    const State& state = s.integrator().state();
    const Momenta momenta = StateReport(s.model(), state).momenta();
    EXPECT_NEAR(momenta.linear[0], 0.6, 1e-12) << scheme;
    EXPECT_NEAR(momenta.linear[1], -3.0, 1e-12) << scheme;
    for (std::size_t i = 1; i < state.u.size(); i += 2) ASSERT_NEAR(state.u[i], -0.25, 1e-12) << scheme;
    // m (g_x^2 + g_y^2) t^2/2, and no strain.
    EXPECT_NEAR(s.integrator().external_work(), 6 * 0.26 / 2, 1e-12) << scheme;
  }
}

TEST(DrivenTest, GravityAcceleratesABodyOfAnyDensity) {
  std::string heavy = block("Neo-Hooke");
  const std::string light = number("Density", 1);
  heavy.replace(heavy.find(light), light.size(), number("Density", 7));
  for (const std::string& chosen : {std::string(), word("Block", "body")}) {
    Simulation s(test::scene(heavy +
                             list("Boundary Conditions",
                                  list("Weight", word("Type", "Gravity") + numbers("Vector", {0.1, -0.5}) + chosen)) +
                             test::time_integrator("Newmark", 0.1, 1)),
                 world());
    for (int n = 0; n < 10; ++n) ASSERT_TRUE(s.integrator().step(0.1).converged);
    const State& state = s.integrator().state();
    for (std::size_t i = 1; i < state.u.size(); i += 2) ASSERT_NEAR(state.u[i], -0.25, 1e-12);
    EXPECT_NEAR(StateReport(s.model(), state).momenta().linear[0], 0.1 * 7 * 6, 1e-11);
  }
}

TEST(DrivenTest, PointForcesAndTractionsAddUp) {
  // On the left end 2 long, a traction of (0.3, 0) and on its 3 nodes forces of (0, 0.1): momentum is force times time.
  Simulation s(
      test::scene(block("Neo-Hooke") +
                  list("Boundary Conditions",
                       list("Wind", word("Type", "Traction") + word("Side Set", "left") + numbers("Vector", {0.3, 0})) +
                           list("Hands",
                                word("Type", "Point Force") + word("Node Set", "left") + numbers("Vector", {0, 0.1}))) +
                  test::time_integrator("Gautam-Sauer Composite", 0.1, 1)),
      world());
  for (int n = 0; n < 10; ++n) ASSERT_TRUE(s.integrator().step(0.1).converged);
  const State& state = s.integrator().state();
  const Momenta momenta = StateReport(s.model(), state).momenta();
  EXPECT_NEAR(momenta.linear[0], 0.6, 1e-11);
  EXPECT_NEAR(momenta.linear[1], 0.3, 1e-11);
}

TEST(DrivenTest, StaticReactionIsTheSlopeOfTheEnergy) {
  // A block glued to a wall by its bottom's interaction, its top pulled up.
  const std::string scene =
      block("Neo-Hooke") +
      list("Interactions",
           list("Wall", word("Side Set", "bottom") + numbers("Point", {0, -0.3}) + number("Gamma W", 2.0))) +
      list("Histories",
           list("Pull", word("Type", "Rate Ramp") + list("Rate Ramp", number("Rate", 0.1) + number("Length", 1.0)))) +
      list("Boundary Conditions", driven("Guide", "top", "x", "") + driven("Pull", "top", "y", "Pull")) +
      test::time_integrator("Static", 0.05, 3) + list("Nonlinear Solver", number("Tolerance", 1e-13));
  Simulation s(test::scene(scene), world());
  EXPECT_EQ(s.model().mass(), nullptr);
  std::vector<double> energy, force;
  for (int n = 0; n < 40; ++n) {
    const StepResult result = s.integrator().step(0.05);
    ASSERT_TRUE(result.converged) << result.reason;
    energy.push_back(test::total_energy(s));
    force.push_back(reaction(s, 1));
  }
  // At a constant rate of 0.1 the displacement grows by 0.005 a step.
  for (std::size_t n = 24; n + 1 < energy.size(); ++n) {
    const double slope = (energy[n + 1] - energy[n - 1]) / 0.01;
    EXPECT_NEAR(force[n], slope, 2e-3 * std::abs(force[n]) + 1e-6) << n;
  }
  EXPECT_GT(std::abs(force.back()), 1e-3);
}

}  // namespace
}  // namespace ixos
