#include "interaction/area_factor.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "interaction/damage_law.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/van_der_waals.hpp"
#include "support/derivative.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

using test::derivative;

const VanDerWaals plain(2.5, 25);

class AreaFactorTest : public testing::TestWithParam<AreaFactor> {};

TEST_P(AreaFactorTest, TheEnergyIsThatOfTheAreaHalfWay) {
  const auto law = with_area_factor(gap_law(plain), GetParam());
  const double r = 0.4, radius = GetParam().radius;
  const double factor = std::pow((radius + r / 2) / (radius + r), GetParam().power);
  EXPECT_NEAR(law->energy(r)[0], factor * plain.energy(r), 1e-16);
}

TEST_P(AreaFactorTest, TractionAndMeansAreDerivativesAndMeans) {
  const auto law = with_area_factor(gap_law(plain), GetParam());
  for (double r : {0.22, 0.3, 0.8}) {
    const double scale = law->magnitude(r)[0], h = 1e-3 * r;
    EXPECT_NEAR(derivative([&](double s) { return -law->energy(r + s)[0]; }, h), law->traction(r)[0], 1e-8 * scale);
    EXPECT_NEAR(derivative([&](double s) { return -law->traction(r + s)[0]; }, h), law->stiffness(r)[0],
                1e-7 * scale / r);
    for (double r1 : {0.25, 0.9}) {
      const double both = law->magnitude(std::min(r, r1))[0];
      EXPECT_NEAR(law->mean_traction(r, r1)[0] * (r1 - r), law->energy(r)[0] - law->energy(r1)[0], 1e-15);
      EXPECT_NEAR(derivative([&](double s) { return -law->mean_traction(r, r1 + s)[0]; }, 1e-3 * r1),
                  law->mean_stiffness(r, r1)[0], 1e-7 * both / r1);
    }
    // No digits are lost when the gap hardly moves.
    EXPECT_NEAR(law->mean_traction(r, r * (1 + 1e-12))[0], law->traction(r)[0], 1e-11 * scale);
    EXPECT_NEAR(law->mean_stiffness(r, r)[0], law->stiffness(r)[0] / 2, 1e-12 * scale / r);
  }
}

TEST_P(AreaFactorTest, ACutOffLawStaysCutOff) {
  const auto law = with_area_factor(gap_law(plain), GetParam())->cut_off(2);
  EXPECT_EQ(law->range(), 2);
  EXPECT_EQ(law->energy(2.1)[0], 0);
  EXPECT_NEAR(law->traction(2 - 1e-12)[0], 0, 1e-12);
  EXPECT_NEAR(derivative([&](double s) { return -law->energy(0.5 + s)[0]; }), law->traction(0.5)[0], 1e-9);
}

INSTANTIATE_TEST_SUITE_P(All, AreaFactorTest,
                         testing::Values(AreaFactor{5, 2}, AreaFactor{-5, 2}, AreaFactor{5, 1}, AreaFactor{-5, 1}));

// Concentric surfaces, energy per area of the body. The volume integral of the pair potential B/s^12 - C/s^6 that gives
// psi between half-spaces, over a sphere of radius R and all that is farther than the gap g from it: the potential of a
// unit volume at distance d from the centre (Hamaker 1937; Everaers and Ejtehadi 2003), times 4 pi d^2, from d = R + g.
TEST(AreaFactorOrderTest, TheErrorBeforeASphereIsOfSecondOrder) {
  const double c = 12 * (plain.c2() / 2) / M_PI, b = 360 * (plain.c1() / 8) / M_PI, g = plain.equilibrium_gap();
  const auto error = [&](double radius, bool with_factor) {
    const auto density = [&](double d) {
      const double q = d * d - radius * radius, r2 = radius * radius, d2 = d * d;
      const double repulsion = 15 * d2 * d2 * d2 + 63 * d2 * d2 * r2 + 45 * d2 * r2 * r2 + 5 * r2 * r2 * r2;
      return b * 4 * M_PI / 45 * radius * r2 * repulsion / std::pow(q, 9) -
             c * 4 * M_PI / 3 * radius * r2 / std::pow(q, 3);
    };
    // Simpson's rule in t with d = R + g/t.
    const int parts = 20000;
    double sum = 0;
    for (int k = 1; k <= parts; ++k) {
      const double t = static_cast<double>(k) / parts, d = radius + g / t;
      sum += (k == parts ? 1 : k % 2 == 1 ? 4 : 2) * density(d) * std::pow(d / (radius + g), 2) * g / (t * t);
    }
    const double exact = sum / (3.0 * parts);
    const auto law = with_factor ? with_area_factor(gap_law(plain), {radius, 2}) : gap_law(plain);
    return exact / law->energy(g)[0] - 1;
  };
  EXPECT_NEAR(error(10, false), -0.0282, 1e-4);
  EXPECT_NEAR(error(50, false), -0.0053, 1e-4);
  EXPECT_NEAR(error(10, true), -0.0036, 1e-4);
  EXPECT_NEAR(error(50, true), -0.0002, 1e-4);
}

TEST(AreaFactorRefusalTest, NeedsARadius) {
  test::expect_contains(test::refusal([] { with_area_factor(gap_law(plain), {0, 2}); }), "radius");
}

TEST(AreaFactorRefusalTest, RefusesALawWithAHistory) {
  test::expect_contains(test::refusal([] {
                          with_area_factor(gap_law(DamageLaw(0.5, 0.05, 0.8)), {10, 2});
                        }),
                        "history");
}

}  // namespace
}  // namespace ixos
