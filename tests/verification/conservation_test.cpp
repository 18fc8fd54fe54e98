// What each scheme conserves of a free body, against the identities that follow from its equations.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fem/quadrature.hpp"
#include "model/term_sums.hpp"
#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/comparison.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::block_2d;
using test::block_3d;
using test::time_integrator;
using test::world;

Momenta momenta(Simulation& s) { return test::report_of(s).momenta(); }

/// Sum over owned nodes of (X + u) x f in the plane, over all ranks.
double torque(const Model& model, const std::vector<double>& u, const std::vector<double>& f) {
  double sum = 0;
  for (std::size_t n = 0; n < static_cast<std::size_t>(model.mesh().owned_nodes); ++n)
    sum += (model.mesh().coordinates[2 * n] + u[2 * n]) * f[2 * n + 1] -
           (model.mesh().coordinates[2 * n + 1] + u[2 * n + 1]) * f[2 * n];
  model.space().sum(&sum, 1);
  return sum;
}

std::vector<double> force_at(const Model& model, const std::vector<double>& u) {
  std::vector<double> f(u.size());
  EXPECT_TRUE(TermSums(model).force(Part::Elastic, {nullptr, nullptr, u.data()}, end_rule(), f.data()));
  return f;
}

std::vector<double> between(const std::vector<double>& a, const std::vector<double>& b, double xi) {
  std::vector<double> u(a.size());
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = (1 - xi) * a[i] + xi * b[i];
  return u;
}

TEST(ConservationTest, EverySchemeKeepsLinearMomentum) {
  for (const std::string& body : {block_2d(1.5), block_3d(1.0)})
    for (const std::string& scheme : test::moving_schemes()) {
      Simulation s(test::scene(body + time_integrator(scheme, 0.05, 5)), world());
      const auto before = momenta(s).linear;
      for (int step = 0; step < 100; ++step) ASSERT_TRUE(s.integrator().step(0.05).converged) << scheme;
      const auto after = momenta(s).linear;
      for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i], before[i], 2e-11) << scheme;
    }
}

// Trapezoid kinematics give x_mid x M dv + dx x M v_mid = x_mid x M dv, hence with x x f(x) = 0
// dL = -dt/4 (x_n x f_n+1 + x_n+1 x f_n).
TEST(ConservationTest, TrapezoidChangesAngularMomentumByTheCrossTorques) {
  for (const char* scheme : {"Newmark", "Gautam-Sauer Composite"}) {
    Simulation s(test::scene(block_2d(2.0) + time_integrator(scheme, 0.1, 1)), world());
    double largest = 0;
    for (int step = 0; step < 20; ++step) {
      const std::vector<double> u0 = s.integrator().state().u;
      const double before = momenta(s).angular[0];
      ASSERT_TRUE(s.integrator().step(0.1).converged);
      const std::vector<double>& u1 = s.integrator().state().u;
      const Model& model = s.model();
      const double predicted =
          -0.1 / 4 * (torque(model, u0, force_at(model, u1)) + torque(model, u1, force_at(model, u0)));
      const double change = momenta(s).angular[0] - before;
      EXPECT_NEAR(change, predicted, 1e-11) << scheme;
      largest = std::max(largest, std::abs(change));
    }
    EXPECT_GT(largest, 1e-5) << "the identity was tested on nothing";
  }
}

// The same for the mean force F of the straight line: dL = -dt x_mid x F.
TEST(ConservationTest, AverageVectorFieldChangesAngularMomentumByTheTorqueOfTheMeanForce) {
  Simulation s(test::scene(block_2d(2.0) + time_integrator("Average Vector Field", 0.1, 1)), world());
  const Quadrature gauss = gauss_legendre_unit(12);
  double largest = 0;
  for (int step = 0; step < 20; ++step) {
    const std::vector<double> u0 = s.integrator().state().u;
    const double before = momenta(s).angular[0];
    ASSERT_TRUE(s.integrator().step(0.1).converged);
    const std::vector<double>& u1 = s.integrator().state().u;
    const Model& model = s.model();
    std::vector<double> mean(u0.size(), 0.0);
    for (std::size_t q = 0; q < gauss.points.size(); ++q) {
      const std::vector<double> f = force_at(model, between(u0, u1, gauss.points[q]));
      for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += gauss.weights[q] * f[i];
    }
    const double change = momenta(s).angular[0] - before;
    EXPECT_NEAR(change, -0.1 * torque(model, between(u0, u1, 0.5), mean), 1e-9);
    largest = std::max(largest, std::abs(change));
  }
  EXPECT_GT(largest, 1e-5) << "the identity was tested on nothing";
}

