#include "element/elastic_kernel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "element/elastic_kernel_body.hpp"
#include "material/linear_elastic.hpp"
#include "material/neo_hooke.hpp"
#include "support/displacement_gradients.hpp"

namespace ixos {
namespace {

using test::ElasticKernel;

using test::Body;

template <class B>
class ElasticKernelTest : public testing::Test {};
using Bodies =
    testing::Types<Body<Quad4, NeoHooke>, Body<Hex8, NeoHooke>, Body<Quad4, LinearElastic>, Body<Hex8, LinearElastic>,
                   Body<Hex8C2, NeoHooke>, Body<Hex8CH, NeoHooke>, Body<Quad4C2, NeoHooke>, Body<Quad4C3, NeoHooke>,
                   Body<Quad4C4, NeoHooke>, Body<Quad4CH, NeoHooke>, Body<Quad9, NeoHooke>, Body<Hex27, NeoHooke>,
                   Body<Quad9, LinearElastic>, Body<Quad9C4, NeoHooke>>;
TYPED_TEST_SUITE(ElasticKernelTest, Bodies);

TYPED_TEST(ElasticKernelTest, WeightsSumToTheVolume) {
  // A parallelepiped: the square or cube of side 1 under I + H, of volume det(I + H).
  auto m = TypeParam::motion(0.0);
  for (std::size_t a = 0; a < TypeParam::N; ++a)
    for (std::size_t d = 0; d < TypeParam::D; ++d) m.x[a][d] -= TypeParam::wave(0.1, 0.0)[a][d];
  Small<double, TypeParam::D> h{};
  h[0][0] = 0.3;
  h[0][1] = 0.2;
  h[1][0] = -0.1;
  const auto u = TypeParam::affine(h, m.x);
  for (std::size_t a = 0; a < TypeParam::N; ++a)
    for (std::size_t d = 0; d < TypeParam::D; ++d) m.x[a][d] += u[a][d];
  double volume = 0;
  for (const auto& point : TypeParam::Kernel::geometry(TypeParam::table(), m.x).points) volume += point.weight;
  EXPECT_NEAR(volume, 1.3 * 1.0 + 0.2 * 0.1, 1e-14);
}

TYPED_TEST(ElasticKernelTest, ForceIsTheGradientOfTheEnergy) { test::expect_force_is_gradient<TypeParam>(); }

TYPED_TEST(ElasticKernelTest, TangentIsTheSymmetricDerivativeOfTheForce) {
  test::expect_tangent_is_derivative<TypeParam>();
}

/// The motion that starts at `share` of the step before its end.
template <class Motion>
Motion shortened(Motion m, double share) {
  for (std::size_t a = 0; a < m.to.size(); ++a)
    for (std::size_t d = 0; d < m.to[a].size(); ++d) m.from[a][d] = m.to[a][d] + share * (m.from[a][d] - m.to[a][d]);
  return m;
}

// Short steps are summed at once, longer ones point by point.
TYPED_TEST(ElasticKernelTest, StraightPathsGiveTheSumsOfTheirPoints) {
  const TypeParam body{};
  const Rule rule = gauss_rule(4);
  for (double share : {0.01, 0.3, 1.0}) {
    const auto m = shortened(TypeParam::motion(0.0), share);
    typename TypeParam::template Nodal<double> force{};
    Small<double, TypeParam::N * TypeParam::D> tangent{};
    for (const RulePoint& point : rule.points) {
      auto there = m;
      for (std::size_t a = 0; a < TypeParam::N; ++a)
        for (std::size_t d = 0; d < TypeParam::D; ++d)
          there.to[a][d] = point.from * m.from[a][d] + point.to * m.to[a][d];
      const auto f = body.force(there, end_rule());
      const auto k = body.tangent(there, end_rule());
      for (std::size_t a = 0; a < TypeParam::N; ++a)
        for (std::size_t d = 0; d < TypeParam::D; ++d) force[a][d] += point.weight * f[a][d];
      for (std::size_t r = 0; r < k.size(); ++r)
        for (std::size_t c = 0; c < k.size(); ++c) tangent[r][c] += point.weight * point.to * k[r][c];
    }
    const auto f = body.force(m, rule);
    const auto k = body.tangent(m, rule);
    for (std::size_t a = 0; a < TypeParam::N; ++a)
      for (std::size_t d = 0; d < TypeParam::D; ++d) EXPECT_NEAR(f[a][d], force[a][d], 1e-14) << share;
    for (std::size_t r = 0; r < k.size(); ++r)
      for (std::size_t c = 0; c < k.size(); ++c) EXPECT_NEAR(k[r][c], tangent[r][c], 1e-13) << share;
  }
}

TYPED_TEST(ElasticKernelTest, DiscreteGradientDoesTheWorkOfTheEnergyAndHasItsTangent) {
  test::expect_discrete_gradient<TypeParam>();
}

TYPED_TEST(ElasticKernelTest, PacksEqualDoublesLaneByLane) {
  for (const Rule& rule : {gauss_rule(3, Path::Kinematic), discrete_gradient_rule()}) {
    auto m = TypeParam::motion(0.0);
    const auto put = [](auto& target, const auto& values, std::size_t i) {
      for (std::size_t a = 0; a < values.size(); ++a)
        for (std::size_t d = 0; d < values[a].size(); ++d) target[a][d][i] = values[a][d];
    };
    typename TypeParam::template Motion<Pack> packed{};
    const auto phase = [](std::size_t i) { return static_cast<double>(i); };
    for (std::size_t i = 0; i < Pack::size(); ++i) {
      m = TypeParam::motion(phase(i));
      put(packed.x, m.x, i);
      put(packed.from, m.from, i);
      put(packed.velocity, m.velocity, i);
      put(packed.to, m.to, i);
    }
    const TypeParam body{};
    const Pack energy = body.energy(packed);
    const auto force = body.force(packed, rule);
    const auto tangent = body.tangent(packed, rule);
    for (std::size_t i = 0; i < Pack::size(); ++i) {
      m = TypeParam::motion(phase(i));
      EXPECT_NEAR(lane(energy, i), body.energy(m), 1e-13);
      const auto one_force = body.force(m, rule);
      const auto one_tangent = body.tangent(m, rule);
      for (std::size_t a = 0; a < TypeParam::N; ++a)
        for (std::size_t d = 0; d < TypeParam::D; ++d) EXPECT_NEAR(lane(force[a][d], i), one_force[a][d], 1e-13);
      for (std::size_t r = 0; r < tangent.size(); ++r)
        for (std::size_t c = 0; c < tangent.size(); ++c)
          EXPECT_NEAR(lane(tangent[r][c], i), one_tangent[r][c], 1e-14 * (10 + std::abs(one_tangent[r][c])));
    }
  }
}

TYPED_TEST(ElasticKernelTest, ConstantStressIsInEquilibriumOnADistortedElement) {
  const TypeParam body{};
  auto m = TypeParam::motion(0.0);
  const auto h = test::sample<TypeParam::D>(0.2, 0.2);
  Small<double, TypeParam::D> stress{};
  m.to = TypeParam::affine(h, m.x);
  body.material.stress(h, stress);
  double volume = 0;
  for (const auto& point : TypeParam::Kernel::geometry(TypeParam::table(), m.x).points) volume += point.weight;
  const auto f = body.force(m, end_rule());
  // The forces are in equilibrium, and their first moment about the origin is the stress times the volume.
  for (std::size_t i = 0; i < TypeParam::D; ++i) {
    double sum = 0;
    for (std::size_t a = 0; a < TypeParam::places; ++a) sum += f[a][i];
    EXPECT_NEAR(sum, 0.0, 1e-14);
    for (std::size_t j = 0; j < TypeParam::D; ++j) {
      double moment = 0;
      for (std::size_t a = 0; a < TypeParam::N; ++a) moment += f[a][i] * m.x[a][j];
      EXPECT_NEAR(moment, stress[i][j] * volume, 1e-14);
    }
  }
}

template <class B>
void expect_kept_sums() {
  using Kernel = typename B::Kernel;
  const B body{};
  const Rule rule = gauss_rule(4);
  for (double share : {0.01, 1.0}) {
    const auto m = shortened(B::motion(0.0), share);
    const auto geometry = Kernel::geometry(B::table(), m.x);
    const typename Kernel::template Segment<double> segment{&m.from, nullptr, &m.to};
    const std::size_t size = Kernel::template kept_size<double>(body.material, rule);
    EXPECT_EQ(size > 0, B::D == 2) << "in space it takes longer to write and read the sums";
    std::vector<double> kept(size * B::table().size() + 1);
    typename B::template Nodal<double> f{};
    const double least = Kernel::add_force(body.material, geometry, segment, rule, f, kept.data());
    EXPECT_EQ(least, body.least_jacobian(m, rule));
    EXPECT_EQ(f, body.force(m, rule));
    Small<double, B::N * B::D> k{};
    Kernel::add_tangent(body.material, geometry, segment, rule, k, kept.data());
    const auto expected = body.tangent(m, rule);
    for (std::size_t r = 0; r < k.size(); ++r)
      for (std::size_t c = 0; c < k.size(); ++c) EXPECT_NEAR(k[r][c], expected[r][c], 1e-14);
  }
}

TEST(NeoHookeElementTest, AForceKeepsTheSumsOfItsTangentOverAStraightPath) {
  expect_kept_sums<Body<Quad4, NeoHooke>>();
  expect_kept_sums<Body<Hex8, NeoHooke>>();
  expect_kept_sums<Body<Hex27, NeoHooke>>();
}

/// Frobenius norm of the difference of the tangent and the force's central difference quotients with step h.
template <class B>
double quotient_error(double h) {
  const B body{};
  const auto tangent = body.tangent(B::motion(0.0), end_rule());
  double sum = 0;
  for (std::size_t c = 0; c < tangent.size(); ++c) {
    auto ahead = B::motion(0.0), behind = B::motion(0.0);
    ahead.to[c / B::D][c % B::D] += h;
    behind.to[c / B::D][c % B::D] -= h;
    const auto after = body.force(ahead, end_rule()), before = body.force(behind, end_rule());
    for (std::size_t r = 0; r < tangent.size(); ++r) {
      const double quotient = (after[r / B::D][r % B::D] - before[r / B::D][r % B::D]) / (2 * h);
      sum += (quotient - tangent[r][c]) * (quotient - tangent[r][c]);
    }
  }
  return std::sqrt(sum);
}

TEST(NeoHookeElementTest, DifferenceQuotientsOfTheForceConvergeToTheTangentWithSecondOrder) {
  EXPECT_NEAR((quotient_error<Body<Quad4, NeoHooke>>(1e-2) / quotient_error<Body<Quad4, NeoHooke>>(1e-3)), 100.0, 2.0);
  EXPECT_NEAR((quotient_error<Body<Hex8, NeoHooke>>(1e-2) / quotient_error<Body<Hex8, NeoHooke>>(1e-3)), 100.0, 2.0);
}

template <class B>
void expect_no_response_to_rotation() {
  const double c = std::cos(2.0), s = std::sin(2.0);
  Small<double, B::D> h{};  // R - I, in the plane of the first and the last axis
  h[0][0] = h[B::D - 1][B::D - 1] = c - 1;
  h[0][B::D - 1] = -s;
  h[B::D - 1][0] = s;
  auto m = B::motion(0.0);
  m.to = B::affine(h, m.x);
  const B body{};
  EXPECT_NEAR(body.energy(m), 0.0, 1e-14);
  for (const auto& node : body.force(m, end_rule()))
    for (double value : node) EXPECT_NEAR(value, 0.0, 1e-14);
  EXPECT_NEAR(body.least_jacobian(m, end_rule()), 1.0, 1e-14);
}

TEST(NeoHookeElementTest, RigidRotationGivesNeitherForceNorEnergy) {
  expect_no_response_to_rotation<Body<Quad4, NeoHooke>>();
  expect_no_response_to_rotation<Body<Hex8, NeoHooke>>();
}

template <class B>
void expect_least_jacobian() {
  const B body{};
  auto m = B::motion(0.0);
  Small<double, B::D> h{};
  h[0][0] = -2.0;  // a mirror
  m.to = B::affine(h, m.x);
  EXPECT_NEAR(body.least_jacobian(m, end_rule()), -1.0, 1e-14);
  // Time points before the end count: half-way from a stretch of -0.6 to none, J = 0.2.
  h[0][0] = -1.6;
  m.from = B::affine(h, m.x);
  m.to = {};
  EXPECT_NEAR(body.least_jacobian(m, end_rule()), 1.0, 1e-14);
  EXPECT_NEAR(body.least_jacobian(m, point_rule({0.5, 1.0}, {0.5, 0.5})), 0.2, 1e-14);
  // Of the quadrature points the worst counts: one corner pushed far inside.
  m = B::motion(0.0);
  m.to = {};
  for (std::size_t d = 0; d < B::D; ++d) m.to[0][d] = -1.5 * m.x[0][d];
  EXPECT_LE(body.least_jacobian(m, end_rule()), 0.0);
}

TEST(NeoHookeElementTest, LeastJacobianIsThatOfAllPoints) {
  expect_least_jacobian<Body<Quad4, NeoHooke>>();
  expect_least_jacobian<Body<Hex8, NeoHooke>>();
}

}  // namespace
}  // namespace ixos
