#include "interaction/damage_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "support/derivative.hpp"
#include "support/refusal.hpp"
#include "support/sanitized.hpp"

namespace ixos {
namespace {

constexpr double stiffness = 0.8, strength = 0.2, range = 1.5;
constexpr double peak = strength / stiffness, work = strength * range / 2;
const DamageLaw law(stiffness, strength, range);

TEST(DamageLawTest, TheEnvelopeIsThatOfAnUndamagedPoint) {
  const auto envelope = gap_law(law);
  EXPECT_TRUE(envelope->has_history());
  EXPECT_TRUE(envelope->repels());
  EXPECT_EQ(envelope->domain(), GapDomain::All);
  EXPECT_EQ(envelope->adhesion_gap(), peak);
  EXPECT_EQ(envelope->range(), range);
  EXPECT_NEAR(envelope->traction(peak)[0], -strength, 1e-16);
  EXPECT_NEAR(work_of_adhesion(*envelope), work, 1e-16);
  const FrozenDamage whole = law.at(law.first(0.0));
  for (const double r : {-0.3, 0.0, 0.1, 0.3, 0.7, 1.4999, 1.5, 9.0}) {
    EXPECT_NEAR(whole.traction(r)[0], envelope->traction(r)[0], 1e-16) << r;
    EXPECT_NEAR(whole.energy(r)[0] - work, envelope->energy(r)[0], 1e-16) << r;
    EXPECT_NEAR(whole.stiffness(r)[0], envelope->stiffness(r)[0], 1e-15) << r;
  }
}

TEST(DamageLawTest, DissipationHasItsClosedForm) {
  for (const double kappa : {peak, 0.4, 1.0, 1.499}) {
    EXPECT_NEAR(law.dissipated(peak, kappa)[0], strength * range * (kappa - peak) / (2 * (range - peak)), 1e-16);
    // Section by section: the area under the envelope less what unloading gives back.
    const double fall = strength * (range - kappa) / (range - peak);
    EXPECT_NEAR(law.dissipated(peak, kappa)[0],
                strength * peak / 2 + (strength + fall) / 2 * (kappa - peak) - fall * kappa / 2, 1e-16);
  }
  for (const double kappa : {range, 7.0}) {
    EXPECT_NEAR(law.dissipated(peak, kappa)[0], work, 1e-16);
  }
}

TEST(DamageLawTest, DamageGrowsFromTheLargestAttractionToTheEnd) {
  for (const double gap : {-1.0, 0.0, peak}) EXPECT_EQ(law.damage(law.first(gap))[0], 0) << gap;
  for (const double gap : {range, 7.0}) EXPECT_EQ(law.damage(law.first(gap))[0], 1) << gap;
  // The secant of the damaged bond meets the envelope at kappa.
  for (const double kappa : {0.3, 0.9, 1.4}) {
    const double share = strength * (range - kappa) / (range - peak) / (stiffness * kappa);
    EXPECT_NEAR(law.damage(kappa)[0], 1 - share, 1e-15) << kappa;
  }
}

TEST(DamageLawTest, UnloadsAlongTheSecantAndRepelsUndamaged) {
  const double kappa = 0.9, damage = law.damage(kappa)[0];
  const FrozenDamage frozen = law.at(kappa);
  for (const double r : {0.1, 0.5, 0.8999}) {
    EXPECT_NEAR(frozen.traction(r)[0], -(1 - damage) * stiffness * r, 1e-16);
    EXPECT_NEAR(frozen.energy(r)[0], (1 - damage) * stiffness * r * r / 2, 1e-16);
  }
  EXPECT_NEAR(frozen.traction(1.2)[0], -strength * (range - 1.2) / (range - peak), 1e-16);
  EXPECT_NEAR(frozen.traction(-0.1)[0], stiffness * 0.1, 1e-16);
  EXPECT_NEAR(frozen.energy(-0.1)[0], stiffness * 0.005, 1e-16);
  const FrozenDamage broken = law.at(2.0);
  for (const double r : {0.5, 1.7, 3.0}) {
    EXPECT_EQ(broken.traction(r)[0], 0) << r;
    EXPECT_EQ(broken.energy(r)[0], 0) << r;
  }
  EXPECT_NEAR(broken.traction(-0.1)[0], stiffness * 0.1, 1e-16);
}

TEST(DamageLawTest, EachStepsWorkIsStoredOrDissipated) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-0.4, 2.0);
  for (int path = 0; path < 40; ++path) {
    double r = 0, stored = 0, dissipated = 0, total = 0;
    Pack kappa = law.first(r);
    for (int step = 0; step < 50; ++step) {
      // Wide and narrow steps, some of them around the largest gap so far.
      const double place = step % 3 == 0 ? kappa[0] : uniform(random) * step / 50;
      const double next = place + (step % 2 == 0 ? 1e-3 : 1e-9) * uniform(random);
      const double done = -law.at(kappa).mean_traction(r, next)[0] * (next - r);
      const Pack after = law.updated(kappa, next);
      const double lost = law.dissipated(kappa, after)[0], now = law.at(after).energy(next)[0];
      EXPECT_GE(lost, 0);
      EXPECT_NEAR(done, now - stored + lost, 2e-16);
      EXPECT_NEAR(law.at(kappa).energy(next)[0], now + lost, 1e-16);
      EXPECT_NEAR(law.at(kappa).traction(next)[0], law.at(after).traction(next)[0], 1e-16);
      kappa = after;
      r = next;
      stored = now;
      dissipated += lost;
      total += done;
    }
    EXPECT_NEAR(total, stored + dissipated, 1e-14 * work);
    EXPECT_LE(dissipated, work * (1 + 1e-14));
  }
}