/// |L(1) - L(0)| of a spinning block.
double angular_momentum_error(const std::string& scheme, double dt) {
  Simulation s(test::scene(block_2d(1.0) + time_integrator(scheme, dt, 1)), world());
  const double before = momenta(s).angular[0];
  for (int step = 0; step < std::lround(1 / dt); ++step) EXPECT_TRUE(s.integrator().step(dt).converged);
  return std::abs(momenta(s).angular[0] - before);
}

TEST(ConservationTest, MidpointKeepsAngularMomentum) {
  // Forces at the middle turn nothing about the middle.
  EXPECT_LT(angular_momentum_error("Midpoint", 0.05), 1e-10);
  EXPECT_LT(angular_momentum_error("Midpoint", 0.2), 1e-10);
}

/// Returns the largest |E_n - E_0| of velocity Verlet.
double swing(double dt, int steps) {
  Simulation s(test::scene(block_2d(1.0) + time_integrator("Central Difference", dt, 1)), world());
  const double before = test::total_energy(s);
  double largest = 0;
  for (int step = 0; step < steps; ++step) {
    EXPECT_TRUE(s.integrator().step(dt).converged);
    largest = std::max(largest, std::abs(test::total_energy(s) - before));
  }
  return largest;
}

TEST(ConservationTest, CentralDifferenceKeepsAngularMomentumAndANearbyEnergy) {
  // Velocity Verlet is symplectic: x M v changes by nothing but the torque of the forces, and the energy swings about
  // its value by a quantity of second order, without drift.
  EXPECT_LT(angular_momentum_error("Central Difference", 0.05), 1e-13);
  EXPECT_LT(angular_momentum_error("Central Difference", 0.2), 1e-13);
  EXPECT_NEAR(swing(0.05, 200) / swing(0.025, 400), 4, 1);
  EXPECT_LT(swing(0.05, 4000), 5 * swing(0.05, 400));  // a drift would make it 10
}

TEST(ConservationLongTest, CentralDifferenceDoesNotDriftInTwentyThousandSteps) {
  EXPECT_LT(swing(0.05, 20000), 5 * swing(0.05, 2000));
}

TEST(ConservationTest, AngularMomentumErrorIsOfSecondOrderOrBetter) {
  for (const std::string& scheme : test::moving_schemes()) {
    if (scheme == "Midpoint" || scheme == "Energy-Momentum" || scheme == "Central Difference") continue;
    const double coarse = angular_momentum_error(scheme, 0.05);
    const double fine = angular_momentum_error(scheme, 0.025);
    EXPECT_GT(coarse / fine, 3.5) << scheme << ": " << coarse << " -> " << fine;
    EXPECT_LT(coarse, 0.02) << scheme;
  }
}

/// Checks that a block that tumbles and stretches keeps energy and momenta, to the tolerance of Newton's method.
void expect_all_kept(const std::string& body, int steps) {
  Simulation s(test::scene(body + time_integrator("Energy-Momentum", 0.1, 1)), world());
  const double energy = test::total_energy(s);
  const Momenta before = momenta(s);
  double drift = 0, slip = 0, turn = 0;
  for (int step = 0; step < steps; ++step) {
    ASSERT_TRUE(s.integrator().step(0.1).converged) << step;
    drift = std::max(drift, std::abs(test::total_energy(s) - energy));
    const Momenta now = momenta(s);
    for (std::size_t i = 0; i < now.linear.size(); ++i)
      slip = std::max(slip, std::abs(now.linear[i] - before.linear[i]));
    for (std::size_t i = 0; i < now.angular.size(); ++i)
      turn = std::max(turn, std::abs(now.angular[i] - before.angular[i]));
  }
  EXPECT_LT(drift, 1e-9 * energy);
  EXPECT_LT(slip, 1e-9);
  // About the origin, from which the body flies up to 1000 times its own size away.
  EXPECT_LT(turn, 1e-7);
}

