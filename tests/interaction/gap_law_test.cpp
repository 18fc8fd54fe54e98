#include "interaction/gap_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

TEST(GapLawTest, KernelsSeeTheSameLaw) {
  expect_same(AnyGapLaw(gap_law(Spring())), Spring());
  expect_same(AnyGapLaw(gap_law(van_der_waals)), van_der_waals);
  EXPECT_EQ(AnyGapLaw(gap_law(Spring())).domain, GapDomain::All);
  EXPECT_EQ(AnyGapLaw(gap_law(van_der_waals)).domain, GapDomain::Positive);
  EXPECT_EQ(AnyGapLaw(gap_law(Spring())).range(), 3);
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

TEST(GapLawTest, KernelsKeepTheLawAlive) {
  auto law = gap_law(Spring());
  const std::weak_ptr<const GapLaw> watch = law;
  {
    const AnyGapLaw kept(law);
    law.reset();
    EXPECT_FALSE(watch.expired());
    EXPECT_EQ(kept.traction(0.5)[0], -4);
  }
  EXPECT_TRUE(watch.expired());
}

}  // namespace
}  // namespace ixos
