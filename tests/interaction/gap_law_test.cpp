#include "interaction/gap_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "interaction/damage_law.hpp"
#include "interaction/van_der_waals.hpp"

namespace ixos {
namespace {

/// psi = k r^2/2. No two functions return the same value, so a test can tell which one was called.
struct Spring {
  static constexpr bool has_range = true;
  static constexpr GapDomain domain = GapDomain::All;

  template <class T>
  T energy(const T& r) const {
    return 0.5 * k * r * r;
  }
  template <class T>
  T traction(const T& r) const {
    return -k * r;
  }
  template <class T>
  T stiffness(const T& r) const {
    return k + 0.0 * r;
  }
  template <class T>
  T mean_traction(const T& r0, const T& r1) const {
    return -0.5 * k * (r0 + r1);
  }
  template <class T>
  T mean_stiffness(const T& r0, const T& /*r1*/) const {
    return 0.5 * k + 0.0 * r0;
  }
  template <class T>
  T mean_potential(const T& r0, const T& r1) const {
    return 0.25 * k * (r1 - r0) * (3.0 * r0 + r1);
  }
  template <class T>
  T magnitude(const T& r) const {
    return 7.0 * r * r;
  }
  bool repels() const { return false; }
  double equilibrium_gap() const { return 0.125; }
  double adhesion_gap() const { return 0.25; }
  double range() const { return 3; }

