#include "rigid/cayley.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ixos {
namespace {

using Triple = std::array<double, 3>;

const Triple w{0.3, -0.8, 0.5}, rate{1.1, 0.4, -0.7}, acceleration{-0.2, 0.9, 0.6};

Triple at(double t) { return sum(sum(w, rate, t), acceleration, t * t / 2); }

/// Returns the vector of an antisymmetric matrix.
Triple axial(const Small<double, 3>& m) { return {m[2][1], m[0][2], m[1][0]}; }

/// Returns Q^T Q' from central differences.
Triple spin_at(double t) {
  const double h = 1e-5;
  const Turn before = cayley_turn(at(t - h)), after = cayley_turn(at(t + h));
  Small<double, 3> rate_of_q;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) rate_of_q[i][j] = (after[i][j] - before[i][j]) / (2 * h);
  const Small<double, 3> q = rotation_matrix(cayley_turn(at(t)));
  Small<double, 3> product{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) product[i][j] += q[k][i] * rate_of_q[k][j];
  return axial(product);
}

void expect_near(const Triple& a, const Triple& b, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance);
}

TEST(CayleyTest, ItIsARotationByTwiceTheArcTangentOfHalfTheLength) {
  const Turn turn = cayley_turn(w);
  const double length = std::sqrt(dot(w, w));
  const Turn rodrigues = turn_about(scaled(1 / length, w), 2 * std::atan(length / 2));
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(turn[i][j], rodrigues[i][j], 1e-15);
}

TEST(CayleyTest, ItsMeanJoinsTheVectorToTheDifference) {
  const Turn turn = cayley_turn(w);
  const Triple x{0.2, 1.3, -0.4}, across = cross(w, x);
  // (Q - I) x = (I + Q)/2 (w x x)
  expect_near(times(turn, x), sum(across, times(turn, across), 0.5), 1e-15);
}

TEST(CayleyTest, SpinsAreThoseOfTheRotation) {
  expect_near(cayley_spin(w, rate), spin_at(0), 1e-9);
  const double h = 1e-3;
  const Triple change = scaled(1 / (2 * h), sum(spin_at(h), spin_at(-h), -1));
  expect_near(cayley_spin_rate(w, rate, acceleration), change, 1e-5);
}

TEST(CayleyTest, ForcesDoTheWorkOfMoments) {
  const Triple moment{0.7, -0.1, 0.4};
  EXPECT_NEAR(dot(cayley_force(w, moment), rate), dot(moment, cayley_spin(w, rate)), 1e-15);
  expect_near(cayley_moment(w, cayley_force(w, moment)), moment, 1e-15);
}

TEST(CayleyTest, SmallRotationsKeepTheirDigits) {
  EXPECT_DOUBLE_EQ(cayley_turn(Triple{0, 0, 1e-9})[0][0], -0.5e-18);
  EXPECT_DOUBLE_EQ(cayley_turn(Triple{0, 0, 1e-9})[1][0], 1e-9);
}

}  // namespace
}  // namespace ixos
