// Friction between two bodies: closed forms, conservation, the rigid wall, and lives with rejected steps.
#include <gtest/gtest.h>

#include <cmath>

#include "support/bodies.hpp"
#include "support/refusal.hpp"
#include "support/reports.hpp"
#include "verification/collision.hpp"
#include "verification/taken_back.hpp"

namespace ixos {
namespace {

using test::Collision;
using test::count;
using test::list;
using test::number;
using test::numbers;
using test::word;

constexpr double equilibrium = 0.2547093, work_of_adhesion = 0.01549567;

std::string constant(double stress, const std::string& more = "") {
  return list("Friction", word("Type", "Constant Stress") + number("Stress", stress) + more);
}
std::string amontons(double coefficient) {
  return list("Friction", word("Type", "Extended Amontons") + number("Coefficient", coefficient));
}

/// A block of 2 by 1 on one of 6 by 1.
std::string blocks(const std::string& material) {
  const auto block = [](const std::string& name, const std::vector<double>& lower, double length, int cells) {
    return list(name, word("Type", "Box") + list("Box", numbers("Lower", lower) + numbers("Lengths", {length, 1}) +
                                                            test::counts("Divisions", {cells, 2})));
  };
  return list("Mesh", word("Type", "Parts") +
                          list("Parts", block("low", {-1, -1 - equilibrium}, 6, 9) + block("high", {0, 0}, 2, 4)) +
                          list("Sets", list("all", word("Kind", "Nodes")))) +
         list("Materials",
              list("Low", word("Block", "low_body") + material) + list("High", word("Block", "high_body") + material));
}

std::string pair(const std::string& friction) {
  return list("Interactions", list("Pair", word("Side Set", "high_bottom") + word("Primary Side Set", "low_top") +
                                               word("Smoothing", "None") + friction));
}

/// The mean displacement along x of the nodes above y = 0, or of those below it.
double mean_place(const Simulation& s, bool above) {
  const LocalMesh& mesh = s.model().mesh();
  double sums[2] = {0, 0};
  for (std::size_t k = 0; k < static_cast<std::size_t>(2 * mesh.owned_nodes); k += 2)
    if ((mesh.coordinates[k + 1] >= 0) == above) {
      sums[0] += s.integrator().state().u[k];
      sums[1] += 1;
    }
  s.model().space().sum(sums, 2);
  return sums[0] / sums[1];
}

double balance(const Simulation& s) { return test::total_energy(s) + s.integrator().dissipated_energy(); }

// Masses 20 and 60, of which 15 is the reduced one: they slide by half of it times the speed squared over the force.
// The spring adds tau/(2 eps) and then takes back a part of it.
TEST(PairFrictionTest, FreeBlocksComeToRestOnEachOther) {
  const double reduced = 15, speed = 0.02, stress = 0.02, stiffness = 50;
  const std::string guide = list("Boundary Conditions", list("All", word("Node Set", "all") + word("Components", "y")));
  const std::string fast =
      list("Initial Conditions", list("High", test::texts("Blocks", "{high_body}") + numbers("Velocity", {speed, 0})));
  for (const std::string& scheme : test::moving_schemes()) {
    if (scheme == "Central Difference") continue;  // 1e5 needs short steps
    SCOPED_TRACE(scheme);
    const bool exact = scheme == "Average Vector Field" || scheme == "Energy-Momentum";
    Simulation s(
        test::scene(blocks(number("Young's Modulus", 1e5) + number("Density", 10)) +
                    pair(constant(stress, number("Stiffness", stiffness))) + guide + fast +
                    test::time_integrator(scheme, 0.05, 15,
                                          scheme == "Average Vector Field" ? count("Interaction Points", 2) : "")),
        test::world());
    const double first = balance(s);
    double farthest = 0;
    for (int n = 0; n < 240; ++n) {
      const StepResult result = s.integrator().step(0.05);
      ASSERT_TRUE(result.converged) << n << ": " << result.reason;
      farthest = std::max(farthest, mean_place(s, true) - mean_place(s, false));
      if (exact) {
        ASSERT_NEAR(balance(s), first, 1e-9) << n;
      }
    }
    EXPECT_NEAR(farthest, reduced * speed * speed / (2 * 2 * stress) + stress / (2 * stiffness), exact ? 1e-5 : 4e-4);
    EXPECT_NEAR(s.integrator().dissipated_energy(), reduced * speed * speed / 2, 0.01 * reduced * speed * speed / 2);
    const Momenta momenta = test::report_of(s).momenta();
    EXPECT_NEAR(momenta.linear[0], 20 * speed, 1e-11);
  }
}

/// A soft block that is dragged over a body that does not move, and over a wall.
TEST(PairFrictionTest, ABodyThatDoesNotMoveIsTheWall) {
  const std::string drag = list("Histories", test::expression("Drag", "0.2*sin(t)", "0.2*cos(t)", "-0.2*sin(t)"));
  const std::string lid =
      list("Top", word("Node Set", "high_top") + word("Components", "x") + word("History", "Drag")) +
      list("Lid", word("Node Set", "high_top") + word("Components", "y"));
  const std::string fixed = list("Fixed", word("Node Set", "low_all"));
  const std::string sets = list("Sets", list("low_all", word("Kind", "Nodes") + numbers("Upper", {9, -0.1})));
  for (const std::string& friction :
       {constant(0.03), constant(0.03, number("Sharpness", 50)), amontons(0.6),
        list("Friction", word("Type", "Smoothed") + number("Coefficient", 0.6) + number("Slip Speed", 0.05))}) {
    SCOPED_TRACE(friction);
    const auto simulate = [&](const std::string& interaction) {
      std::string text = blocks(number("Poisson's Ratio", 0.3)) + interaction + drag +
                         list("Boundary Conditions", lid + fixed) + test::time_integrator("Static", 0.03, 4);
      text.insert(text.find("<ParameterList name=\"all\""),
                  sets.substr(sets.find('>') + 1, sets.rfind('<') - sets.find('>') - 1));
      return Simulation(test::scene(text), test::world());
    };
    Simulation body = simulate(pair(friction)),
               wall = simulate(list("Interactions", list("Pair", word("Side Set", "high_bottom") +
                                                                     numbers("Point", {0, -equilibrium}) + friction)));
    const auto force = [](const Simulation& s) { return test::report_of(s).interaction("Pair").friction_force()[0]; };
    double largest = 0;
    for (int n = 0; n < 100; ++n) {
      for (Simulation* s : {&body, &wall}) {
        const StepResult result = s->integrator().step(0.03);
        ASSERT_TRUE(result.converged) << n << (s == &body ? " body: " : " wall: ") << result.reason;
      }
      ASSERT_NEAR(force(body), force(wall), 1e-8) << n;
      largest = std::max(largest, std::abs(force(body)));
    }
    EXPECT_GT(largest, 1e-3);
    EXPECT_GT(body.integrator().dissipated_energy(), 1e-3);
    EXPECT_NEAR(body.integrator().dissipated_energy(), wall.integrator().dissipated_energy(), 1e-8);
  }
}

const std::string rubbing = amontons(0.5);
const std::string exact = count("Interaction Points", 8) + count("Elastic Points", 4);

/// The angular momentum changes by the moment about the places of a step's start, beside the error of the scheme.
TEST(PairFrictionTest, DisksThatRubKeepEnergyAndMomenta) {
  const double dt = 0.001;
  Collision collision("Average Vector Field", dt, exact, rubbing), smooth("Average Vector Field", dt, exact);
  const Momenta before = collision.momenta();
  const double first = balance(collision.simulation());
  double energy = 0, least = 1;
  for (int step = 0; step < 60; ++step) {
    const StepResult result = collision.simulation().integrator().step(dt);
    ASSERT_TRUE(result.converged) << step << ": " << result.reason;
    ASSERT_TRUE(smooth.simulation().integrator().step(dt).converged) << step;
    energy = std::max(energy, std::abs(balance(collision.simulation()) - first));
    least = std::min(least, collision.least_gap());
  }
  EXPECT_LT(energy, 1e-6 * work_of_adhesion);
  EXPECT_GT(collision.simulation().integrator().dissipated_energy(), 1e-3 * work_of_adhesion);
  EXPECT_LT(test::distance(collision.momenta().linear, before.linear), 1e-12 * before.kinetic_energy);
  EXPECT_LT(least, 0.25);
  const double size = std::abs(before.angular[0]);
  EXPECT_LT(test::distance(collision.momenta().angular, before.angular), 2e-3 * size);
  // Friction changes the disks' spins.
  EXPECT_GT(test::distance(collision.simulation().integrator().state().u, smooth.simulation().integrator().state().u),
            1e-4);
}

/// A cube slides over a plate, and both turn about an oblique axis. The discrete gradient closes the energy balance and
/// keeps both momenta: friction adds no moment, since the plate's surface has no kinks where the cube slides.
TEST(PairFrictionTest, BoxesThatRubAndTurnInSpaceKeepEnergyAndMomenta) {
  const auto box = [](const std::string& name, const std::vector<double>& lower, double width, int cells) {
    return list(name, word("Type", "Box") + list("Box", count("Dimension", 3) + numbers("Lower", lower) +
                                                            numbers("Lengths", {width, width, 1}) +
                                                            test::counts("Divisions", {cells, cells, 1})));
  };
  const auto motion = [](const std::string& name, const std::string& block, const std::vector<double>& velocity) {
    return list(name, test::texts("Blocks", "{" + block + "}") + numbers("Velocity", velocity) +
                          numbers("Angular Velocity", {0.03, 0.05, 0.08}) + numbers("Origin", {0.5, 0.5, 0}));
  };
  const std::string material = number("Poisson's Ratio", 0.3) + number("Density", 1);
  Simulation s(
      test::scene(
          list("Mesh", word("Type", "Parts") +
                           list("Parts", box("low", {-1, -1, -1 - equilibrium}, 3, 3) + box("high", {0, 0, 0}, 1, 2))) +
          list("Materials", list("Low", word("Block", "low_body") + material) +
                                list("High", word("Block", "high_body") + material)) +
          list("Interactions", list("Pair", word("Side Set", "high_bottom") + word("Primary Side Set", "low_top") +
                                                constant(0.02, number("Stiffness", 5)))) +
          list("Initial Conditions",
               motion("Low", "low_body", {0, 0, 0}) + motion("High", "high_body", {0.1, 0.05, 0})) +
          test::time_integrator("Energy-Momentum", 0.05, 3)),
      test::world());
  const auto momenta = [&] { return test::report_of(s).momenta(); };
  const Momenta before = momenta();
  const double first = balance(s);
  for (int step = 0; step < 40; ++step) {
    const StepResult result = s.integrator().step(0.05);
    ASSERT_TRUE(result.converged) << step << ": " << result.reason;
    ASSERT_NEAR(balance(s), first, 1e-8 * before.kinetic_energy) << step;
  }
  EXPECT_GT(s.integrator().dissipated_energy(), 1e-4);
  EXPECT_LT(test::distance(momenta().linear, before.linear), 1e-10);
  EXPECT_LT(test::distance(momenta().angular, before.angular), 1e-8);
}

TEST(PairFrictionTest, StepsThatAreTakenBackLeaveNoSlip) {
  for (const char* scheme : {"Average Vector Field", "Bathe Composite", "Newmark"}) {
    Collision collision(scheme, 0.001, scheme[0] == 'A' ? exact : "", rubbing);
    SCOPED_TRACE(scheme);
    test::expect_no_slip_of_steps_taken_back(collision.simulation(), "Pair", 0.001, 0.0015);
  }
}

TEST(PairFrictionTest, WhatIsNotThereIsRefused) {
  const auto refused = [](const std::string& pair) {
    return test::refusal([&] { Collision("Newmark", 0.001, "", pair); });
  };
  EXPECT_NE(refused(rubbing + word("Passes", "Two Without Reaction")).find("Friction/Type"), std::string::npos);
  EXPECT_NE(refused(list("Friction",
                         word("Type", "Extended Amontons") + number("Coefficient", 0.5) + word("Threshold", "Current")))
                .find("Friction/Threshold"),
            std::string::npos);
}

}  // namespace
}  // namespace ixos