TEST(ConservationTest, EnergyMomentumKeepsAll) {
  expect_all_kept(block_2d(1.5), 1000);
  expect_all_kept(block_3d(1.0), 500);
}

TEST(ConservationLongTest, EnergyMomentumKeepsAllForTenThousandSteps) {
  for (const std::string& body : {block_2d(1.5), block_3d(1.0)}) expect_all_kept(body, 10000);
}

/// Largest |E_n - E_0| over 200 steps.
double energy_error(const std::string& body, const std::string& scheme, const std::string& parameters) {
  Simulation s(test::scene(body + time_integrator(scheme, 0.1, 20, parameters)), world());
  const double before = test::total_energy(s);
  double largest = 0;
  for (int step = 0; step < 200; ++step) {
    EXPECT_TRUE(s.integrator().step(0.1).converged) << scheme;
    largest = std::max(largest, std::abs(test::total_energy(s) - before));
  }
  return largest;
}

TEST(ConservationTest, AverageVectorFieldKeepsEnergyToTimeQuadrature) {
  for (const std::string& body : {block_2d(1.0), block_3d(0.7)}) {
    const double two = energy_error(body, "Average Vector Field", test::count("Elastic Points", 2));
    const double four = energy_error(body, "Average Vector Field", test::count("Elastic Points", 4));
    const double eight = energy_error(body, "Average Vector Field", test::count("Elastic Points", 8));
    EXPECT_LT(four, 1e-3 * two);
    EXPECT_LT(eight, 2e-11);
  }
}

TEST(ConservationTest, BatheLosesEnergyAndNewmarkKeepsThatOfLinearProblems) {
  Simulation s(test::scene(block_2d(1.0) + time_integrator("Bathe Composite", 0.3, 30)), world());
  const double before = test::total_energy(s);
  for (int step = 0; step < 100; ++step) ASSERT_TRUE(s.integrator().step(0.3).converged);
  EXPECT_LT(test::total_energy(s), 0.999 * before);
  // Newmark's energy of a linear elastic body: conserved to solver tolerance.
  EXPECT_LT(energy_error(block_2d(0.0, "Linear Elastic"), "Newmark", ""), 1e-10);
  EXPECT_GT(energy_error(block_2d(1.0), "Newmark", ""), 1e-4);
}

TEST(ConservationTest, DampingWorkClosesTheEnergyBalance) {
  // The momentum-form schemes have N = 0 for linear elasticity: E_n - E_0 + sum D = 0; so has Newmark with 1/4, 1/2.
  const std::string damped = [] {
    std::string body = block_2d(0.0, "Linear Elastic");
    const std::string density = test::number("Density", 1);
    body.insert(body.find(density), test::number("Mass Damping", 0.1) + test::number("Stiffness Damping", 0.05));
    return body;
  }();
  for (const char* scheme : {"Newmark", "Gautam-Sauer Composite", "Average Vector Field", "Energy-Momentum"}) {
    Simulation s(test::scene(damped + time_integrator(scheme, 0.1, 1)), world());
    const double before = test::total_energy(s);
    for (int step = 0; step < 50; ++step) ASSERT_TRUE(s.integrator().step(0.1).converged);
    EXPECT_GT(s.integrator().dissipated_energy(), 0.05 * before) << scheme;
    EXPECT_NEAR(test::total_energy(s) + s.integrator().dissipated_energy(), before, 1e-11) << scheme;
  }
}

}  // namespace
}  // namespace ixos
