#include "material/revolved_law.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "material/linear_elastic.hpp"

namespace ixos {
namespace {

/// A gradient without torsion.
Small<double, 3> gradient(double size) {
  return {{{0.3 * size, -0.2 * size, 0}, {0.5 * size, -0.4 * size, 0}, {0, 0, 0.7 * size}}};
}

template <class Law>
void expect_the_law_in_three_dimensions(const Law& law) {
  const RevolvedLaw<Law> revolved(law);
  for (const double size : {1.0, -0.6, 1e-3, 1e-9}) {
    const Small<double, 3> h = gradient(size);
    Small<double, 3> p, expected_p;
    Small<double, meridian_size> moduli;
    Small<double, 9> expected;
    const double jacobian = law.stress_and_moduli(h, expected_p, expected);
    EXPECT_NEAR(revolved.energy(h), law.energy(h), 1e-13 * size * size);
    EXPECT_NEAR(revolved.stress_and_moduli(h, p, moduli), jacobian, 1e-14);
    for (std::size_t r = 0; r < meridian_size; ++r) {
      const auto [i, j] = meridian_components[r];
      EXPECT_NEAR(p[i][j], expected_p[i][j], 1e-13 * std::abs(size)) << size << ", " << i << j;
      for (std::size_t c = 0; c < meridian_size; ++c) {
        const auto [k, m] = meridian_components[c];
        EXPECT_NEAR(moduli[r][c], expected[3 * i + j][3 * k + m], 1e-12) << size << ", " << r << c;
      }
    }
    EXPECT_EQ(p[0][2], 0);
    EXPECT_EQ(p[2][1], 0);
  }
}

TEST(RevolvedLaw, OfNeoHookeIsTheLawInThreeDimensions) {
  expect_the_law_in_three_dimensions(NeoHooke{lame_constants(1.3, 0.3)});
}

TEST(RevolvedLaw, OfLinearElasticityIsTheLawInThreeDimensions) {
  expect_the_law_in_three_dimensions(LinearElastic{lame_constants(1.3, 0.3)});
}

TEST(RevolvedLaw, UniaxialStretchHasTheStressOfABarWithFreeSides) {
  // lambda ln J + mu (b - 1) = 0 across the bar, with b the square of the transverse stretch.
  const Lame lame = lame_constants(1.0, 0.3);
  const RevolvedLaw<NeoHooke> law(NeoHooke{lame});
  const double along = 1.4;
  double b = 1;  // Newton's method for mu (b - 1) + lambda ln(along b) = 0
  for (int k = 0; k < 50; ++k)
    b -= (lame.mu * (b - 1) + lame.lambda * std::log(along * b)) / (lame.mu + lame.lambda / b);
  const double across = std::sqrt(b);
  Small<double, 3> p;
  law.stress({{{across - 1, 0, 0}, {0, along - 1, 0}, {0, 0, across - 1}}}, p);
  EXPECT_NEAR(p[0][0], 0, 1e-15);
  EXPECT_NEAR(p[2][2], 0, 1e-15);
  EXPECT_NEAR(p[1][1], lame.mu * (along - b / along), 1e-15);
}

}  // namespace
}  // namespace ixos
