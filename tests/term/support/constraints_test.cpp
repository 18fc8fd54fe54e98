#include "term/support/constraints.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/error.hpp"

namespace ixos {
namespace {

TEST(ConstraintsSerialTest, OneMotionADegreeOfFreedom) {
  Constraints constraints;
  const auto motion = sine(0, 1, 1, 0);
  constraints.add(4, 2.0, motion);
  constraints.add(4, 2.0, motion);
  constraints.add(7, 1.0, nullptr);
  EXPECT_EQ(constraints.dofs(), (std::vector<int>{4, 7}));
  EXPECT_TRUE(constraints.holds(4));
  EXPECT_FALSE(constraints.holds(5));
  EXPECT_FALSE(constraints.holds(100));
  EXPECT_THROW(constraints.add(4, 1.0, motion), InputError);
  EXPECT_THROW(constraints.add(4, 2.0, nullptr), InputError);
  std::vector<double> u(8, 9.0), v(8, 9.0), a(8, 9.0);
  constraints.set(0.1, u.data(), v.data(), a.data());
  const double w = 2 * M_PI;
  EXPECT_NEAR(u[4], 2 * std::sin(0.1 * w), 1e-15);
  EXPECT_NEAR(v[4], 2 * w * std::cos(0.1 * w), 1e-14);
  EXPECT_NEAR(a[4], -2 * w * w * std::sin(0.1 * w), 1e-13);
  EXPECT_EQ(u[7], 0);
  EXPECT_EQ(u[5], 9);
}

TEST(ConstraintsSerialTest, SomethingMovesOnceAMotionIsAdded) {
  Constraints constraints;
  EXPECT_TRUE(constraints.empty());
  EXPECT_FALSE(constraints.holds(0));
  constraints.add(0, 1.0, nullptr);
  EXPECT_FALSE(constraints.empty());
  EXPECT_FALSE(constraints.driven());
  constraints.add(1, 0.0, sine(0, 1, 1, 0));
  EXPECT_TRUE(constraints.driven());
}

TEST(ConstraintsSerialTest, OneMotionDrivesManyDegreesOfFreedomByTheirFactors) {
  Constraints constraints;
  const auto motion = rate_ramp(2.0, 0.0, 0.0, RampShape::Linear);  // 2 t
  for (int dof : {3, 0, 2}) constraints.add(dof, 0.5 * dof, motion);
  std::vector<double> u(4, -1.0), v(4, -1.0);
  constraints.set(3.0, u.data(), nullptr, nullptr);
  EXPECT_EQ(u, (std::vector<double>{0, -1, 6, 9}));
  constraints.set(3.0, nullptr, v.data(), nullptr);
  EXPECT_EQ(v, (std::vector<double>{0, -1, 2, 3}));
}

TEST(ConstraintsSerialTest, MotionsAddUp) {
  Constraints constraints;
  const auto first = rate_ramp(2.0, 0.0, 0.0, RampShape::Linear);  // 2 t
  const auto second = constant(5.0);
  constraints.add(1, {{3.0, first}, {-1.0, second}});
  constraints.add(1, {{3.0, first}, {-1.0, second}});
  constraints.add(2, {});
  constraints.add(3, 1.0, first);
  EXPECT_EQ(constraints.dofs(), (std::vector<int>{1, 2, 3}));
  EXPECT_THROW(constraints.add(1, {{3.0, first}}), InputError);
  EXPECT_THROW(constraints.add(1, 3.0, first), InputError);
  EXPECT_THROW(constraints.add(3, {}), InputError);
  EXPECT_NO_THROW(constraints.add(2, {}));
  EXPECT_NO_THROW(constraints.add(2, 1.0, nullptr));
  std::vector<double> u(4, 9.0), v(4, 9.0);
  constraints.set(4.0, u.data(), v.data(), nullptr);
  EXPECT_EQ(u, (std::vector<double>{9, 3 * 8 - 5, 0, 8}));
  EXPECT_EQ(v, (std::vector<double>{9, 6, 0, 2}));
}

TEST(ConstraintsSerialTest, AnUndefinedMotionIsNotFinite) {
  Constraints constraints;
  constraints.add(0, 1.0, nullptr);
  EXPECT_TRUE(constraints.are_finite(2.0));
  constraints.add(1, 1.0, expression("1/(t-2)", "-1/(t-2)^2", "2/(t-2)^3"));
  EXPECT_TRUE(constraints.are_finite(1.0));
  EXPECT_FALSE(constraints.are_finite(2.0));
  // A derivative counts too: sqrt(t + 1) has none at -1.
  Constraints rooted;
  rooted.add(0, 1.0, expression("sqrt(t+1)", "0.5/sqrt(t+1)", "-0.25/(t+1)^1.5"));
  EXPECT_TRUE(rooted.are_finite(1.0));
  EXPECT_FALSE(rooted.are_finite(-1.0));
}

TEST(ConstraintsSerialTest, PlanesAndMotionsAcrossThemExcludeEachOther) {
  const auto motion = sine(0, 1, 1, 0);
  Constraints first;
  first.hold_in_plane(1, 2, {1, 1, 0});
  EXPECT_FALSE(first.empty());
  EXPECT_FALSE(first.holds(2));
  EXPECT_THROW(first.add(2, 1.0, motion), InputError);
  EXPECT_NO_THROW(first.add(0, 1.0, motion));  // of another node
  first.add(3, 0.0, nullptr);                  // held at zero: so is the other component, by the plane
  EXPECT_EQ(first.planes().normals(1), (std::vector<Vec<3>>{{1, 0, 0}}));
  Constraints second;
  second.add(2, 1.0, motion);
  EXPECT_THROW(second.hold_in_plane(1, 2, {1, 1, 0}), InputError);
  EXPECT_NO_THROW(second.hold_in_plane(1, 2, {0, 1, 0}));
}

}  // namespace
}  // namespace ixos