  double k = 8;
};

const VanDerWaals van_der_waals(2.5, 25);

/// Gaps from 0.2, one for each lane.
Pack gaps(double step) {
  return Pack([step](auto i) { return 0.2 + step * static_cast<double>(static_cast<std::size_t>(i)); });
}

/// Compares a law behind an interface with the class itself, in every lane.
template <class Interface, class Law>
void expect_same(const Interface& there, const Law& law) {
  const Pack r0 = gaps(0.07), r1 = gaps(0.13);
  for (std::size_t i = 0; i < Pack::size(); ++i) {
    const double a = lane(r0, i), b = lane(r1, i);
    const double slack = 1e-13 * (law.magnitude(a) + law.magnitude(b));  // packs may round otherwise
    EXPECT_NEAR(lane(there.energy(r1), i), law.energy(b), slack) << i;
    EXPECT_NEAR(lane(there.traction(r1), i), law.traction(b), slack) << i;
    EXPECT_NEAR(lane(there.stiffness(r1), i), law.stiffness(b), slack / b) << i;
    EXPECT_NEAR(lane(there.mean_traction(r0, r1), i), law.mean_traction(a, b), slack) << i;
    EXPECT_NEAR(lane(there.mean_stiffness(r0, r1), i), law.mean_stiffness(a, b), slack / a) << i;
    EXPECT_NEAR(lane(there.mean_potential(r0, r1), i), law.mean_potential(a, b), slack) << i;
    EXPECT_NEAR(lane(there.magnitude(r1), i), law.magnitude(b), slack) << i;
  }
  EXPECT_EQ(there.equilibrium_gap(), law.equilibrium_gap());
  EXPECT_EQ(there.adhesion_gap(), law.adhesion_gap());
}

TEST(GapLawTest, EveryCallReachesTheLaw) {
  expect_same(*gap_law(Spring()), Spring());
  expect_same(*gap_law(van_der_waals), van_der_waals);
  EXPECT_EQ(gap_law(Spring())->domain(), GapDomain::All);
  EXPECT_EQ(gap_law(van_der_waals)->domain(), GapDomain::Positive);
  EXPECT_FALSE(gap_law(Spring())->repels());
  EXPECT_TRUE(gap_law(van_der_waals)->repels());
}

TEST(GapLawTest, TheWorkOfAdhesionIsTheDepthOfThePotential) {
  EXPECT_EQ(work_of_adhesion(*gap_law(van_der_waals)), -van_der_waals.energy(van_der_waals.equilibrium_gap()));
  EXPECT_EQ(work_of_adhesion(*gap_law(Spring())), 0);
}

// The tractions of many points together are those of single points.
TEST(GapLawTest, ManyPointsGetTheSameLaw) {
  const DamageLaw damage(0.5, 0.05, 0.8);
  const Pack from[] = {gaps(0.07), gaps(0.3), gaps(0.9)}, to[] = {gaps(0.13), gaps(0.25), gaps(0.95)};
  const Pack history[] = {Pack(0.2), Pack(0.4), Pack(0.3)};
  const GapEnds<Pack> ends{3, to, from, nullptr};
  for (const Rule& rule : {end_rule(), gauss_rule(3), exact_rule()})
    for (const bool past : {false, true}) {
      const auto law = past ? gap_law(damage) : gap_law(van_der_waals);
      const Pack* const kept = past ? history : nullptr;
      Pack t[3], k[3], least_gap(1e300);
      EXPECT_TRUE(law->tractions(ends, rule, kept, t, least_gap));
      EXPECT_TRUE(law->stiffnesses(ends, rule, false, kept, k));
      for (std::size_t q = 0; q < 3; ++q) {
        const Pack* const own = past ? history + q : nullptr;
        Pack traction(0.0), stiffness(0.0);
        for (const RulePoint& point : rule.points) {
          const Pack r = point.from * from[q] + point.to * to[q];
          traction += point.weight * law->traction(r, own);
          stiffness += point.weight * point.to * law->stiffness(r, own);
        }
        if (rule.mean != Mean::Points) {
          traction += law->mean_traction(from[q], to[q], own);
          stiffness += law->mean_stiffness(from[q], to[q], own);
        }
        for (std::size_t i = 0; i < Pack::size(); ++i) {
          EXPECT_NEAR(lane(t[q], i), lane(traction, i), 1e-14 * std::abs(lane(traction, i))) << q;
          EXPECT_NEAR(lane(k[q], i), lane(stiffness, i), 1e-13 * std::abs(lane(stiffness, i))) << q;
        }
      }
    }
}

// Beyond its range a law does nothing, at some points or at all.
TEST(GapLawTest, PointsOutOfRangeHaveNoTraction) {
  const auto law = gap_law(Spring());
  const Pack gaps_of[] = {Pack(1.0), Pack(4.0)};
  Pack t[2], k[2], least_gap(1e300);
  EXPECT_TRUE(law->tractions({2, gaps_of}, end_rule(), nullptr, t, least_gap));
  EXPECT_EQ(lane(t[1], 0), 0);
  EXPECT_EQ(lane(least_gap, 0), 1) << "of points in range";
  EXPECT_FALSE(law->tractions({1, gaps_of + 1}, end_rule(), nullptr, t, least_gap));
  EXPECT_FALSE(law->stiffnesses({1, gaps_of + 1}, end_rule(), false, nullptr, k));
}

TEST(GapLawTest, TheRangeIsThatOfTheLaw) {
  EXPECT_EQ(gap_law(Spring())->range(), 3);
  EXPECT_EQ(gap_law(van_der_waals)->range(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(gap_law(van_der_waals)->cut_off(2)->range(), 2);
}

TEST(GapLawTest, ARangeBeyondThatOfTheLawChangesNothing) {
  const auto law = gap_law(Spring());
  EXPECT_EQ(law->cut_off(3)->range(), 3);
  EXPECT_EQ(law->cut_off(5)->range(), 3);
  EXPECT_EQ(law->cut_off(5)->traction(2)[0], law->traction(2)[0]);
  EXPECT_EQ(law->cut_off(2)->range(), 2);
}

TEST(GapLawTest, TheLawCanBeFoundAgain) {
  const auto law = gap_law(van_der_waals);
  const auto* own = dynamic_cast<const GapLawOf<VanDerWaals>*>(law.get());
  ASSERT_NE(own, nullptr);
  EXPECT_EQ(own->law().c1(), van_der_waals.c1());
  EXPECT_NE(dynamic_cast<const GapLawOf<CutOff<VanDerWaals>>*>(law->cut_off(2).get()), nullptr);
}

TEST(GapLawTest, ACutOffEndsTheTraction) {
  const auto law = gap_law(van_der_waals)->cut_off(2);
  EXPECT_NEAR(law->traction(0.5)[0], van_der_waals.traction(0.5) - van_der_waals.traction(2.0),
              1e-13 * van_der_waals.magnitude(0.5));
  EXPECT_EQ(law->traction(2.5)[0], 0);
}

// A law cut off at 1 and then at 3 would be zero from 1 on if the second range did not take the place of the first.
TEST(GapLawTest, ANewRangeReplacesTheOldOne) {
  for (double range : {0.5, 3.0}) {
    const auto once = gap_law(van_der_waals)->cut_off(range);
    const auto twice = gap_law(van_der_waals)->cut_off(1)->cut_off(range);
    EXPECT_EQ(twice->range(), range);
    for (double r : {0.3, 0.4, 0.8, 2.0, 3.5}) {
      EXPECT_EQ(twice->traction(r)[0], once->traction(r)[0]) << r;
      EXPECT_EQ(twice->energy(r)[0], once->energy(r)[0]) << r;
    }
  }
}

}  // namespace
}  // namespace ixos
