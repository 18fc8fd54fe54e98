#include "interaction/van_der_waals.hpp"

#include "fem/quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/pack.hpp"
#include "support/automatic_differentiation.hpp"

namespace ixos {
namespace {

// The parameters of the paper.
constexpr double gamma_length = 2.5;
constexpr double gamma_energy = 25.0;
const VanDerWaals law(gamma_length, gamma_energy);

/// Gaps from 1e-2 to 1e2, eight a decade.
std::vector<double> gaps() {
  std::vector<double> result;
  for (int i = -16; i <= 16; ++i) result.push_back(std::pow(10.0, i / 8.0));
  return result;
}

/// Repulsion and attraction nearly cancel about the equilibrium: digits count relative to the larger of the two.
double scale(double r, int order) { return law.c1() / std::pow(r, 8 + order) + law.c2() / std::pow(r, 2 + order); }

TEST(VanDerWaalsTest, ConstantsAreThoseOfThePaper) {
  EXPECT_NEAR(law.c1(), 7.32044e-7, 0.5e-12);
  EXPECT_NEAR(law.c2(), 2.680826e-3, 0.5e-9);
  // c1 = E0 L0^9 pi/(45 gamma_W gamma_L^9), c2 = E0 L0^3 pi/(3 gamma_W gamma_L^3): their ratio is r0^6/15.
  EXPECT_NEAR(law.c1() / law.c2(), std::pow(gamma_length, -6) / 15, 1e-18);
}

TEST(VanDerWaalsTest, EquilibriumHasNoTraction) {
  const double r = law.equilibrium_gap();
  EXPECT_NEAR(r, 0.2547093, 0.5e-7);
  EXPECT_NEAR(r, std::pow(15.0, -1.0 / 6) / gamma_length, 1e-15);
  EXPECT_NEAR(law.traction(r), 0.0, 1e-14 * scale(r, 1));
  EXPECT_GT(law.traction(0.999 * r), 0.0);
  EXPECT_LT(law.traction(1.001 * r), 0.0);
}

TEST(VanDerWaalsTest, AttractionIsLargestAtTheAdhesionGap) {
  const double r = law.adhesion_gap();
  EXPECT_NEAR(r, 0.3058898, 0.5e-7);
  EXPECT_NEAR(law.traction(r), -0.0624428, 0.5e-7);
  EXPECT_NEAR(law.traction(r), -2 * std::sqrt(5.0) / 9 * M_PI / gamma_energy, 1e-15);
  EXPECT_NEAR(law.stiffness(r), 0.0, 1e-13 * scale(r, 2));
  for (double other : gaps()) EXPECT_GT(law.traction(other), law.traction(r));
}

TEST(VanDerWaalsTest, WorkOfAdhesionIsTheDepthOfTheWell) {
  const double work = -law.energy(law.equilibrium_gap());
  EXPECT_NEAR(work, 0.01549567, 0.5e-8);
  EXPECT_NEAR(work, std::cbrt(15.0) * M_PI / (8 * gamma_energy * gamma_length), 1e-16);
  for (double r : gaps()) EXPECT_GT(law.energy(r), -work);
}

TEST(VanDerWaalsTest, StiffnessIsThatOfTheTable) {
  const double r = law.equilibrium_gap();
  EXPECT_NEAR(law.stiffness(r), 3.821560, 0.5e-6);
  EXPECT_NEAR(law.stiffness(r), 6 * law.c2() / std::pow(r, 4), 1e-13);
  EXPECT_NEAR(law.stiffness(0.2), 59.0, 0.5);
  EXPECT_NEAR(law.stiffness(0.175), 236.0, 0.5);
}

TEST(VanDerWaalsTest, EnergyIsThePotentialAndTractionItsSlope) {
  for (double r : gaps()) {
    const double c1 = law.c1(), c2 = law.c2();
    EXPECT_NEAR(law.energy(r), c1 / 8 * std::pow(r, -8) - c2 / 2 * std::pow(r, -2), 1e-14 * scale(r, 0)) << r;
    const auto gap = test::variable<1>(0, r);
    const test::Dual<1> energy = law.energy(gap);
    const test::Dual<1> traction = law.traction(gap);
    EXPECT_NEAR(law.traction(r), -energy.dx(0), 1e-12 * scale(r, 1)) << r;
    EXPECT_NEAR(law.stiffness(r), -traction.dx(0), 1e-12 * scale(r, 2)) << r;
  }
}

TEST(VanDerWaalsTest, PacksEqualDoubles) {
  const std::vector<double> all = gaps();
  for (std::size_t first = 0; first + Pack::size() <= all.size(); ++first) {
    Pack r(0.0);
    for (std::size_t i = 0; i < Pack::size(); ++i) r[i] = all[first + i];
    const Pack energy = law.energy(r), traction = law.traction(r), stiffness = law.stiffness(r);
    for (std::size_t i = 0; i < Pack::size(); ++i) {
      const double one = all[first + i];
      EXPECT_NEAR(lane(energy, i), law.energy(one), 1e-14 * scale(one, 0));
      EXPECT_NEAR(lane(traction, i), law.traction(one), 1e-14 * scale(one, 1));
      EXPECT_NEAR(lane(stiffness, i), law.stiffness(one), 1e-13 * scale(one, 2));
    }
  }
}

TEST(VanDerWaalsTest, MeansAreThoseOfFineQuadrature) {
  const Quadrature gauss = gauss_legendre_unit(64);
  for (const auto& [r0, r1] : {std::pair{0.25, 0.26}, std::pair{0.3, 0.2}, std::pair{0.2, 1.1}, std::pair{5.0, 0.25}}) {
    double traction = 0, stiffness = 0;
    for (std::size_t i = 0; i < gauss.points.size(); ++i) {
      const double xi = gauss.points[i], r = r0 + xi * (r1 - r0);
      traction += gauss.weights[i] * law.traction(r);
      stiffness += gauss.weights[i] * xi * law.stiffness(r);
    }
    EXPECT_NEAR(law.mean_traction(r0, r1), traction, 1e-10 * law.magnitude(std::min(r0, r1)));
    EXPECT_NEAR(law.mean_stiffness(r0, r1), stiffness, 1e-9 * law.magnitude(std::min(r0, r1)) / std::min(r0, r1));
    // The work of the mean traction is the change of the energy, to the last digits.
    EXPECT_NEAR(law.mean_traction(r0, r1) * (r1 - r0), law.energy(r0) - law.energy(r1),
                1e-14 * law.magnitude(std::min(r0, r1)));
    const double h = 1e-4 * r1;
    EXPECT_NEAR((law.mean_potential(r0, r1 + h) - law.mean_potential(r0, r1 - h)) / (2 * h), -law.mean_traction(r0, r1),
                1e-6 * law.magnitude(std::min(r0, r1)));
  }
  EXPECT_NEAR(law.mean_traction(0.28, 0.28), law.traction(0.28), 1e-15);
  EXPECT_NEAR(law.mean_stiffness(0.28, 0.28), law.stiffness(0.28) / 2, 1e-13);
  EXPECT_NEAR(law.mean_potential(0.28, 0.28), 0, 1e-17);
}

}  // namespace
}  // namespace ixos
