// The paper's ball: energies against closed forms and conservation laws, and agreement of ranks, solvers and meshes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "interaction/van_der_waals.hpp"
#include "io/exodus_mesh.hpp"
#include "mesh/generators/shapes.hpp"
#include "scene/simulation.hpp"
#include "support/comparison.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::world;

/// Returns the integral of psi over the gap.
double integrated_energy(const VanDerWaals& law, double y) {
  return -law.c1() / (56 * std::pow(y, 7)) + law.c2() / (2 * y);
}

/// Returns the interaction energy of a regular polygon of 16 sides whose lowest corner has this gap. Along a straight
/// side the mean of psi(y) is the change of its integral over the change of y.
double polygon_energy(const VanDerWaals& law, double radius, double gap) {
  double energy = 0;
  for (int k = 0; k < 16; ++k) {
    const double y0 = gap + radius * (1 - std::cos(M_PI / 8 * k)),
                 y1 = gap + radius * (1 - std::cos(M_PI / 8 * (k + 1)));
    energy += 2 * radius * std::sin(M_PI / 16) * (integrated_energy(law, y1) - integrated_energy(law, y0)) / (y1 - y0);
  }
  return energy;
}

/// Returns the largest |E - E_0| of a run on this rank alone.
double energy_error(const std::string& scheme, double dt, int steps) {
  Simulation s(test::scene_file("ball.xml", {"Time Integrator/Type=" + scheme}), test::self());
  const double before = test::total_energy(s);
  double largest = 0;
  for (int step = 0; step < steps; ++step) {
    const StepResult result = s.integrator().step(dt);
    EXPECT_TRUE(result.converged) << scheme << ", step " << step << ": " << result.reason;
    if (!result.converged) break;
    largest = std::max(largest, std::abs(test::total_energy(s) - before));
  }
  return largest;
}

const VanDerWaals wall(2.5, 25);
const double start_gap = 2 + wall.equilibrium_gap();
/// 1e-8 of the energy at the start.
const double held = 1e-8 * std::abs(polygon_energy(wall, 5, start_gap));

TEST(BallSerialTest, StartsWithTheInteractionEnergyOfItsPolygon) {
  const Simulation s(test::scene_file("ball.xml"), test::self());
  const double expected = polygon_energy(wall, 5, start_gap);
  EXPECT_NEAR(test::total_energy(s), expected, 1e-8 * std::abs(expected));
}

// The ball first touches the wall at 0.28.
TEST(BallSerialTest, NewmarksEnergyErrorIsOfSecondOrderBeforeTheFirstImpact) {
  const double coarse = energy_error("Newmark", 0.001, 250), fine = energy_error("Newmark", 0.0005, 500);
  EXPECT_NEAR(coarse / fine, 4, 0.4);
  EXPECT_GT(coarse, 1e3 * energy_error("Average Vector Field", 0.001, 250));
}

TEST(BallSerialTest, EnergyMomentumHoldsTheEnergyThroughImpacts) {
  EXPECT_LT(energy_error("Energy-Momentum", 0.001, 1500), held);
}

TEST(BallLongTest, ConservingSchemesHoldTheEnergyForTenThousandSteps) {
  for (const char* scheme : {"Average Vector Field", "Energy-Momentum"})
    EXPECT_LT(energy_error(scheme, 0.001, 10000), held) << scheme;
}

// The motion is chaotic: a rounding error of 1e-16 is 1e-10 after the first impact.
TEST(BallTest, RanksSolversAndMeshFilesMoveAsOneThroughTheFirstImpact) {
  const std::string mesh = testing::TempDir() + "ball.e";
  if (world()->getRank() == 0) {
    DiskShape shape;
    shape.center = {0, 7 + VanDerWaals(2.5, 25).equilibrium_gap()};
    write_exodus_mesh(disk(shape), mesh, "ball");
  }
  world()->barrier();
  const struct {
    const char* scheme;
    std::vector<std::string> settings;
  } cases[] = {{"Newmark", {}},
               {"Bathe Composite", {}},
               {"Gautam-Sauer Composite", {}},
               {"Average Vector Field", {}},
               {"Gautam-Sauer Composite", {"Linear Solver/Linear Solver Type=Belos"}},
               {"Gautam-Sauer Composite",
                {"Linear Solver/Linear Solver Type=Belos", "Linear Solver/Preconditioner Type=Ifpack2",
                 "Linear Solver/Linear Solver Types/Belos/Solver Type=Block GMRES"}},
               {"Gautam-Sauer Composite", {"Mesh/Type=Exodus", "Mesh/Exodus/File=" + mesh}}};
  const auto moved = [](const std::vector<std::string>& assignments, const Comm& comm) {
    Simulation s(test::scene_file("ball.xml", assignments), comm);
    for (int step = 0; step < 400; ++step) EXPECT_TRUE(s.integrator().step(0.001).converged) << assignments.front();
    return test::gathered(s.model(), s.integrator().state().u);
  };
  std::map<std::string, std::vector<double>> alone;  // by scheme
  for (const auto& [scheme, settings] : cases) {
    std::vector<std::string> assignments{std::string("Time Integrator/Type=") + scheme};
    if (alone.find(scheme) == alone.end()) alone[scheme] = moved(assignments, test::self());
    assignments.insert(assignments.end(), settings.begin(), settings.end());
    EXPECT_LT(test::distance(moved(assignments, world()), alone.at(scheme)), 1e-8) << assignments.back();
  }
}

TEST(BallTest, AverageVectorFieldHoldsEnergyAndMomentumThroughImpacts) {
  Simulation s(test::scene_file("ball.xml", {"Time Integrator/Type=Average Vector Field"}), world());
  const double before = test::total_energy(s);
  const State& state = s.integrator().state();
  for (int step = 0; step < 1500; ++step) ASSERT_TRUE(s.integrator().step(0.001).converged);
  EXPECT_NEAR(test::total_energy(s), before, held);
  // The wall pushes along y only, and the ball is symmetric: no momentum along x.
  EXPECT_NEAR(StateReport(s.model(), state).momenta().linear[0], 0, 1e-12);
}

}  // namespace
}  // namespace ixos
