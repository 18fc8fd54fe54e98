// Tangent moduli in the deformed body are those of the undeformed one, pushed forward.
#include "material/spatial_tangent.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "material/linear_elastic.hpp"
#include "material/neo_hooke.hpp"
#include "support/displacement_gradients.hpp"

namespace ixos {
namespace {

constexpr Lame lame = lame_constants(1.5, 0.3);

double delta(std::size_t i, std::size_t j) { return i == j ? 1.0 : 0.0; }

/// A law at a displacement gradient without any symmetry: the deformation gradient F, the moduli A of the stress, and
/// the spatial tangent. A law of small strains takes the deformed body as undeformed: F = I.
template <class Material, std::size_t Dim>
struct Sample {
  static constexpr std::size_t D = Dim;

  Sample() {
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) f[i][j] = delta(i, j) + (Material::can_invert ? h[i][j] : 0.0);
    Small<double, D> stress{};
    law.stress_and_moduli(h, stress, moduli);
    tangent = law.spatial_tangent(h, inverse);
  }

  Material law{lame};
  Small<double, D> h = test::sample<D>(0.3), f{}, inverse{};
  Small<double, D * D> moduli{};
  SpatialTangent<double> tangent{};
};

template <class S>
class SpatialTangentTest : public testing::Test {};
using Samples =
    testing::Types<Sample<NeoHooke, 2>, Sample<NeoHooke, 3>, Sample<LinearElastic, 2>, Sample<LinearElastic, 3>>;
TYPED_TEST_SUITE(SpatialTangentTest, Samples);

TYPED_TEST(SpatialTangentTest, TheInverseIsThatOfTheDeformationGradient) {
  constexpr std::size_t D = TypeParam::D;
  const TypeParam at;
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) {
      double product = 0;
      for (std::size_t k = 0; k < D; ++k) product += at.inverse[i][k] * at.f[k][j];
      EXPECT_NEAR(product, delta(i, j), 1e-14) << i << ' ' << j;
    }
}

// a_ijkl = F_jJ F_lL A_iJkL
TYPED_TEST(SpatialTangentTest, IsThePushForwardOfTheModuli) {
  constexpr std::size_t D = TypeParam::D;
  const TypeParam at;
  Small<double, D> b{};
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j)
      for (std::size_t k = 0; k < D; ++k) b[i][j] += at.f[i][k] * at.f[j][k];
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j)
      for (std::size_t k = 0; k < D; ++k)
        for (std::size_t l = 0; l < D; ++l) {
          double pushed = 0;
          for (std::size_t m = 0; m < D; ++m)
            for (std::size_t n = 0; n < D; ++n) pushed += at.f[j][m] * at.f[l][n] * at.moduli[i * D + m][k * D + n];
          const double expected = at.tangent.mu * delta(i, k) * b[j][l] + at.tangent.c * delta(i, l) * delta(j, k) +
                                  at.tangent.lambda * delta(i, j) * delta(k, l);
          EXPECT_NEAR(expected, pushed, 1e-13) << i << j << k << l;
        }
}

// N_J A_iJkL M_L, with n = F^-T N and m = F^-T M.
TYPED_TEST(SpatialTangentTest, CouplesTwoNodesAsTheModuliDo) {
  constexpr std::size_t D = TypeParam::D;
  const TypeParam at;
  std::array<double, D> reference_n{}, reference_m{}, n{}, m{};
  double dot = 0;
  for (std::size_t i = 0; i < D; ++i) {
    reference_n[i] = 0.7 - 0.4 * static_cast<double>(i);
    reference_m[i] = 0.2 + 0.5 * static_cast<double>(i * i);
    dot += reference_n[i] * reference_m[i];
  }
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) {
      n[i] += at.inverse[j][i] * reference_n[j];
      m[i] += at.inverse[j][i] * reference_m[j];
    }
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t k = 0; k < D; ++k) {
      double coupling = 0;
      for (std::size_t j = 0; j < D; ++j)
        for (std::size_t l = 0; l < D; ++l)
          coupling += reference_n[j] * at.moduli[i * D + j][k * D + l] * reference_m[l];
      EXPECT_NEAR(at.tangent.mu * dot * delta(i, k) + at.tangent.c * m[i] * n[k] + at.tangent.lambda * n[i] * m[k],
                  coupling, 1e-13)
          << i << ' ' << k;
    }
}

TYPED_TEST(SpatialTangentTest, AtRestTheModuliAreHookes) {
  constexpr std::size_t D = TypeParam::D;
  const TypeParam sample;
  Small<double, D> rest{}, inverse{};
  const SpatialTangent<double> tangent = sample.law.spatial_tangent(rest, inverse);
  EXPECT_EQ(tangent.mu, lame.mu);
  EXPECT_EQ(tangent.c, lame.mu);
  EXPECT_EQ(tangent.lambda, lame.lambda);
}

TYPED_TEST(SpatialTangentTest, AFactorScalesAllModuli) {
  const TypeParam sample;
  SpatialTangent<double> scaled = sample.tangent;
  scaled.scale(-4.0);  // a power of two: exact
  EXPECT_EQ(scaled.mu, -4 * sample.tangent.mu);
  EXPECT_EQ(scaled.c, -4 * sample.tangent.c);
  EXPECT_EQ(scaled.lambda, -4 * sample.tangent.lambda);
}

// F = s I in three dimensions: ln J = 3 ln s.
TEST(SpatialTangentNeoHookeTest, ADilatationChangesTheCrossedModulus) {
  for (double s : {0.1, 0.9, 1.0, 1.3, 5.0}) {
    Small<double, 3> h{}, inverse{};
    for (std::size_t i = 0; i < 3; ++i) h[i][i] = s - 1;
    const SpatialTangent<double> tangent = NeoHooke{lame}.spatial_tangent(h, inverse);
    EXPECT_NEAR(tangent.c, lame.mu - 3 * lame.lambda * std::log(s), 1e-14) << s;
    EXPECT_EQ(tangent.mu, lame.mu);
    EXPECT_EQ(tangent.lambda, lame.lambda);
    EXPECT_NEAR(inverse[1][1] * s, 1, 1e-14) << s;
  }
}

}  // namespace
}  // namespace ixos
