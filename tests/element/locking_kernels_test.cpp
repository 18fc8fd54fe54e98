// The kernels against locking: derivatives of one energy, the patch test, what they refuse.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "element/locking_body.hpp"
#include "support/displacement_gradients.hpp"

namespace ixos {
namespace {

using test::Mean;
using test::Modes;

std::vector<Rule> rules() {
  return {end_rule(), gauss_rule(3, Path::Linear), gauss_rule(2, Path::Kinematic),
          point_rule({0.0, 1.0}, {0.5, 0.5}, Path::Kinematic)};
}

template <class B>
class LockingKernelsTest : public testing::Test {};
using Bodies =
    testing::Types<Mean<Quad4, NeoHooke>, Mean<Hex8, NeoHooke>, Mean<Quad4, LinearElastic>, Mean<Hex8, LinearElastic>,
                   Mean<Quad4C2, NeoHooke>, Mean<Quad4C3, NeoHooke>, Mean<Quad4CH, NeoHooke>, Mean<Quad9, NeoHooke>,
                   Mean<Quad9, LinearElastic>, Mean<Hex27, NeoHooke>, Mean<Quad9C4, NeoHooke>, Modes<Quad4, NeoHooke>,
                   Modes<Hex8, NeoHooke>, Modes<Quad4, LinearElastic>, Modes<Hex8, LinearElastic>>;
TYPED_TEST_SUITE(LockingKernelsTest, Bodies);

TYPED_TEST(LockingKernelsTest, ForceIsTheGradientOfTheEnergy) {
  const TypeParam body{};
  const typename TypeParam::Variable energy = body.energy(TypeParam::seeded(body.to));
  const auto force = body.force(body.to);
  EXPECT_GT(energy.val(), 0.0);
  for (std::size_t r = 0; r < TypeParam::N * TypeParam::D; ++r)
    EXPECT_NEAR(force[r / TypeParam::D][r % TypeParam::D], energy.dx(static_cast<int>(r)), 1e-13) << r;
}

TYPED_TEST(LockingKernelsTest, TangentIsTheSymmetricDerivativeOfTheForce) {
  const TypeParam body{};
  for (const Rule& rule : rules()) {
    const auto force = body.force(TypeParam::seeded(body.to), rule);
    const auto tangent = body.tangent(body.to, rule);
    for (std::size_t r = 0; r < tangent.size(); ++r)
      for (std::size_t c = 0; c < tangent.size(); ++c) {
        const double derivative = force[r / TypeParam::D][r % TypeParam::D].dx(static_cast<int>(c));
        EXPECT_NEAR(tangent[r][c], derivative, 1e-12) << r << ' ' << c << ", " << rule.points.size() << " points";
        EXPECT_NEAR(tangent[r][c], tangent[c][r], 1e-14) << r << ' ' << c;
      }
  }
}

/// The derivative in `t` at 0, by differences of sixth order.
template <class F>
auto slope(const F& f, double h = 2e-3) {
  return (45 * (f(h) - f(-h)) - 9 * (f(2 * h) - f(-2 * h)) + (f(3 * h) - f(-3 * h))) / (60 * h);
}

// Automatic differentiation takes an iteration more for the enhanced modes; differences see what runs see.
TYPED_TEST(LockingKernelsTest, ForceAndTangentAreTheSlopesOfEnergyAndForceAsRunsSeeThem) {
  const TypeParam body{};
  const auto direction = TypeParam::wave(0.3, 5.0);
  const auto moved = [&](double t) {
    auto u = body.to;
    for (std::size_t a = 0; a < TypeParam::N; ++a)
      for (std::size_t d = 0; d < TypeParam::D; ++d) u[a][d] += t * direction[a][d];
    return u;
  };
  const auto power = [&](double t) {
    const auto f = body.force(moved(t));
    double sum = 0;
    for (std::size_t a = 0; a < TypeParam::N; ++a)
      for (std::size_t d = 0; d < TypeParam::D; ++d) sum += f[a][d] * direction[a][d];
    return sum;
  };
  EXPECT_NEAR(power(0), slope([&](double t) { return body.energy(moved(t)); }), 2e-10);
  const auto tangent = body.tangent(body.to);
  double quadratic = 0;
  for (std::size_t r = 0; r < tangent.size(); ++r)
    for (std::size_t c = 0; c < tangent.size(); ++c)
      quadratic +=
          direction[r / TypeParam::D][r % TypeParam::D] * tangent[r][c] * direction[c / TypeParam::D][c % TypeParam::D];
  EXPECT_NEAR(quadratic, slope(power), 2e-9);
}

TYPED_TEST(LockingKernelsTest, HomogeneousStatesOfADistortedElementAreThoseOfTheStandardKernel) {
  TypeParam body{};
  const auto h = test::sample<TypeParam::D>(0.2, 0.2);
  const auto u = TypeParam::affine(h, body.x);
  const auto force = body.force(u), expected = body.template force<typename TypeParam::Standard>(u);
  for (std::size_t a = 0; a < TypeParam::N; ++a)
    for (std::size_t d = 0; d < TypeParam::D; ++d) EXPECT_NEAR(force[a][d], expected[a][d], 1e-14);
  const auto geometry = TypeParam::Standard::geometry(TypeParam::table(), body.x);
  EXPECT_NEAR(body.energy(u), TypeParam::Standard::energy(body.law, geometry, u), 1e-14);
  const auto own_geometry = TypeParam::Kernel::geometry(TypeParam::table(), body.x);
  const auto expect_mean = [&](const auto& value) {
    const auto mean = test::mean_of<typename TypeParam::Kernel>(body.law, own_geometry, u, value);
    const auto standard = test::mean_of<typename TypeParam::Standard>(body.law, geometry, u, value), exact = value(h);
    for (std::size_t i = 0; i < mean.size(); ++i) {
      EXPECT_NEAR(mean[i], exact[i], 1e-14) << i;
      EXPECT_NEAR(standard[i], exact[i], 1e-14) << i;
    }
  };
  expect_mean([&](const auto& gradient) { return invariants(body.law, gradient); });
  expect_mean([&](const auto& gradient) { return cauchy_stress(body.law, gradient, TypeParam::Law::can_invert); });
}

TYPED_TEST(LockingKernelsTest, SmallDisplacementsKeepTheirDigits) {
  const TypeParam body{};
  const double size = 1e-9;
  auto u = body.to;
  for (auto& node : u)
    for (double& value : node) value *= size;
  const auto tangent = body.tangent(typename TypeParam::template Nodal<double>{});
  const auto force = body.force(u);
  double quadratic = 0;
  for (std::size_t r = 0; r < tangent.size(); ++r) {
    double expected = 0;
    for (std::size_t c = 0; c < tangent.size(); ++c)
      expected += tangent[r][c] * body.to[c / TypeParam::D][c % TypeParam::D];
    quadratic += 0.5 * expected * body.to[r / TypeParam::D][r % TypeParam::D];
    EXPECT_NEAR(force[r / TypeParam::D][r % TypeParam::D] / size, expected, 1e-8);
  }
  EXPECT_NEAR(body.energy(u) / (size * size), quadratic, 1e-8 * quadratic);
}

TYPED_TEST(LockingKernelsTest, PacksEqualDoublesLaneByLane) {
  const Rule rule = gauss_rule(2, Path::Kinematic);
  using Nodal = typename TypeParam::template Nodal<Pack>;
  Nodal x{}, from{}, velocity{}, to{};
  std::vector<TypeParam> bodies(static_cast<std::size_t>(pack_width));
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    // From small strains to large ones, so that lanes take different numbers of iterations.
    const double phase = 0.9 * static_cast<double>(i);
    bodies[i].from = TypeParam::wave(0.008 * static_cast<double>(i), phase);
    bodies[i].velocity = TypeParam::wave(0.02, phase + 2);
    bodies[i].to = TypeParam::wave(0.008 * static_cast<double>(i), phase + 1);
    for (std::size_t a = 0; a < TypeParam::N; ++a)
      for (std::size_t d = 0; d < TypeParam::D; ++d) {
        x[a][d][i] = bodies[i].x[a][d];
        from[a][d][i] = bodies[i].from[a][d];
        velocity[a][d][i] = bodies[i].velocity[a][d];
        to[a][d][i] = bodies[i].to[a][d];
      }
  }
  const auto geometry = TypeParam::Kernel::geometry(TypeParam::table(), x);
  Nodal force{};
  typename TypeParam::template Matrix<Pack> tangent{};
  const auto law = bodies[0].law;
  const Pack jacobian = TypeParam::Kernel::add_force(law, geometry, {&from, &velocity, &to}, rule, force);
  TypeParam::Kernel::add_tangent(law, geometry, {&from, &velocity, &to}, rule, tangent);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    EXPECT_NEAR(lane(jacobian, i), bodies[i].least_jacobian(bodies[i].to, rule), 1e-13);
    const auto one_force = bodies[i].force(bodies[i].to, rule);
    const auto one_tangent = bodies[i].tangent(bodies[i].to, rule);
    for (std::size_t a = 0; a < TypeParam::N; ++a)
      for (std::size_t d = 0; d < TypeParam::D; ++d) EXPECT_NEAR(lane(force[a][d], i), one_force[a][d], 1e-13);
    for (std::size_t r = 0; r < tangent.size(); ++r)
      for (std::size_t c = 0; c < tangent.size(); ++c) EXPECT_NEAR(lane(tangent[r][c], i), one_tangent[r][c], 1e-12);
  }
}

