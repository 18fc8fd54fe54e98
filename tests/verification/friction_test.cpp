// Friction with adhesion: closed forms, energy, and lives with rejected steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/traits.hpp"
#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/comparison.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"
#include "verification/taken_back.hpp"

namespace ixos {
namespace {

using test::list;
using test::number;
using test::numbers;
using test::word;

constexpr double equilibrium = 0.2547093, peak = 0.0624428, pi = 3.14159265358979;

std::string constant(double stress, const std::string& more = "") {
  return list("Friction", word("Type", "Constant Stress") + number("Stress", stress) + more);
}
std::string amontons(double coefficient, const std::string& more = "") {
  return list("Friction", word("Type", "Extended Amontons") + number("Coefficient", coefficient) + more);
}

/// `more`: a motion, or another obstacle, which then has its own place.
std::string wall(const std::string& friction, double gap = equilibrium, const std::string& more = "") {
  const bool flat = more.find("Obstacle") == std::string::npos;
  return list("Interactions",
              list("Wall", word("Side Set", "bottom") + (flat ? numbers("Point", {0, -gap}) : "") + friction + more));
}

/// A hard block of 2 by 1 L0 and mass 10 a unit of its bottom, which is guided along the wall.
std::string guided_block(const std::string& friction) {
  const std::string along = word("Components", "y");
  return list("Mesh", word("Type", "Box") + list("Box", numbers("Lengths", {2, 1})) +
                          list("Sets", list("all", word("Kind", "Nodes")))) +
         list("Materials", list("Steel", number("Young's Modulus", 1e5) + number("Density", 10))) + wall(friction) +
         list("Boundary Conditions",
              list("Bottom", word("Node Set", "bottom") + along) + list("Top", word("Node Set", "top") + along));
}

std::string moving(double speed) { return list("Initial Conditions", numbers("Velocity", {speed, 0})); }

double place(const Simulation& s) { return s.model().space().minimum(s.integrator().state().u[0]); }

double balance(const Simulation& s) {
  const State& state = s.integrator().state();
  return StateReport(s.model(), state).momenta().kinetic_energy + test::report_of(s).elastic_energy() +
         StateReport(s.model(), state).energy(Part::Interaction) - s.integrator().external_work() +
         s.integrator().dissipated_energy();
}

double friction_force(const Simulation& s) { return test::report_of(s).interaction("Wall").friction_force()[0]; }

// The spring of the surface, with eps = 50, adds tau/(2 eps) to the way m v^2/(2 tau), and then takes back a part of
// it.
TEST(FrictionTest, ABlockStopsWhereItsEnergyIsSpent) {
  const double mass = 10, speed = 0.02, stress = 0.02, stiffness = 50;
  const std::string friction = constant(stress, number("Stiffness", stiffness));
  for (const std::string& scheme : test::moving_schemes()) {
    if (scheme == "Central Difference") continue;  // 1e5 needs short steps
    SCOPED_TRACE(scheme);
    Simulation s(test::scene(guided_block(friction) + moving(speed) + test::time_integrator(scheme, 0.05, 15)),
                 test::world());
    const double first = balance(s);
    double farthest = 0;
    for (int n = 0; n < 300; ++n) {
      const StepResult result = s.integrator().step(0.05);
      ASSERT_TRUE(result.converged) << n << ": " << result.reason;
      farthest = std::max(farthest, place(s));
      if (scheme == "Average Vector Field" || scheme == "Energy-Momentum") {
        ASSERT_NEAR(balance(s), first, 1e-11 * 0.0155 * 2 + 1e-13) << n;
      }
    }
    // Collocation takes the force of the first step's end for the whole of it.
    const bool exact = scheme == "Average Vector Field" || scheme == "Energy-Momentum";
    EXPECT_NEAR(farthest, mass * speed * speed / (2 * stress) + stress / (2 * stiffness), exact ? 1e-5 : 5e-4);
    EXPECT_GT(place(s), farthest - 2.1 * stress / stiffness);
    EXPECT_NEAR(s.integrator().dissipated_energy(), mass * speed * speed, 0.01 * mass * speed * speed);
  }
}

// A block on a spring k that is pulled at the speed V. After the first slip the spring's force is F + V sqrt(k m)
// sin(omega t): no decay and no growth.
TEST(FrictionTest, TheSpringOfASteadilyPulledBlockSwingsAboutTheThreshold) {
  const double mass = 20, spring = 0.2, speed = 0.02, stress = 0.02, force = 2 * stress;
  const double omega = std::sqrt(spring / mass), swing = speed * std::sqrt(spring * mass);
  const std::string pull =
      list("Histories", test::expression("Pull", "0.02*t", "0.02", "0")) +
      list("Grips", list("Machine", word("Node Set", "all") + word("Type", "Springs") +
                                        test::texts("Translation", "{Pull, -}") + numbers("Stiffness", {spring, 0})));
  const double dt = 0.05, first_slip = force / (spring * speed);
  Simulation s(test::scene(guided_block(constant(stress, number("Stiffness", 500))) + pull +
                           test::time_integrator("Average Vector Field", dt, 200)),
               test::world());
  double lowest = force, highest = force, worst = 0;
  const double first = balance(s);
  while (s.integrator().time() < first_slip + 2.5 * 2 * pi / omega) {
    ASSERT_TRUE(s.integrator().step(dt).converged);
    const double time = s.integrator().time(), own = spring * (speed * time - place(s));
    if (time < first_slip) continue;
    lowest = std::min(lowest, own);
    highest = std::max(highest, own);
    worst = std::max(worst, std::abs(own - force - swing * std::sin(omega * (time - first_slip))));
    ASSERT_NEAR(balance(s), first, 1e-11 * (s.integrator().external_work() + 2 * 0.0155));
  }
  EXPECT_NEAR(highest, force + swing, 0.01 * swing);
  EXPECT_NEAR(lowest, force - swing, 0.01 * swing);
  EXPECT_LT(worst, 0.05 * swing);
}

TEST(FrictionTest, AContactWithoutLoadSlidesAtTheShareOfThePeak) {
  for (const char* threshold : {"Lagged", "Current"}) {
    Simulation s(test::scene(guided_block(amontons(0.5, word("Threshold", threshold))) + moving(0.5) +
                             test::time_integrator("Newmark", 0.05, 1)),
                 test::world());
    for (int n = 0; n < 10; ++n) ASSERT_TRUE(s.integrator().step(0.05).converged);
    EXPECT_NEAR(friction_force(s), -2 * 0.5 * peak, 1e-7);
  }
}

/// A soft block that falls on a wall or a sphere with its own spin and slides there.
std::string tumbling(const std::string& friction, const std::string& obstacle = "") {
  return list("Mesh",
              word("Type", "Box") + list("Box", numbers("Lengths", {2, 1}) + test::counts("Divisions", {4, 2}))) +
         list("Materials", list("Rubber", number("Poisson's Ratio", 0.3) + number("Density", 1))) +
         wall(friction, 0.4, obstacle) +
         list("Initial Conditions",
              numbers("Velocity", {0.1, -0.05}) + numbers("Velocity Gradient", {0, -0.02, 0.02, 0}));
}

const std::string frictions[] = {
    constant(0.03), constant(0.03, number("Sharpness", 50)), amontons(0.6), amontons(0.6, word("Threshold", "Current")),
    list("Friction", word("Type", "Smoothed") + number("Coefficient", 0.6) + number("Slip Speed", 0.05))};

// The interaction's own mean is exact with Interaction Points 0; friction is exact with Gauss points, too.
TEST(FrictionTest, TheBalanceOfATumblingBlockCloses) {
  const std::string sphere =
      word("Obstacle", "Sphere") + list("Sphere", number("Radius", 20) + numbers("Center", {1, -20.4}));
  const std::string moved =
      list("Histories", test::expression("Shake", "0.1*sin(t)", "0.1*cos(t)", "-0.1*sin(t)") +
                            test::expression("Tilt", "0.02*sin(2*t)", "0.04*cos(2*t)", "-0.08*sin(2*t)"));
  const std::string shift = test::texts("Translation", "{Shake, -}");
  const std::string exact = test::count("Elastic Points", 6) + test::count("Interaction Points", 0);
  for (const std::string& friction : frictions)
    for (const std::string& obstacle :
         {std::string(), sphere, list("Motion", shift), list("Motion", shift + word("Rotation", "Tilt"))}) {
      SCOPED_TRACE(friction + obstacle);
      Simulation s(
          test::scene(tumbling(friction, obstacle) + (obstacle.find("Motion") == std::string::npos ? "" : moved) +
                      test::time_integrator("Average Vector Field", 0.1, 100, exact)),
          test::world());
      const double first = balance(s);
      double lost = 0;
      for (int n = 1; n <= 100; ++n) {
        const StepResult result = s.integrator().step(0.1);
        ASSERT_TRUE(result.converged) << n << ": " << result.reason;
        EXPECT_GE(s.integrator().dissipated_energy(), lost);
        lost = s.integrator().dissipated_energy();
        ASSERT_NEAR(balance(s), first, 1e-9) << n;
      }
      EXPECT_GT(lost, 1e-4);
      EXPECT_EQ(s.model().dissipation_names(), (std::vector<std::string>{"friction of Wall"}));
    }
}

// A ring that widens on a wall: friction acts in the meridional plane, summed around the ring.
TEST(FrictionTest, TheBalanceOfARingCloses) {
  const std::string ring =
      list("Mesh",
           word("Type", "Box") + word("Geometry", "Axisymmetric") +
               list("Box", numbers("Lower", {1, 0}) + numbers("Lengths", {2, 1}) + test::counts("Divisions", {4, 2}))) +
      list("Materials", list("Rubber", number("Poisson's Ratio", 0.3) + number("Density", 1))) +
      wall(amontons(0.6), 0.26) + list("Initial Conditions", numbers("Velocity Gradient", {0.05, 0, 0, 0}));
  const std::string exact = test::count("Elastic Points", 6) + test::count("Interaction Points", 0);
  Simulation s(test::scene(ring + test::time_integrator("Average Vector Field", 0.1, 100, exact)), test::world());
  const double first = balance(s);
  for (int n = 1; n <= 100; ++n) {
    ASSERT_TRUE(s.integrator().step(0.1).converged) << n;
    ASSERT_NEAR(balance(s), first, 1e-9) << n;
  }
  EXPECT_GT(s.integrator().dissipated_energy(), 1e-3);
}

TEST(FrictionTest, StepsThatAreTakenBackLeaveNoSlip) {
  for (const std::string& scheme : {std::string("Average Vector Field"), std::string("Bathe Composite")})
    for (const std::string& friction : frictions) {
      SCOPED_TRACE(scheme + friction);
      Simulation s(test::scene(tumbling(friction) + test::time_integrator(scheme, 0.1, 20)), test::world());
      test::expect_no_slip_of_steps_taken_back(s, "Wall", 0.1, 0.3);
    }
}

// Without a threshold the motion does not change, to the last bit, and the columns and fields are there.
TEST(FrictionTest, AThresholdOfZeroDoesNotResist) {
  const auto end = [](const std::string& friction) {
    Simulation s(test::scene(tumbling(friction) + test::time_integrator("Average Vector Field", 0.1, 20)),
                 test::world());
    for (int n = 0; n < 20; ++n) EXPECT_TRUE(s.integrator().step(0.1).converged);
    EXPECT_EQ(has_friction(s.model(), "Wall"), !friction.empty());
    EXPECT_EQ(s.model().dissipation_names().empty(), friction.empty());
    return s.integrator().state().u;
  };
  const std::vector<double> without = end("");
  EXPECT_EQ(end(constant(0)), without);
  EXPECT_EQ(end(amontons(0)), without);
  EXPECT_NE(end(amontons(0.5)), without);
}

// Quasi-static slip: the force on a pad that is dragged is the threshold.
TEST(FrictionTest, APadThatIsDraggedSlowlySlides) {
  const std::string drag =
      list("Histories", test::expression("Drag", "0.1*t", "0.1", "0")) +
      list("Boundary Conditions",
           list("Top", word("Node Set", "top") + word("Components", "x") + word("History", "Drag")) +
               list("Lid", word("Node Set", "top") + word("Components", "y")));
  Simulation s(test::scene(list("Mesh", word("Type", "Box") + list("Box", numbers("Lengths", {4, 1}) +
                                                                              test::counts("Divisions", {8, 2}))) +
                           list("Materials", list("Rubber", number("Poisson's Ratio", 0.3))) + wall(constant(0.01)) +
                           drag + test::time_integrator("Static", 0.1, 20)),
               test::world());
  for (int n = 0; n < 50; ++n) {
    const StepResult result = s.integrator().step(0.1);
    ASSERT_TRUE(result.converged) << n << ": " << result.reason;
  }
  EXPECT_NEAR(friction_force(s), -4 * 0.01, 1e-12);
}

/// A soft block on a wall. Its top is drawn along x, or the wall the other way.
Simulation dragged(const std::string& friction, bool body_moves) {
  const std::string history =
      list("Histories", test::expression("Pull", "0.2*sin(t)", "0.2*cos(t)", "-0.2*sin(t)") +
                            test::expression("Draw", "-0.2*sin(t)", "-0.2*cos(t)", "0.2*sin(t)"));
  const std::string motion = body_moves ? "" : list("Motion", test::texts("Translation", "{Draw, -}"));
  return Simulation(
      test::scene(list("Mesh", word("Type", "Box") +
                                   list("Box", numbers("Lengths", {2, 1}) + test::counts("Divisions", {4, 2}))) +
                  list("Materials", list("Rubber", number("Poisson's Ratio", 0.3))) +
                  wall(friction, equilibrium, motion) + history +
                  list("Boundary Conditions", list("Top", word("Node Set", "top") + word("Components", "x") +
                                                              (body_moves ? word("History", "Pull") : "")) +
                                                  list("Lid", word("Node Set", "top") + word("Components", "y"))) +
                  test::time_integrator("Static", 0.1, 4)),
      test::world());
}

/// Returns the measure on which friction acts.
double expect_equal_reports(const Simulation& a, const Simulation& b) {
  const auto report = [](const Simulation& s) { return test::report_of(s).interaction("Wall").friction_report(); };
  const FrictionReport one = report(a), other = report(b);
  EXPECT_NEAR(one.mean_slip(), other.mean_slip(), 1e-7);
  EXPECT_NEAR(one.acting, other.acting, 1e-7);
  EXPECT_NEAR(one.sliding, other.sliding, 1e-7);
  EXPECT_NEAR(one.sticking, other.sticking, 1e-7);
  return one.acting;
}

// Friction depends on the motion of the body against the wall alone.
TEST(FrictionTest, ABodyPastAWallAndAWallPastABodyRubAlike) {
  for (const std::string& friction : frictions) {
    SCOPED_TRACE(friction);
    Simulation body = dragged(friction, true), wall = dragged(friction, false);
    for (int n = 0; n < 100; ++n) {
      for (Simulation* s : {&body, &wall}) {
        const StepResult result = s->integrator().step(0.03);
        ASSERT_TRUE(result.converged) << n << (s == &body ? " body: " : " wall: ") << result.reason;
      }
      ASSERT_NEAR(friction_force(body), friction_force(wall), 1e-8) << n;
    }
    EXPECT_GT(std::abs(friction_force(body)), 1e-3);
    EXPECT_GT(body.integrator().dissipated_energy(), 1e-3);
    EXPECT_NEAR(body.integrator().dissipated_energy(), wall.integrator().dissipated_energy(), 1e-8);
    for (const SurfaceNumber number : {SurfaceNumber::Slip, SurfaceNumber::Dissipated})
      EXPECT_LT(test::distance(test::report_of(body).interaction("Wall").mean(number),
                               test::report_of(wall).interaction("Wall").mean(number)),
                1e-7);
    EXPECT_GT(expect_equal_reports(body, wall), 0);
  }
}

// The wall turns with the body about a point beside both: nothing slips.
TEST(FrictionTest, AWallThatTurnsWithTheBodyDoesNotRub) {
  const std::string turn = list("Histories", test::expression("Turn", "0.3*sin(t)", "0.3*cos(t)", "-0.3*sin(t)"));
  const std::string about = numbers("Point", {1, 0.5}) + word("Rotation", "Turn");
  for (const std::string& friction : frictions) {
    SCOPED_TRACE(friction);
    Simulation s(
        test::scene(list("Mesh", word("Type", "Box") +
                                     list("Box", numbers("Lengths", {2, 1}) + test::counts("Divisions", {4, 2})) +
                                     list("Sets", list("all", word("Kind", "Nodes")))) +
                    list("Materials", list("Rubber", number("Poisson's Ratio", 0.3))) +
                    wall(friction, 0.26, list("Motion", about)) + turn +
                    list("Grips", list("Hand", word("Node Set", "all") + about)) +
                    test::time_integrator("Static", 0.1, 2)),
        test::world());
    for (int n = 0; n < 20; ++n) ASSERT_TRUE(s.integrator().step(0.1).converged) << n;
    EXPECT_LT(std::abs(friction_force(s)), 1e-12);
    EXPECT_LT(s.integrator().dissipated_energy(), 1e-25);
    for (double slip : test::report_of(s).interaction("Wall").mean(SurfaceNumber::Slip)) EXPECT_LT(slip, 1e-12);
  }
}

/// Returns a number of friction by node of the whole mesh.
std::vector<double> on_nodes(const Simulation& s, SurfaceNumber number) {
  const std::vector<double> means = test::report_of(s).interaction("Wall").mean(number);
  std::vector<double> local(static_cast<std::size_t>(s.model().space().local()), 0.0);
  for (std::size_t node = 0; node < means.size(); ++node) local[2 * node] = means[node];
  return test::gathered(s.model(), local);
}

// Runs the same scene on all ranks and on one.
TEST(FrictionTest, RanksAgree) {
  const std::string sphere =
      word("Obstacle", "Sphere") + list("Sphere", number("Radius", 20) + numbers("Center", {1, -20.4}));
  for (const std::string& friction : frictions)
    for (const std::string& obstacle : {std::string(), sphere}) {
      SCOPED_TRACE(friction + obstacle);
      const std::string scene = tumbling(friction, obstacle) + test::time_integrator("Average Vector Field", 0.1, 60);
      Simulation whole(test::scene(scene), test::world()), alone(test::scene(scene), test::self());
      double most = 0;
      for (int n = 0; n < 60; ++n) {
        ASSERT_TRUE(whole.integrator().step(0.1).converged);
        ASSERT_TRUE(alone.integrator().step(0.1).converged);
        most = std::max(most, expect_equal_reports(whole, alone));
      }
      EXPECT_GT(most, 0);
      EXPECT_GT(alone.integrator().dissipated_energy(), 1e-4);
      EXPECT_NEAR(whole.integrator().dissipated_energy(), alone.integrator().dissipated_energy(), 1e-9);
      EXPECT_NEAR(friction_force(whole), friction_force(alone), 1e-7);
      EXPECT_LT(test::distance(test::gathered(whole.model(), whole.integrator().state().u),
                               test::gathered(alone.model(), alone.integrator().state().u)),
                1e-7);
      for (const SurfaceNumber number : {SurfaceNumber::Slip, SurfaceNumber::Dissipated})
        EXPECT_LT(test::distance(on_nodes(whole, number), on_nodes(alone, number)), 1e-7);
    }
}

}  // namespace
}  // namespace ixos
