// Bodies of each law of rubber: what schemes conserve, in every element, with and without a matrix.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "scene/simulation.hpp"
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

const std::vector<std::string> laws{"Mooney-Rivlin", "Yeoh", "Gent", "Ogden"};
const std::vector<std::string> formulations{"Standard", "Mean Dilatation", "Enhanced"};

/// Returns a free block that translates, spins and stretches; strains reach 0.3 on the time scale 1.
std::string block(int dimension, const std::string& law, const std::string& more = "") {
  const bool plane = dimension == 2;
  const std::string box =
      plane ? numbers("Lengths", {3, 2}) + test::counts("Divisions", {3, 2})
            : test::count("Dimension", 3) + numbers("Lengths", {2, 1, 1}) + test::counts("Divisions", {2, 1, 1});
  return list("Mesh", word("Type", "Box") + list("Box", box)) +
         list("Materials", list("Rubber", word("Model", law) + number("Density", 1) + more)) +
         list("Initial Conditions", plane ? numbers("Velocity Gradient", {0.15, -1, 1, -0.05})
                                          : numbers("Velocity Gradient", {0.1, -1, 0.5, 1, 0, -0.3, -0.5, 0.3, -0.1}));
}

Momenta momenta(const Simulation& s) { return test::report_of(s).momenta(); }

TEST(RubberTest, EnergyMomentumKeepsEnergyAndMomenta) {
  for (const std::string& law : laws)
    for (const int dimension : {2, 3}) {
      Simulation s(test::scene(block(dimension, law) + test::time_integrator("Energy-Momentum", 0.1, 10)), world());
      const double energy = test::total_energy(s);
      const Momenta before = momenta(s);
      double stored = 0;
      for (int step = 0; step < 40; ++step) {
        ASSERT_TRUE(s.integrator().step(0.1).converged) << law;
        stored = std::max(stored, test::report_of(s).energy(Part::Elastic));
      }
      EXPECT_GT(stored, 0.01 * energy) << law;
      EXPECT_NEAR(test::total_energy(s), energy, 1e-11 * energy) << law;
      const Momenta after = momenta(s);
      for (std::size_t i = 0; i < before.angular.size(); ++i)
        EXPECT_NEAR(after.angular[i], before.angular[i], 1e-11) << law;
      for (std::size_t i = 0; i < before.linear.size(); ++i)
        EXPECT_NEAR(after.linear[i], before.linear[i], 1e-11) << law;
    }
}

TEST(RubberTest, AverageVectorFieldKeepsTheEnergyOfEveryElement) {
  const std::string points = test::count("Elastic Points", 6);
  for (const std::string& law : laws)
    for (const std::string& formulation : formulations)
      for (const int dimension : {2, 3}) {
        Simulation s(test::scene(block(dimension, law, word("Element Formulation", formulation)) +
                                 test::time_integrator("Average Vector Field", 0.05, 10, points)),
                     world());
        const double energy = test::total_energy(s);
        for (int step = 0; step < 10; ++step) ASSERT_TRUE(s.integrator().step(0.05).converged) << law << formulation;
        EXPECT_NEAR(test::total_energy(s), energy, 1e-11 * energy) << law << formulation;
      }
}

/// The products have single precision, which Newton's method corrects.
TEST(RubberTest, AMatrixIsNotNeeded) {
  for (const std::string& law : laws) {
    std::vector<std::vector<double>> ends;
    for (const char* kind : {"Assembled", "Matrix-Free"}) {
      const std::string solver =
          list("Linear Solver",
               word("Linear Solver Type", "Belos") + word("Preconditioner Type", "Chebyshev") + word("Operator", kind));
      Simulation s(test::scene(block(3, law, number("Stiffness Damping", 0.01)) +
                               test::time_integrator("Newmark", 0.1, 10) + solver),
                   world());
      for (int step = 0; step < 10; ++step) ASSERT_TRUE(s.integrator().step(0.1).converged) << law << kind;
      ends.push_back(s.integrator().state().u);
    }
    for (std::size_t i = 0; i < ends[0].size(); ++i) EXPECT_NEAR(ends[0][i], ends[1][i], 1e-8) << law;
  }
}

/// A ring between the radii 0.5 and 1.5.
TEST(RubberTest, BodiesOfRevolutionKeepTheirEnergy) {
  const std::vector<std::string> schemes{"Energy-Momentum", "Average Vector Field"};
  for (const std::string& law : laws)
    for (const std::string& formulation : formulations)
      for (const std::string& scheme : schemes) {
        if (scheme == "Energy-Momentum" && formulation != "Standard") continue;
        const std::string points = test::count("Elastic Points", 6);
        Simulation s(
            test::scene(list("Mesh", word("Type", "Box") + word("Geometry", "Axisymmetric") +
                                         list("Box", numbers("Lower", {0.5, 0}) + numbers("Lengths", {1, 1}) +
                                                         test::counts("Divisions", {2, 2}))) +
                        list("Materials", list("Rubber", word("Model", law) + number("Density", 1) +
                                                             word("Element Formulation", formulation))) +
                        list("Initial Conditions", numbers("Velocity Gradient", {0.3, 0, 0, -0.2})) +
                        test::time_integrator(scheme, 0.05, 10, scheme == "Average Vector Field" ? points : "")),
            world());
        const double start = test::total_energy(s);
        for (int step = 0; step < 20; ++step) ASSERT_TRUE(s.integrator().step(0.05).converged) << law << scheme;
        EXPECT_NEAR(test::total_energy(s), start, 1e-11 * start) << law << formulation << scheme;
      }
}

/// The block is pulled between sides that hold its width. At the stretch l of F = diag(1, l, 1) the invariant is I1 - 3
/// = t^2 + 2/t - 3 with t = l^(2/3): 7/12 at t = 3/2, l = 1.8371.
TEST(RubberTest, AStepBeyondGentsLimitFails) {
  const auto held = [](const std::string& side) {
    return list(side, word("Node Set", side) + word("Components", "x"));
  };
  const std::string pulled =
      list("Mesh", word("Type", "Box") + list("Box", numbers("Lengths", {1, 1}) + test::counts("Divisions", {2, 2}))) +
      list("Materials", list("Rubber", word("Model", "Gent") + list("Gent", number("Limit", 7.0 / 12)))) +
      list("Histories",
           list("Pull", word("Type", "Rate Ramp") + list("Rate Ramp", number("Rate", 1.0) + number("Length", 1e-9)))) +
      list("Boundary Conditions",
           list("Base", word("Node Set", "bottom")) + held("left") + held("right") +
               list("Pull", word("Node Set", "top") + word("Components", "y") + word("History", "Pull")));
  const double limit = std::pow(1.5, 1.5) - 1;
  for (const auto& [step, admissible] : {std::pair{limit * 0.999, true}, std::pair{limit * 1.001, false}}) {
    Simulation s(test::scene(pulled + test::time_integrator("Static", 0.1, 20)), world());
    for (int k = 0; k < 8; ++k) ASSERT_TRUE(s.integrator().step(0.1).converged) << k;
    const StepResult result = s.integrator().step(step - 0.8);
    EXPECT_EQ(result.converged, admissible) << result.reason;
    if (!admissible) test::expect_contains(result.reason, "at every step length tried an element inverts");
  }
}

}  // namespace
}  // namespace ixos
