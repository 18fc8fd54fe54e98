#include "material/linear_elastic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

#include "support/displacement_gradients.hpp"

namespace ixos {
namespace {

constexpr double youngs_modulus = 2.5;
constexpr double poissons_ratio = 0.3;
constexpr Lame lame = lame_constants(youngs_modulus, poissons_ratio);
constexpr LinearElastic material{lame};

using test::sample;

TEST(LameTest, ConstantsGiveYoungsModulusAndPoissonsRatioBack) {
  EXPECT_NEAR(lame.mu * (3 * lame.lambda + 2 * lame.mu) / (lame.lambda + lame.mu), youngs_modulus, 1e-15);
  EXPECT_NEAR(lame.lambda / (2 * (lame.lambda + lame.mu)), poissons_ratio, 1e-15);
  EXPECT_EQ(lame_constants(1.0, 0.0).lambda, 0.0);
}

TEST(LinearElasticTest, UniaxialStressStretchesByYoungsModulus) {
  Small<double, 3> h{}, p{};
  h[0][0] = 0.1;
  h[1][1] = h[2][2] = -poissons_ratio * 0.1;
  EXPECT_EQ(material.stress(h, p), 1.0);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(p[i][j], i + j == 0 ? 0.1 * youngs_modulus : 0.0, 1e-15);
}

template <class D>
class LinearElasticDimensionsTest : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<std::size_t, 2>, std::integral_constant<std::size_t, 3>>;
TYPED_TEST_SUITE(LinearElasticDimensionsTest, Dimensions);

TYPED_TEST(LinearElasticDimensionsTest, UniaxialStrain) {
  constexpr std::size_t D = TypeParam::value;
  Small<double, D> h{}, p{};
  h[1][1] = 0.1;
  material.stress(h, p);
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) {
      const double expected = i != j ? 0.0 : i == 1 ? (lame.lambda + 2 * lame.mu) * 0.1 : lame.lambda * 0.1;
      EXPECT_NEAR(p[i][j], expected, 1e-15);
    }
  EXPECT_NEAR(material.energy(h), (lame.lambda + 2 * lame.mu) * 0.1 * 0.1 / 2, 1e-15);
}

TYPED_TEST(LinearElasticDimensionsTest, DiscreteGradientDoesTheWorkOfTheEnergy) {
  constexpr std::size_t D = TypeParam::value;
  const Small<double, D> from = sample<D>(1);
  Small<double, D> to = from, p{};
  for (std::size_t i = 0; i < D; ++i) to[i][0] -= 0.7 * from[0][i];
  material.discrete_gradient(from, to, p);
  double work = 0;
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) work += p[i][j] * (to[i][j] - from[i][j]);
  EXPECT_NEAR(work, material.energy(to) - material.energy(from), 1e-14);
  // Linear in the end: half the moduli.
  Small<double, D * D> moduli{}, half{};
  material.stress_and_moduli(from, p, moduli);
  material.discrete_gradient_moduli(from, to, half);
  for (std::size_t r = 0; r < D * D; ++r)
    for (std::size_t c = 0; c < D * D; ++c) EXPECT_EQ(half[r][c], moduli[r][c] / 2);
}

TYPED_TEST(LinearElasticDimensionsTest, SimpleShear) {
  constexpr std::size_t D = TypeParam::value;
  Small<double, D> h{}, p{};
  h[0][1] = 0.1;
  material.stress(h, p);
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) EXPECT_NEAR(p[i][j], i + j == 1 ? lame.mu * 0.1 : 0.0, 1e-15);
  EXPECT_NEAR(material.energy(h), lame.mu * 0.1 * 0.1 / 2, 1e-15);
}

TYPED_TEST(LinearElasticDimensionsTest, SmallRotationGivesNoStress) {
  constexpr std::size_t D = TypeParam::value;
  const auto a = sample<D>(1);
  Small<double, D> h{}, p{};
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) h[i][j] = a[i][j] - a[j][i];
  ASSERT_GT(std::abs(h[0][1]), 0.1);
  material.stress(h, p);
  for (const auto& row : p)
    for (double value : row) EXPECT_EQ(value, 0.0);
  EXPECT_EQ(material.energy(h), 0.0);
}

TYPED_TEST(LinearElasticDimensionsTest, EnergyIsHalfStressTimesStrain) {
  constexpr std::size_t D = TypeParam::value;
  const auto h = sample<D>(1);
  Small<double, D> p{};
  material.stress(h, p);
  double product = 0, squares = 0, trace = 0;
  for (std::size_t i = 0; i < D; ++i) {
    trace += h[i][i];
    for (std::size_t j = 0; j < D; ++j) {
      const double strain = (h[i][j] + h[j][i]) / 2;
      product += p[i][j] * strain;
      squares += strain * strain;
    }
  }
  EXPECT_NEAR(material.energy(h), product / 2, 1e-14);
  EXPECT_NEAR(material.energy(h), lame.mu * squares + lame.lambda / 2 * trace * trace, 1e-14);
}

TYPED_TEST(LinearElasticDimensionsTest, ModuliTimesGradientIsTheStress) {
  constexpr std::size_t D = TypeParam::value;
  // Unit gradients give the moduli column by column: the stress is linear.
  Small<double, D * D> moduli{};
  Small<double, D> p{};
  EXPECT_EQ(material.stress_and_moduli(sample<D>(1), p, moduli), 1.0);
  for (std::size_t c = 0; c < D * D; ++c) {
    Small<double, D> unit{}, column{};
    unit[c / D][c % D] = 1;
    material.stress(unit, column);
    for (std::size_t r = 0; r < D * D; ++r) {
      EXPECT_NEAR(moduli[r][c], column[r / D][r % D], 1e-15) << r << ' ' << c;
      EXPECT_EQ(moduli[r][c], moduli[c][r]) << r << ' ' << c;
    }
  }
  const auto h = sample<D>(1);
  for (std::size_t r = 0; r < D * D; ++r) {
    double sum = 0;
    for (std::size_t c = 0; c < D * D; ++c) sum += moduli[r][c] * h[c / D][c % D];
    EXPECT_NEAR(sum, p[r / D][r % D], 1e-14);
  }
}

}  // namespace
}  // namespace ixos