TEST(DamageLawTest, ABondOnTouchWaitsForAGapOfZero) {
  const DamageLaw late(stiffness, strength, range, true);
  EXPECT_TRUE(gap_law(late)->bonds_later());
  EXPECT_FALSE(gap_law(law)->bonds_later());
  Pack q = late.first(1.2);
  for (const double r : {1.2, 0.4, 1e-9, 2.0}) {
    q = late.updated(q, r);
    EXPECT_EQ(late.damage(q)[0], 1) << r;
    EXPECT_EQ(late.at(q).traction(r)[0], 0) << r;
    EXPECT_EQ(late.at(q).energy(r)[0], 0) << r;
    EXPECT_EQ(late.at(q).mean_traction(0.1, r)[0], 0) << r;
  }
  EXPECT_NEAR(late.at(q).traction(-0.1)[0], stiffness * 0.1, 1e-16);
  // The step that touches: both laws agree at its end, and nothing is dissipated.
  for (const double r : {0.0, -0.05}) {
    const Pack bonded = late.updated(q, r);
    EXPECT_EQ(late.dissipated(q, bonded)[0], 0);
    EXPECT_EQ(late.damage(bonded)[0], 0);
    EXPECT_EQ(late.at(q).energy(r)[0], late.at(bonded).energy(r)[0]);
    EXPECT_EQ(late.at(q).traction(r)[0], late.at(bonded).traction(r)[0]);
    // From then on it is the bond that another point has from the start.
    const Pack kappa = late.updated(bonded, 0.9), other = law.updated(law.first(0.0), 0.9);
    EXPECT_EQ(kappa[0], other[0]);
    EXPECT_EQ(late.at(kappa).traction(0.4)[0], law.at(other).traction(0.4)[0]);
    EXPECT_EQ(late.dissipated(bonded, kappa)[0], law.dissipated(law.first(0.0), other)[0]);
    EXPECT_EQ(late.updated(late.updated(kappa, 3.0), -0.1)[0], 3.0) << "a broken bond does not heal";
  }
  for (const double r : {-0.2, 0.0, peak}) EXPECT_EQ(late.first(r)[0], law.first(r)[0]) << "bonded at the start";
}

