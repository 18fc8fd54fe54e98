// Damage of surfaces that goes on from a checkpoint.
#include <gtest/gtest.h>

#include <cmath>

#include "interaction/damage_law.hpp"
#include "run/restart_fixture.hpp"
#include "support/reports.hpp"

namespace ixos::test {
namespace {

const DamageLaw bond(0.5, 0.05, 0.8);

/// A block on a bond that breaks; `motion`: more lists, `law` and `wall`: more parameters.
std::string bonded(const std::string& motion, const std::string& integrator, const std::string& output,
                   const std::string& law = "", const std::string& wall = "") {
  return list("Mesh", word("Type", "Box") + list("Box", numbers("Lengths", {2, 1}) + counts("Divisions", {6, 1}))) +
         list("Materials", list("Rubber", number("Density", 1))) +
         list("Interactions",
              list("Bond", word("Side Set", "bottom") + word("Law", "Bilinear Damage") +
                               list("Bilinear Damage", number("Work of Adhesion", 0.02) + number("Strength", 0.05) +
                                                           number("Stiffness", 0.5) + law) +
                               wall)) +
         motion + list("Output", output) + list("Time Integrator", integrator);
}

TEST_F(RestartTest, DamageGoesOn) {
  const std::string leap = list("Initial Conditions", numbers("Velocity", {0.02, 0.2}));
  // With equal weights at both ends a step may take over the force at the end of the step before it, if that has not
  // changed since.
  const std::string equal_weights =
      word("Type", "Generalized-Alpha") + list("Generalized-Alpha", number("Spectral Radius", 1));
  for (const std::string& scheme : {word("Type", "Newmark"), word("Type", "Bathe Composite"), equal_weights,
                                    word("Type", "Average Vector Field"), word("Type", "Central Difference")}) {
    SCOPED_TRACE(scheme);
    const RunResult whole = expect_goes_on(bonded(leap, scheme + steps(0.05, 2), checkpoints(15, 100)), {15, 30});
    EXPECT_EQ(whole.status, RunStatus::Completed);
  }
}

// The first checkpoint finds points that wait for their bond, the second one bonds.
TEST_F(RestartTest, BondsOnTouchGoOn) {
  const std::string fall = list("Initial Conditions", numbers("Velocity", {0.02, -0.3}));
  const std::string on_touch = R"(<Parameter name="Bond on Touch" type="bool" value="true"/>)";
  for (const std::string& scheme : {word("Type", "Newmark"), word("Type", "Average Vector Field")}) {
    SCOPED_TRACE(scheme);
    const RunResult whole = expect_goes_on(
        bonded(fall, scheme + steps(0.05, 2), checkpoints(15, 100), on_touch, numbers("Point", {0, -0.3})), {15, 30});
    EXPECT_EQ(whole.status, RunStatus::Completed);
  }
}

TEST_F(RestartTest, DamageGoesOnInAnotherScene) {
  const std::string lift = word("Components", "y") + word("History", "Up");
  const std::string motion =
      list("Histories", expression("Up", "0.4*sin(t)", "0.4*cos(t)", "-0.4*sin(t)")) +
      list("Boundary Conditions", list("Bottom", word("Node Set", "bottom") + lift) +
                                      list("Top", word("Node Set", "top") + lift) +
                                      list("Guide", word("Node Set", "left") + word("Components", "x")));
  const auto scene = [&](double end) {
    return bonded(motion, word("Type", "Static") + steps(0.1, end), checkpoints(100, 1));
  };
  ASSERT_EQ(run_scene(scene(2.3), "whole").status, RunStatus::Completed);
  std::string other = scene(2.6);
  other.insert(other.find(number("Density", 1)), number("Poisson's Ratio", 0.1));
  Simulation simulation(test::scene(other), world());
  RunOptions options;
  options.folder = folder("other");
  options.restart = folder("whole");
  ASSERT_EQ(run(simulation, options).status, RunStatus::Completed);
  EXPECT_NEAR(test::report_of(simulation).interaction_report().force[1],
              2 * bond.at(0.4 * std::sin(1.6)).traction(0.4 * std::sin(2.6))[0], 1e-13);
  EXPECT_NEAR(simulation.integrator().dissipated_energy(),
              2 * bond.dissipated(bond.adhesion_gap(), 0.4 * std::sin(1.6))[0], 1e-13);
}

}  // namespace
}  // namespace ixos::test
