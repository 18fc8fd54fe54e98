#include "interaction/piecewise_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fem/quadrature.hpp"
#include "support/derivative.hpp"

namespace ixos {
namespace {

/// 2 - r up to 1, (2 - r)^3 up to 2.
const PiecewiseLaw law({{1, 0, {2, -1, 0, 0}}, {2, 2, {0, 0, 0, -1}}}, 0.5, 0.75);

TEST(PiecewiseLawTest, ValuesAreThoseOfThePieces) {
  EXPECT_EQ(law.traction(-3.0), 5);
  EXPECT_EQ(law.traction(0.5), 1.5);
  EXPECT_NEAR(law.traction(1.5), 0.125, 1e-16);
  EXPECT_EQ(law.traction(2.0), 0);
  EXPECT_EQ(law.traction(1e9), 0);
  EXPECT_EQ(law.stiffness(0.5), 1);
  EXPECT_NEAR(law.stiffness(1.5), 0.75, 1e-16);
  EXPECT_EQ(law.stiffness(2.5), 0);
  EXPECT_EQ(law.energy(2.0), 0);
  EXPECT_NEAR(law.energy(1.5), 1.0 / 64, 1e-16);
  EXPECT_NEAR(law.energy(0.0), 1.5 + 0.25, 1e-15);
  EXPECT_EQ(law.range(), 2);
  EXPECT_TRUE(law.repels());
  EXPECT_EQ(law.equilibrium_gap(), 0.5);
  EXPECT_EQ(law.adhesion_gap(), 0.75);
}

TEST(PiecewiseLawTest, RoundingAtAKinkIsThatOfTheSteeperSide) {
  const PiecewiseLaw penalty({{0.5, 0.5, {0, -8, 0, 0}}}, 0.5, 0.5);
  EXPECT_NEAR(penalty.magnitude(0.5), 4, 1e-15);
  EXPECT_NEAR(penalty.magnitude(0.5 + 1e-15), 4, 1e-13);
  EXPECT_NEAR(penalty.magnitude(0.25), 2 + 2, 1e-15);
  EXPECT_EQ(penalty.magnitude(0.5 + 1e-8), 0);
}

TEST(PiecewiseLawTest, PacksHoldLanesOfAllPieces) {
  const double places[] = {-1, 0.5, 1, 1.2, 1.9, 2, 2.5, 7};
  const auto at = [&](std::size_t i) { return places[i % 8]; };
  const Pack r0([&](auto i) { return at(i); }), r1([&](auto i) { return at(3 * i + 1); });
  for (std::size_t i = 0; i < Pack::size(); ++i) {
    const double a = r0[i], b = r1[i];
    EXPECT_NEAR(law.traction(r0)[i], law.traction(a), 1e-15);
    EXPECT_NEAR(law.energy(r0)[i], law.energy(a), 1e-15);
    EXPECT_NEAR(law.stiffness(r0)[i], law.stiffness(a), 1e-15);
    EXPECT_NEAR(law.mean_traction(r0, r1)[i], law.mean_traction(a, b), 1e-15);
    EXPECT_NEAR(law.mean_stiffness(r0, r1)[i], law.mean_stiffness(a, b), 1e-15);
    EXPECT_EQ(law.mean_potential(r0, r1)[i], law.mean_potential(a, b));
  }
}

TEST(PiecewiseLawTest, MeansAreDifferencesOfTheEnergy) {
  for (double a : {-2.0, 0.3, 1.0, 1.4, 1.999999, 2.0, 3.0})
    for (double b : {-1.0, 0.6, 1.0000001, 1.7, 2.0, 2.5}) {
      EXPECT_NEAR(law.mean_traction(a, b) * (b - a), law.energy(a) - law.energy(b), 1e-14) << a << ' ' << b;
      const auto mean = [&](double s) { return law.mean_traction(a, b + s); };
      if (b == 0.6 || b == 1.7 || b == 2.5) {
        EXPECT_NEAR(test::derivative(mean, 1e-3), -law.mean_stiffness(a, b), 1e-9) << a << ' ' << b;
      }
    }
}

TEST(PiecewiseLawTest, MeansKeepTheirDigitsOnShortPaths) {
  for (double r : {0.3, 1.0, 1.3, 1.9})
    for (double way : {0.0, 1e-15, 1e-12, -1e-12, 1e-7}) {
      EXPECT_NEAR(law.mean_traction(r, r + way), law.traction(r + way / 2), 1e-13) << r << ' ' << way;
      // The stiffness jumps at 1 from 1 to 3.
      const double half = r == 1 && way < 0 ? 0.5 : law.stiffness(r) / 2;
      EXPECT_NEAR(law.mean_stiffness(r, r + way), half, 1e-6) << r << ' ' << way;
    }
}

TEST(PiecewiseLawTest, ThePotentialOfTheMeanIsTheIntegral) {
  const Quadrature gauss = gauss_legendre_unit(64);
  for (double a : {-2.0, 0.3, 0.9, 0.9999, 1.0, 1.4, 1.9999, 2.0, 3.0, 50.0})
    for (double b : {-1.0, 0.6, 1.2, 1.7, 2.2, 60.0}) {
      // Parts that end at the pieces' ends and, towards a, halve 48 times.
      const auto slope = [&](double r) {
        return r == a ? -law.traction(a) : (law.energy(r) - law.energy(a)) / (r - a);
      };
      double sum = 0, outer = 1;
      for (int part = 0; part < 48; ++part, outer /= 2)
        for (const double cut : {1.0, 2.0, 1e9}) {
          const auto clamp = [&](double share) {
            const double r = a + share * (b - a), lowest = cut == 1 ? -1e9 : cut == 2 ? 1 : 2;
            return std::min(std::max(r, lowest), cut);
          };
          const double from = clamp(outer / 2), to = clamp(outer);
          for (std::size_t q = 0; q < gauss.points.size(); ++q)
            sum += (to - from) * gauss.weights[q] * slope(from + gauss.points[q] * (to - from));
        }
      EXPECT_NEAR(law.mean_potential(a, b), sum, 1e-10) << a << ' ' << b;
    }
  EXPECT_EQ(law.mean_potential(1.3, 1.3), 0);
  EXPECT_EQ(law.mean_potential(2.3, 4.3), 0);
}

TEST(PiecewiseLawTest, AConstantAttractionEndsSmoothly) {
  const double strength = 3, range = 0.4, ramp = 0.1;
  const PiecewiseLaw flat = constant_attraction(strength, range, ramp);
  EXPECT_EQ(flat.traction(0.1), -strength);
  EXPECT_NEAR(flat.traction(range), -strength / 2, 1e-15);
  EXPECT_EQ(flat.traction(0.5), 0);
  EXPECT_NEAR(flat.traction(0.3 + 1e-9), -strength, 1e-14);
  EXPECT_NEAR(flat.stiffness(0.3 + 1e-9), 0, 1e-5);
  EXPECT_NEAR(flat.stiffness(0.5 - 1e-9), 0, 1e-5);
  EXPECT_NEAR(flat.energy(0.0), -strength * range, 1e-15);
  EXPECT_FALSE(flat.repels());
  EXPECT_NEAR(constant_attraction(strength, range, range).energy(0.0), -strength * range, 1e-15);
}

}  // namespace
}  // namespace ixos
