#include "material/ogden_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "material/mooney_rivlin.hpp"
#include "material/strain_law.hpp"
#include "support/derivative.hpp"

namespace ixos {
namespace {

const VolumetricEnergy volumetric{2.0, VolumetricEnergy::Form::Logarithm};
const Lame lame{1.1, 2.0 - 2.2 / 3};

template <std::size_t D, class Law>
void expect_same(const Law& law, const StrainLaw<OgdenLaw>& ogden, const Small<double, D>& h) {
  double size = 0;
  for (const auto& row : h)
    for (const double value : row) size = std::max(size, std::abs(value));
  Small<double, D> p, q;
  Small<double, D * D> a, b;
  EXPECT_NEAR(ogden.energy(h), law.energy(h), 1e-14 * law.energy(h)) << size;
  EXPECT_NEAR(ogden.stress_and_moduli(h, q, b), law.stress_and_moduli(h, p, a), 0);
  for (std::size_t r = 0; r < D * D; ++r) {
    EXPECT_NEAR(q[r / D][r % D], p[r / D][r % D], 5e-14 * size);
    for (std::size_t c = 0; c < D * D; ++c) EXPECT_NEAR(b[r][c], a[r][c], 1e-13) << size << ' ' << r << ' ' << c;
  }
}

// mu_1 = 2 c10 and mu_2 = -2 c01.
TEST(OgdenLawTest, WithExponentsTwoAndMinusTwoIsMooneyRivlins) {
  const StrainLaw law(IsochoricLaw<MooneyRivlin>{{0.35, 0.2}, volumetric, lame});
  const StrainLaw ogden(OgdenLaw{{{0.7, 2.0}, {-0.4, -2.0}}, volumetric, lame});
  const Small<double, 3> h{{{0.3, -0.2, 0.25}, {0.5, -0.4, 0.1}, {-0.15, 0.35, 0.45}}};
  const Small<double, 2> plane{{{0.3, -0.2}, {0.5, -0.4}}};
  for (const double size : {1.0, 0.1, 1e-4, 1e-8}) {
    Small<double, 3> scaled = h;
    Small<double, 2> flat = plane;
    for (auto& row : scaled)
      for (double& value : row) value *= size;
    for (auto& row : flat)
      for (double& value : row) value *= size;
    expect_same(law, ogden, scaled);
    expect_same(law, ogden, flat);
  }
}

TEST(OgdenLawTest, ModuliAreContinuousWhereStretchesBecomeEqual) {
  const StrainLaw law(IsochoricLaw<MooneyRivlin>{{0.35, 0.2}, volumetric, lame});
  const StrainLaw ogden(OgdenLaw{{{0.7, 2.0}, {-0.4, -2.0}}, volumetric, lame});
  for (const double gap : {0.0, 1e-16, 1e-13, 1e-10, 1e-8, 1e-6, 1e-4, 1e-2})
    for (const double shear : {0.0, 1e-12, 1e-7}) {
      expect_same(law, ogden, Small<double, 3>{{{0.4, shear, 0}, {0, 0.4 + gap, 0}, {0, 0, 0.4 - gap}}});
      expect_same(law, ogden, Small<double, 3>{{{0.4, shear, 0}, {0, 0.4 + gap, 0}, {0, 0, -0.3}}});
      expect_same(law, ogden, Small<double, 2>{{{0.4, shear}, {0, 0.4 + gap}}});
    }
}

TEST(OgdenLawTest, ModuliOfOddExponentsAreTheDerivativesOfTheStress) {
  const StrainLaw ogden(OgdenLaw{{{0.6, 1.3}, {0.02, 5.0}, {-0.1, -1.7}}, volumetric, {0.52, 1.0}});
  for (const double gap : {0.0, 1e-9, 0.1}) {
    const Small<double, 3> h{{{0.3 + gap, 0, 0}, {0, 0.3, 0}, {0, 0.2 * gap, -0.2}}};
    Small<double, 3> p;
    Small<double, 9> moduli;
    ogden.stress_and_moduli(h, p, moduli);
    for (std::size_t c = 0; c < 9; ++c)
      for (std::size_t r = 0; r < 9; ++r)
        EXPECT_NEAR(moduli[r][c], test::derivative([&](double step) {
                      Small<double, 3> there = h, stress;
                      there[c / 3][c % 3] += step;
                      ogden.stress(there, stress);
                      return stress[r / 3][r % 3];
                    }),
                    1e-9)
            << gap;
  }
}

}  // namespace
}  // namespace ixos
