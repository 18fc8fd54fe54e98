// A stiff body before an adhesive wall moves as a rigid one, whose motion has closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "fem/quadrature.hpp"
#include "interaction/van_der_waals.hpp"
#include "scene/simulation.hpp"
#include "support/comparison.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::world;

const VanDerWaals law(2.5, 25);

/// A block of edge 1 with its bottom at y = 0 and a wall through (0, -gap) with the given normal.
std::string stiff_block(double gap, const std::vector<double>& normal, int surface_points, double density,
                        int dimension = 2) {
  std::vector<double> point(static_cast<std::size_t>(dimension), 0.0);
  point.back() = -gap;
  const auto d = static_cast<std::size_t>(dimension);
  return test::list("Mesh", test::word("Type", "Box") +
                                test::list("Box", test::count("Dimension", dimension) +
                                                      test::numbers("Lengths", std::vector<double>(d, 1.0)) +
                                                      test::counts("Divisions", std::vector<int>(d, 2)))) +
         test::list("Materials",
                    test::list("Steel", test::number("Young's Modulus", 1e5) + test::number("Density", density))) +
         test::list(
             "Interactions",
             test::list("Wall", test::word("Side Set", "bottom") + test::count("Surface Points", surface_points) +
                                    test::numbers("Point", point) + test::numbers("Normal", normal)));
}

TEST(RigidLimitTest, ForceOnAParallelFaceIsTheTractionTimesItsSize) {
  for (int dimension : {2, 3})
    for (double gap : {0.2, 0.2547093, 0.4, 2.0}) {
      std::vector<double> up(static_cast<std::size_t>(dimension), 0.0);
      up.back() = 1;
      Simulation s(test::scene(stiff_block(gap, up, 2, 1, dimension) + test::time_integrator("Newmark", 1, 1)),
                   world());
      const InteractionReport report = test::report_of(s).interaction_report();
      EXPECT_NEAR(report.force.back(), law.traction(gap), 1e-13);
      EXPECT_NEAR(report.force.front(), 0, 1e-15);
      EXPECT_NEAR(report.least_gap, gap, 1e-14);
      EXPECT_NEAR(report.measure, gap < law.adhesion_gap() ? 1.0 : 0.0, 1e-14);
      EXPECT_NEAR(test::report_of(s).energy(Part::Interaction), law.energy(gap), 1e-13);
    }
}

TEST(RigidLimitTest, ForceOnATiltedFaceIsTheDifferenceOfEnergies) {
  // Along the face the gap runs linearly from r0 to r1: int T = (psi(r0) - psi(r1))/(r1 - r0).
  const double angle = 0.3, gap = 0.3;
  const double r0 = gap * std::cos(angle), r1 = r0 + std::sin(angle);
  const double exact = (law.energy(r0) - law.energy(r1)) / (r1 - r0);
  double before = 1;
  for (int points : {2, 4, 8, 16}) {
    Simulation s(test::scene(stiff_block(gap, {std::sin(angle), std::cos(angle)}, points, 1) +
                             test::time_integrator("Newmark", 1, 1)),
                 world());
    const auto force = test::report_of(s).interaction_report().force;
    const double along = force[0] * std::sin(angle) + force[1] * std::cos(angle);
    const double error = std::abs(along / exact - 1);
    EXPECT_LT(error, 0.2 * before) << points;
    before = error;
  }
  EXPECT_LT(before, 1e-9);
}

TEST(RigidLimitTest, SmallVibrationAtTheEquilibriumGapHasTheStiffnessOfTheLaw) {
  const double omega = std::sqrt(law.stiffness(law.equilibrium_gap()));  // density 1, height 1
  const double dt = 2 * M_PI / omega / 100;
  Simulation s(
      test::scene(stiff_block(law.equilibrium_gap() + 1e-6, {0, 1}, 2, 1) + test::time_integrator("Newmark", dt, 1)),
      world());
  std::vector<double> y;
  for (int step = 0; step < 30; ++step) {
    ASSERT_TRUE(s.integrator().step(dt).converged);
    y.push_back(test::gathered(s.model(), s.integrator().state().u)[1] + 1e-6);
  }
  // Even about the equilibrium: y_n+1 + y_n-1 = 2 cos(theta) y_n, tan(theta/2) = omega dt/2.
  double numerator = 0, denominator = 0;
  for (std::size_t n = 1; n + 1 < y.size(); ++n) {
    numerator += y[n] * (y[n + 1] + y[n - 1]);
    denominator += y[n] * y[n];
  }
  const double theta = std::acos(numerator / denominator / 2);
  EXPECT_NEAR(2 * std::tan(theta / 2) / dt, omega, 1e-3 * omega);
}

TEST(RigidLimitTest, FallTakesTheTimeOfTheEnergyIntegral) {
  // From rest at gap g0 to gap g: t = int dr/sqrt(2 (psi(g0) - psi(r))/m), with r = g0 - s^2 against the root at g0.
  const double g0 = 1.0, g = 0.5;
  const Quadrature gauss = gauss_legendre_unit(40);
  double time = 0;
  const double top = std::sqrt(g0 - g);
  for (std::size_t q = 0; q < gauss.points.size(); ++q) {
    const double s = top * gauss.points[q];
    time += gauss.weights[q] * top * 2 * s / std::sqrt(2 * (law.energy(g0) - law.energy(g0 - s * s)));
  }
  for (const char* scheme : {"Newmark", "Bathe Composite", "Gautam-Sauer Composite", "Average Vector Field"}) {
    Simulation s(test::scene(stiff_block(g0, {0, 1}, 2, 1) + test::time_integrator(scheme, time / 200, 1)), world());
    for (int step = 0; step < 200; ++step) ASSERT_TRUE(s.integrator().step(time / 200).converged) << scheme;
    EXPECT_NEAR(test::report_of(s).interaction_report().least_gap, g, 2e-4) << scheme;
    const auto momenta = test::report_of(s).momenta();
    EXPECT_NEAR(momenta.kinetic_energy, law.energy(g0) - law.energy(g), 1e-3 * (law.energy(g0) - law.energy(g)));
  }
}

}  // namespace
}  // namespace ixos