template <class B>
void expect_no_response_to_rotation(double tolerance = 1e-14) {
  const double c = std::cos(2.0), s = std::sin(2.0);
  Small<double, B::D> rotation{};
  for (std::size_t d = 0; d < B::D; ++d) rotation[d][d] = 1.0;
  rotation[0][0] = rotation[B::D - 1][B::D - 1] = c;
  rotation[0][B::D - 1] = -s;
  rotation[B::D - 1][0] = s;
  const B body{};
  const auto turned = [&](const typename B::template Nodal<double>& u) {
    auto place = body.x;
    for (std::size_t a = 0; a < B::N; ++a)
      for (std::size_t d = 0; d < B::D; ++d) place[a][d] += u[a][d];
    auto result = B::affine(rotation, place);
    for (std::size_t a = 0; a < B::N; ++a)
      for (std::size_t d = 0; d < B::D; ++d) result[a][d] -= body.x[a][d];
    return result;
  };
  const auto rotated = turned({});
  EXPECT_NEAR(body.energy(rotated), 0.0, tolerance);
  for (const auto& node : body.force(rotated))
    for (double value : node) EXPECT_NEAR(value, 0.0, tolerance);
  EXPECT_NEAR(body.least_jacobian(rotated), 1.0, tolerance);
  // A deformation and then the rotation: the forces turn along.
  const auto force = body.force(turned(body.to)), expected = B::affine(rotation, body.force(body.to));
  EXPECT_NEAR(body.energy(turned(body.to)), body.energy(body.to), tolerance);
  for (std::size_t a = 0; a < B::N; ++a)
    for (std::size_t d = 0; d < B::D; ++d) EXPECT_NEAR(force[a][d], expected[a][d], tolerance);
}

