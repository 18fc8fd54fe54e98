#include "base/symmetric_tensor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ixos {
namespace {

void expect_values(const std::array<double, 3>& found, double first, double second, double third) {
  EXPECT_NEAR(found[0], first, 1e-14);
  EXPECT_NEAR(found[1], second, 1e-14);
  EXPECT_NEAR(found[2], third, 1e-14);
}

TEST(SymmetricTensorTest, VonMisesStressIsTheUniaxialStressAndRootThreeTimesTheShear) {
  EXPECT_DOUBLE_EQ(von_mises({0, -2.5, 0, 0, 0, 0}), 2.5);
  for (std::size_t i = 3; i < 6; ++i) {
    SymmetricTensor shear{};
    shear[i] = 0.7;
    EXPECT_DOUBLE_EQ(von_mises(shear), std::sqrt(3.0) * 0.7);
  }
  // A pressure that is a power of two is lost without a trace.
  EXPECT_EQ(von_mises({1024.5, 1024, 1024, 0, 0, 0}), 0.5);
  EXPECT_EQ(von_mises({-3, -3, -3, 0, 0, 0}), 0);
}

TEST(SymmetricTensorTest, PrincipalValuesAreTheEigenvaluesFromTheLargestOn) {
  expect_values(principal_values({-2, 5, 1, 0, 0, 0}), 5, 1, -2);
  expect_values(principal_values({2, 2, -2, 1, 0, 0}), 3, 1, -2);   // in the plane x, y
  expect_values(principal_values({-2, 2, 2, 0, 1, 0}), 3, 1, -2);   // in the plane y, z
  expect_values(principal_values({2, -2, 2, 0, 0, -1}), 3, 1, -2);  // in the plane z, x
  // The matrix of second differences.
  expect_values(principal_values({2, 2, 2, -1, -1, 0}), 2 + std::sqrt(2.0), 2, 2 - std::sqrt(2.0));
}

TEST(SymmetricTensorTest, InvariantsAgree) {
  const SymmetricTensor stress{0.3, -1.2, 0.7, 0.4, -0.6, 0.9};
  const auto [first, second, third] = principal_values(stress);
  EXPECT_NEAR(first + second + third, 0.3 - 1.2 + 0.7, 1e-14);
  EXPECT_NEAR(von_mises({first, second, third, 0, 0, 0}), von_mises(stress), 1e-14);
}

TEST(SymmetricTensorTest, WhatIsNotFiniteHasNoPrincipalValues) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (double value : {nan, infinity})
    for (double principal : principal_values({1, 1, 1, value, 0, 0})) EXPECT_TRUE(std::isnan(principal));
}

}  // namespace
}  // namespace ixos
