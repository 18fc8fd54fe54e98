#include "interaction/smoothed_slip.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ixos {
namespace {

using Slip = SmoothedSlip<double, 3>;
using Vector = Slip::Vector;

constexpr double length = 0.2, threshold = 0.5;
const Slip slip(length, threshold);
const Small<double, 3> plane{{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}};
const Vector slips[] = {{}, {1e-9, 0, 0}, {0.05, -0.03, 0}, {0.19, 0.0, 0}, {0.15, 0.2, 0}, {-2, 1, 0}};

TEST(SmoothedSlipTest, GrowsToTheThreshold) {
  EXPECT_EQ(slip.at({}, plane).traction, Vector{});
  EXPECT_NEAR(slip.at({0.1, 0, 0}, plane).traction[0], threshold * 0.75, 1e-16);
  EXPECT_NEAR(slip.at({0.3, 0.4, 0}, plane).traction[1], threshold * 0.8, 1e-16);
  EXPECT_NEAR(slip.energy({length, 0, 0}), threshold * length * 2 / 3, 1e-16);
  EXPECT_NEAR(slip.energy({5, 0, 0}), threshold * (5 - length / 3), 1e-15);
}

TEST(SmoothedSlipTest, TheMeanDoesTheWorkOfThePotential) {
  for (const Vector& q : slips)
    EXPECT_NEAR(inner(slip.mean(q, plane).traction, q), slip.energy(q), 1e-15 * (1 + slip.energy(q)));
}

TEST(SmoothedSlipTest, DerivativesAreDifferences) {
  const double h = 1e-6;
  for (const Vector& q : slips) {
    const auto mean = slip.mean(q, plane), at = slip.at(q, plane);
    for (std::size_t j = 0; j < 2; ++j) {
      Vector ahead = q, behind = q;
      ahead[j] += h;
      behind[j] -= h;
      EXPECT_NEAR((slip.energy(ahead) - slip.energy(behind)) / (2 * h), at.traction[j], 1e-6);
      EXPECT_NEAR((slip.mean_potential(ahead) - slip.mean_potential(behind)) / (2 * h), mean.traction[j], 1e-6);
      const auto a = slip.at(ahead, plane), b = slip.at(behind, plane);
      const auto c = slip.mean(ahead, plane), d = slip.mean(behind, plane);
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR((a.traction[i] - b.traction[i]) / (2 * h), at.stiffness[i][j], 3e-5);
        EXPECT_NEAR((c.traction[i] - d.traction[i]) / (2 * h), mean.stiffness[i][j], 3e-5);
      }
    }
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(threshold * at.by_threshold[i], at.traction[i], 1e-16);
      EXPECT_NEAR(threshold * mean.by_threshold[i], mean.traction[i], 1e-16);
    }
  }
}

}  // namespace
}  // namespace ixos