TEST(DamageLawTest, StiffnessesAndPotentialsAreDerivatives) {
  for (const double kappa : {0.25, 0.9, 1.5, 2.0}) {
    const FrozenDamage frozen = law.at(kappa);
    for (const double a : {-0.3, 0.1, 0.6, 1.3, 2.2})
      for (const double b : {-0.2, 0.15, 0.7, 1.1, 1.8, 2.4}) {
        SCOPED_TRACE(testing::Message() << "kappa " << kappa << " from " << a << " to " << b);
        const auto slope = [&](const auto& of) {
          return test::derivative([&](double s) -> double { return of(b + s); }, 1e-3);
        };
        EXPECT_NEAR(slope([&](double r) -> double { return frozen.energy(r)[0]; }), -frozen.traction(b)[0], 1e-10);
        EXPECT_NEAR(slope([&](double r) -> double { return frozen.traction(r)[0]; }), -frozen.stiffness(b)[0], 1e-10);
        EXPECT_NEAR(slope([&](double r) -> double { return frozen.mean_traction(a, r)[0]; }),
                    -frozen.mean_stiffness(a, b)[0], 1e-9);
        EXPECT_NEAR(slope([&](double r) -> double { return frozen.mean_potential(a, r)[0]; }),
                    -frozen.mean_traction(a, b)[0], 1e-9);
        EXPECT_NEAR(frozen.mean_traction(a, b)[0] * (b - a), frozen.energy(a)[0] - frozen.energy(b)[0], 1e-16);
      }
    for (const double a : {-0.3, 0.1, 1.3, 2.2}) {
      // Under sanitizers the library fuses other operations than this test.
      const double rounding = test::sanitized() ? 1e-16 : 0;
      EXPECT_NEAR(frozen.mean_traction(a, a)[0], frozen.traction(a)[0], rounding);
      EXPECT_NEAR(frozen.mean_stiffness(a, a)[0], frozen.stiffness(a)[0] / 2, rounding);
      EXPECT_EQ(frozen.mean_potential(a, a)[0], 0);
    }
  }
}

TEST(DamageLawTest, LanesHaveHistoriesOfTheirOwn) {
  const Pack kappa([](auto i) { return 0.25 + 0.2 * static_cast<double>(i); });
  const Pack r([](auto i) { return 0.1 + 0.25 * static_cast<double>(i); });
  const FrozenDamage frozen = law.at(kappa);
  for (std::size_t i = 0; i < Pack::size(); ++i) {
    const FrozenDamage own = law.at(double(kappa[i]));
    EXPECT_EQ(frozen.traction(r)[i], own.traction(double(r[i]))[0]);
    EXPECT_EQ(frozen.mean_traction(0.3, r)[i], own.mean_traction(0.3, double(r[i]))[0]);
    EXPECT_EQ(frozen.mean_potential(0.3, r)[i], own.mean_potential(0.3, double(r[i]))[0]);
  }
}

TEST(DamageLawTest, TheCatalogueTakesBondsOnTouch) {
  const Settings glue = {{"Work of Adhesion", work}, {"Strength", strength}, {"Stiffness", stiffness}};
  EXPECT_FALSE(make_gap_law("Bilinear Damage", glue)->bonds_later());
  Settings late = glue;
  late.push_back({"Bond on Touch", true});
  EXPECT_TRUE(make_gap_law("Bilinear Damage", late)->bonds_later());
}

TEST(DamageLawTest, TheCatalogueTakesWorkOrRange) {
  const auto by_work =
      make_gap_law("Bilinear Damage", {{"Work of Adhesion", work}, {"Strength", strength}, {"Stiffness", stiffness}});
  const auto by_range = make_gap_law(
      "Bilinear Damage", {{"Constants", "Range"}, {"Range", range}, {"Strength", strength}, {"Stiffness", stiffness}});
  for (const double r : {-0.1, 0.2, 0.6}) {
    EXPECT_NEAR(by_work->traction(r)[0], law.traction(r), 1e-16);
    EXPECT_NEAR(by_range->traction(r)[0], law.traction(r), 1e-16);
  }
  EXPECT_EQ(by_work->cut_off(2.0)->range(), by_work->range());
  EXPECT_EQ(test::refusal([&] { by_work->cut_off(1.0); }), "a law with a history cannot be cut off before it ends");
  test::expect_contains(
      test::refusal([] {
        make_gap_law("Bilinear Damage", {{"Work of Adhesion", 0.1}, {"Strength", 0.2}, {"Stiffness", 0.2}});
      }),
      "0.2 gives the gap of largest attraction s0/K = 1, which must be less than the range, 1: "
      "more than 0.2 is needed");
}

}  // namespace
}  // namespace ixos