TEST(LockingKernelTest, RotationsChangeNothing) {
  expect_no_response_to_rotation<Mean<Quad4, NeoHooke>>();
  expect_no_response_to_rotation<Mean<Hex8, NeoHooke>>();
  // Gradients of quadratic elements sum more terms.
  expect_no_response_to_rotation<Mean<Quad9, NeoHooke>>(1e-13);
  expect_no_response_to_rotation<Mean<Quad9C4, NeoHooke>>(1e-13);
  expect_no_response_to_rotation<Mean<Hex27, NeoHooke>>(1e-13);
  expect_no_response_to_rotation<Modes<Quad4, NeoHooke>>();
  expect_no_response_to_rotation<Modes<Hex8, NeoHooke>>();
}

template <class B>
void expect_refusal_of_inversion() {
  const B body{};
  Small<double, B::D> h{};
  h[0][0] = -2.0;  // a mirror
  EXPECT_LE(body.least_jacobian(B::affine(h, body.x)), 0.0);
  // Points before the end count, and the end that is no point.
  h[0][0] = -1.6;
  B halfway{};
  halfway.from = B::affine(h, body.x);
  EXPECT_NEAR(halfway.least_jacobian({}, point_rule({0.5, 1.0}, {0.5, 0.5})), 0.2, 1e-14);
  EXPECT_LE(halfway.least_jacobian(halfway.from, point_rule({0.5}, {1.0})), 0.0);
  // One corner pushed far inside.
  auto u = typename B::template Nodal<double>{};
  for (std::size_t d = 0; d < B::D; ++d) u[0][d] = -1.5 * body.x[0][d];
  EXPECT_LE(body.least_jacobian(u), 0.0);
}

TEST(LockingKernelTest, InvertedElementsAreRefused) {
  expect_refusal_of_inversion<Mean<Quad4, NeoHooke>>();
  expect_refusal_of_inversion<Mean<Hex8, NeoHooke>>();
  expect_refusal_of_inversion<Mean<Quad9, NeoHooke>>();
  expect_refusal_of_inversion<Mean<Hex27, NeoHooke>>();
  expect_refusal_of_inversion<Modes<Quad4, NeoHooke>>();
  expect_refusal_of_inversion<Modes<Hex8, NeoHooke>>();
}

// Far from incompressible states the modes have no minimum: the element says so instead of giving some number.
TEST(LockingKernelTest, EnhancedElementsThatFindNoMinimumAreRefused) {
  Modes<Hex8, NeoHooke> body{};
  EXPECT_GT(body.least_jacobian(body.to), 0.0);
  body.law = {lame_constants(1.0, 0.4999)};
  EXPECT_LE(body.least_jacobian(body.to), 0.0);
  EXPECT_TRUE(std::isnan(body.energy(body.to)));
}

}  // namespace
}  // namespace ixos
