#include "rigid/rigid_body.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rigid/cayley.hpp"
#include "rigid/rigid_bodies.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

using Triple = std::array<double, 3>;

RigidBodyOptions brick() {
  RigidBodyOptions options;
  options.name = "Brick";
  options.mass = 2;
  options.inertia = {{{3, 0.1, 0}, {0.1, 4, -0.2}, {0, -0.2, 5}}};
  options.centre = {1, -2, 0.5};
  return options;
}

std::string refusal(const RigidBodyOptions& options, int dimension = 3) {
  return test::refusal([&] { RigidBody(options, dimension, false); });
}

TEST(RigidBodyTest, ItsUnknownsAreThoseOfItsSpace) {
  using Places = std::vector<std::size_t>;
  EXPECT_EQ(RigidBody(brick(), 3, false).free(), (Places{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(RigidBody(brick(), 2, false).free(), (Places{0, 1, 5}));
  EXPECT_EQ(RigidBody(brick(), 2, true).free(), (Places{1}));
  RigidBodyOptions held = brick();
  held.translates[1] = false;
  held.turns = {false, true, false};
  EXPECT_EQ(RigidBody(held, 3, false).free(), (Places{0, 2, 4}));
}

TEST(RigidBodyTest, ManyStepsAreOneRotation) {
  const RigidBody body(brick(), 3, false);
  std::array<double, RigidBody::numbers> u{};
  Small<double, 3> expected = rotation_matrix({});
  for (int step = 0; step < 50; ++step) {
    const Triple w{0.1 + 0.01 * step, -0.2, 0.3 * std::sin(step)};
    for (std::size_t i = 0; i < 3; ++i) u[RigidBody::turning + i] = body.length() * w[i];
    expected = product(expected, rotation_matrix(cayley_turn(w)));
    const Turn within = body.turn(u.data());
    body.begin_step(u.data());
    const Turn after = body.turn(u.data());
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        EXPECT_NEAR(within[i][j], after[i][j], 1e-14);
        EXPECT_NEAR(after[i][j] + (i == j ? 1 : 0), expected[i][j], 1e-13);
      }
  }
}

TEST(RigidBodyTest, InertiaAndItsSolutionAreInverse) {
  const RigidBody body(brick(), 3, false);
  const std::array<double, RigidBody::numbers> x{1, -2, 3, 0.4, 0.5, -0.6};
  std::array<double, RigidBody::numbers> y{}, again{};
  body.add_inertia(1, x.data(), y.data());
  body.solve_inertia(y.data(), again.data());
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], again[i], 1e-14);
  double twice = 0;
  for (std::size_t i = 0; i < x.size(); ++i) twice += x[i] * y[i];
  EXPECT_NEAR(body.kinetic_energy(x.data()), twice / 2, 1e-14);
}

/// A point mass m at distance r that turns with the body: L = m r x v.
TEST(RigidBodyTest, AngularMomentumIsThatOfItsPoints) {
  // Six point masses of 1/3 at a distance of 1 on the axes of the body: each axis is at that distance from four.
  RigidBodyOptions options = brick();
  options.inertia = {{{4.0 / 3, 0, 0}, {0, 4.0 / 3, 0}, {0, 0, 4.0 / 3}}};
  const RigidBody body(options, 3, false);
  std::array<double, RigidBody::numbers> u{0.5, 0.2, -0.1, 0.2, 0.4, -0.3}, v{0.3, -0.2, 0.6, 0.5, -0.7, 0.2};
  Triple expected{};
  const Turn turn = body.turn(u.data());
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      Triple own{};
      own[axis] = sign;
      const Triple place = sum(sum(body.centre(), RigidBody::triple(u.data())), turned(turn, own));
      const Triple velocity = sum(RigidBody::triple(v.data()), turned(turn, cross(body.spin(v.data()), own)));
      expected = sum(expected, cross(place, velocity), 1.0 / 3);
    }
  const Triple found = body.angular_momentum(u.data(), v.data());
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 1e-14);
}

TEST(RigidBodyTest, NumbersThatNoBodyHasAreRefused) {
  RigidBodyOptions options = brick();
  options.mass = -1;
  test::expect_contains(refusal(options), "\"Brick\" has the mass -1; it must be at least 0");
  options = brick();
  options.inertia[0][0] = 20;
  test::expect_contains(refusal(options), "a moment about an axis is at most the sum");
  options = brick();
  options.inertia[1][1] = -4;
  test::expect_contains(refusal(options), "its moments must be positive");
  options = brick();
  options.inertia[0][1] = 1;
  test::expect_contains(refusal(options), "it is not symmetric");
  options = brick();
  options.turns[0] = false;
  test::expect_contains(refusal(options), "turns about two axes of three");
  EXPECT_EQ(refusal(options, 2), "");
  options = brick();
  options.inertia[2][2] = 0;
  test::expect_contains(refusal(options, 2), "turns and has the inertia 0");
}

TEST(RigidBodiesTest, NamesAreOnce) {
  const RigidBody body(brick(), 3, false);
  test::expect_contains(test::refusal([&] { RigidBodies({body, body}); }), "two rigid bodies have the name \"Brick\"");
  test::expect_contains(test::refusal([&] { return RigidBodies({body}).find("Brisk"); }), "did you mean \"Brick\"?");
}

}  // namespace
}  // namespace ixos
