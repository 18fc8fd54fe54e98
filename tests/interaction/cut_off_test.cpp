#include "interaction/cut_off.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "fem/quadrature.hpp"
#include "interaction/van_der_waals.hpp"
#include "support/automatic_differentiation.hpp"

namespace ixos {
namespace {

const VanDerWaals whole(2.5, 25);
constexpr double range = 1.5;
const CutOff<VanDerWaals> law(whole, range);

TEST(CutOffTest, EndsSmoothlyAndStaysWithinItsBound) {
  for (double r = 0.15; r < 3; r *= 1.02) {
    const auto gap = test::variable<1>(0, r);
    const test::Dual<1> energy = law.energy(gap), traction = law.traction(gap);
    EXPECT_NEAR(law.traction(r), -energy.dx(0), 1e-12 * whole.magnitude(r));
    EXPECT_NEAR(law.stiffness(r), -traction.dx(0), 1e-12 * whole.magnitude(r) / r);
    EXPECT_LE(std::abs(law.traction(r) - whole.traction(r)), std::abs(whole.traction(range)) * (1 + 1e-9));
    EXPECT_LE(std::abs(law.energy(r) - whole.energy(r)),
              std::abs(whole.energy(range)) + std::abs(whole.traction(range)) * std::max(range - r, 0.0) + 1e-16);
  }
  EXPECT_EQ(law.energy(range + 1e-9), 0);
  EXPECT_NEAR(law.energy(range - 1e-9), 0, 1e-17);
  EXPECT_NEAR(law.traction(range - 1e-9), 0, 1e-11);
}

TEST(CutOffTest, MeansAreThoseOfFineQuadrature) {
  const Quadrature gauss = gauss_legendre_unit(64);
  // Within, across the range both ways, and beyond.
  for (const auto& [r0, r1] : {std::pair{0.25, 0.3}, std::pair{1.2, 1.9}, std::pair{1.9, 1.2}, std::pair{1.6, 1.8},
                               std::pair{0.4, 2.4}, std::pair{1.5, 1.1}}) {
    // In two parts: the traction has a kink at the range.
    double traction = 0;
    const double xi = std::min(std::max((range - r0) / (r1 - r0), 0.0), 1.0);
    for (const auto& [from, to] : {std::pair{0.0, xi}, std::pair{xi, 1.0}})
      for (std::size_t i = 0; i < gauss.points.size(); ++i)
        traction +=
            (to - from) * gauss.weights[i] * law.traction(r0 + (from + gauss.points[i] * (to - from)) * (r1 - r0));
    EXPECT_NEAR(law.mean_traction(r0, r1), traction, 1e-12) << r0 << ' ' << r1;
    EXPECT_NEAR(law.mean_traction(r0, r1) * (r1 - r0), law.energy(r0) - law.energy(r1), 1e-15);
    const auto end = test::variable<1>(0, r1);
    const test::Dual<1> mean = law.mean_traction(test::Dual<1>(r0), end);
    EXPECT_NEAR(law.mean_stiffness(r0, r1), -mean.dx(0), 1e-12) << r0 << ' ' << r1;
    const test::Dual<1> potential = law.mean_potential(test::Dual<1>(r0), end);
    EXPECT_NEAR(potential.dx(0), -mean.val(), 1e-12) << r0 << ' ' << r1;
  }
  EXPECT_NEAR(law.mean_traction(0.3, 0.3), law.traction(0.3), 1e-16);
  EXPECT_NEAR(law.mean_stiffness(0.3, 0.3), law.stiffness(0.3) / 2, 1e-14);
  EXPECT_EQ(law.mean_traction(2.0, 2.0), 0);
  EXPECT_EQ(law.mean_stiffness(2.0, 2.0), 0);
  EXPECT_EQ(law.mean_potential(2.0, 2.5), 0);
  EXPECT_EQ(law.mean_potential(0.3, 0.3), 0);
}

/// The integral of (E(r) - E(r0))/(r - r0) over r, in parts that end at the range.
TEST(CutOffTest, ThePotentialOfTheMeanIsThatOfFineQuadrature) {
  const Quadrature gauss = gauss_legendre_unit(64);
  for (const auto& [r0, r1] :
       {std::pair{0.25, 0.3}, std::pair{1.2, 1.9}, std::pair{1.9, 1.2}, std::pair{1.6, 1.8}, std::pair{0.4, 2.4},
        std::pair{1.5, 1.1}, std::pair{1.5, 2.0}, std::pair{1.5 + 1e-9, 1.2}, std::pair{1.5 - 1e-9, 1.7}}) {
    double sum = 0;
    const double middle = std::min(std::max(range, std::min(r0, r1)), std::max(r0, r1));
    for (const auto& [from, to] : {std::pair{r0, middle}, std::pair{middle, r1}})
      for (std::size_t i = 0; i < gauss.points.size(); ++i) {
        const double r = from + gauss.points[i] * (to - from);
        if (r != r0) sum += (to - from) * gauss.weights[i] * (law.energy(r) - law.energy(r0)) / (r - r0);
      }
    EXPECT_NEAR(law.mean_potential(r0, r1), sum, 1e-13) << r0 << ' ' << r1;
  }
}

}  // namespace
}  // namespace ixos
