// A ball of revolution on a wall, as a scene.
#include <gtest/gtest.h>

#include <cmath>

#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/comparison.hpp"
#include "support/refusal.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::world;
using Assignments = std::vector<std::string>;

/// The ball of xml/ball.xml as a body of revolution, with assignments as on the command line.
Teuchos::ParameterList ball(Assignments more = {}) {
  more.insert(more.begin(), {"Mesh/Geometry=Axisymmetric", "Mesh/Disk/Half=true"});
  return test::scene_file("ball.xml", more);
}

std::string refusal(const Assignments& more) {
  return test::refusal([&] { const Simulation s(ball(more), world()); });
}

// Conservation of the sum of energies: the force is the gradient of the energy of the whole body.
TEST(AxisymmetricBall, EnergyIsKeptByTheSchemesThatKeepIt) {
  const std::string material = "Materials/Ball/";
  const std::vector<Assignments> cases = {
      {"Time Integrator/Average Vector Field/Elastic Points=8"},
      {"Time Integrator/Average Vector Field/Elastic Points=8", material + "Element Formulation=Mean Dilatation"},
      {"Time Integrator/Average Vector Field/Elastic Points=8", material + "Element Formulation=Enhanced"},
      {"Time Integrator/Average Vector Field/Elastic Points=8", material + "Model=Saint Venant-Kirchhoff"},
      {"Time Integrator/Average Vector Field/Elastic Points=8", "Interactions/Wall/Contact Element=Q1C3"},
      {"Time Integrator/Type=Energy-Momentum"}};
  for (const Assignments& more : cases) {
    Simulation s(ball(more), world());
    const double start = test::total_energy(s);
    for (int step = 0; step < 60; ++step) ASSERT_TRUE(s.integrator().step(0.001).converged) << more.back();
    EXPECT_NEAR(test::total_energy(s), start, 1e-11 * std::abs(start)) << more.back();
    // The body started at rest: the impulse of the wall is the axial momentum.
    const State& state = s.integrator().state();
    const Momenta momenta = StateReport(s.model(), state).momenta();
    EXPECT_LT(momenta.linear[1], -1e-6) << more.back();
    EXPECT_EQ(momenta.linear[0], 0);
    EXPECT_EQ(momenta.angular[0], 0);
  }
}

TEST(AxisymmetricBall, EverySchemeMovesIt) {
  for (const std::string& scheme : test::moving_schemes()) {
    Simulation s(ball({"Time Integrator/Type=" + scheme, "Time Integrator/Time Step Control/Time Step=1e-4"}), world());
    for (int step = 0; step < 10; ++step) ASSERT_TRUE(s.integrator().step(1e-4).converged) << scheme;
    const std::vector<double>& u = s.integrator().state().u;
    const LocalMesh& mesh = s.model().mesh();
    for (std::size_t k = 0; k < u.size(); k += 2)
      if (mesh.coordinates[k] == 0) {
        EXPECT_EQ(u[k], 0) << scheme;
      }
  }
}

TEST(AxisymmetricBall, WhatBreaksTheSymmetryIsRefused) {
  test::expect_contains(
      test::refusal([] { const Simulation s(test::scene_file("ball.xml", {"Mesh/Geometry=Axisymmetric"}), world()); }),
      "Mesh: node 1 at (-2, 5.25471) is beyond the axis");
  test::expect_contains(refusal({"Initial Conditions/Velocity={1, 0}"}),
                        "Initial Conditions/Velocity: the radial component 1");
  test::expect_contains(refusal({"Interactions/Wall/Half-Space/Normal={0.1, 1}"}), "Interactions/Wall");
  test::expect_contains(refusal({"Linear Solver/Linear Solver Type=Belos", "Linear Solver/Operator=Matrix-Free"}),
                        "is not offered for Mesh/Geometry \"Axisymmetric\"");
}

TEST(AxisymmetricBall, UnitsAreThoseOfTheWholeBody) {
  const Simulation s(ball(), world());
  for (const ResultUnit& unit : s.result_units())
    if (unit.quantity == "force") {
      EXPECT_EQ(unit.expression, "E0 L0^2");
    }
}

}  // namespace
}  // namespace ixos
