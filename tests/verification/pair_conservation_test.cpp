// What two bodies that collide off centre keep over 2,000 steps, through contact.
#include <gtest/gtest.h>

#include <cstdio>

#include "verification/collision.hpp"

namespace ixos {
namespace {

using test::Collision;
using test::count;
using test::number;

const std::string in_space = count("Surface Points", 3) + number("Cutoff", 2);
constexpr int steps = 2000;

const Mesh& rings() {
  static const Mesh mesh = test::two_rings(3, 2.2, {6.1, 2.4}, 32, 2);
  return mesh;
}
const Mesh& balls() {
  static const Mesh mesh = test::two_balls(3, {6.1, 1.9, 1.5}, 4, 1);
  return mesh;
}

/// Takes the steps, and prints the errors.
test::KeptErrors errors_of(const char* what, Collision collision, double dt) {
  const test::KeptErrors errors = test::kept_errors(collision, dt, steps);
  if (test::world()->getRank() == 0)
    std::printf("%s: energy %.1e, linear momentum %.1e, angular momentum %.1e, least gap %.3f\n", what, errors.energy,
                errors.linear, errors.angular, errors.least_gap);
  EXPECT_LT(errors.least_gap, 0.25) << what;
  return errors;
}

TEST(PairConservationLongTest, EnergyMomentumKeepsEnergyAndBothMomenta) {
  const auto expect_all = [](const test::KeptErrors& errors) {
    EXPECT_LT(errors.energy, 1e-11);
    EXPECT_LT(errors.linear, 1e-11);
    EXPECT_LT(errors.angular, 1e-11);
  };
  expect_all(errors_of("rings", Collision("Energy-Momentum", 0.001, "", "", rings()), 0.001));
  expect_all(errors_of("balls", Collision("Energy-Momentum", 0.001, "", in_space, balls()), 0.001));
}

TEST(PairConservationLongTest, TheAverageVectorFieldKeepsEnergyAndLinearMomentum) {
  const auto expect_both = [](const test::KeptErrors& errors) {
    EXPECT_LT(errors.energy, 1e-7);
    EXPECT_LT(errors.linear, 1e-12);
  };
  const std::string points = count("Interaction Points", 8);
  expect_both(errors_of("rings", Collision("Average Vector Field", 0.001, points, "", rings()), 0.001));
  expect_both(errors_of("balls", Collision("Average Vector Field", 0.001, points, in_space, balls()), 0.001));
}

}  // namespace
}  // namespace ixos
