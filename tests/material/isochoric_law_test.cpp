// An energy of both isochoric invariants with all second derivatives, against automatic differentiation.
#include "material/isochoric_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

#include "material/strain_law.hpp"
#include "support/displacement_gradients.hpp"

namespace ixos {
namespace {

/// W = 0.3 x + 0.2 y + 0.4 x^2 - 0.3 x y + 0.5 y^2.
struct General {
  static constexpr bool has_limit = false;
  template <class T>
  T energy(const T& x, const T& y) const {
    return 0.3 * x + 0.2 * y + 0.4 * x * x - 0.3 * x * y + 0.5 * y * y;
  }
  template <class T>
  Slopes<T> slopes(const T& x, const T& y) const {
    return {T(0.3 + 0.8 * x - 0.3 * y), T(0.2 - 0.3 * x + y)};
  }
  template <class T>
  Curvatures<T> curvatures(const T&, const T&) const {
    return {T(0.8), T(-0.3), T(1.0)};
  }
};

StrainLaw<IsochoricLaw<General>> law(VolumetricEnergy::Form form) {
  return StrainLaw(IsochoricLaw<General>{{}, {2.0, form}, {1.0, 2.0 - 2.0 / 3}});
}
constexpr std::array<VolumetricEnergy::Form, 2> forms{VolumetricEnergy::Form::Logarithm,
                                                      VolumetricEnergy::Form::Convex};

using test::sample;
using test::seeded;
template <std::size_t D>
using Variable = test::OfGradient<D>;

template <class D>
class IsochoricLawTest : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<std::size_t, 2>, std::integral_constant<std::size_t, 3>>;
TYPED_TEST_SUITE(IsochoricLawTest, Dimensions);

TYPED_TEST(IsochoricLawTest, StressAndModuliAreTheDerivativesOfTheEnergy) {
  constexpr std::size_t D = TypeParam::value;
  for (const auto form : forms)
    for (const double size : {1e-6, 0.01, 0.1, 0.4}) {
      const auto rubber = law(form);
      const auto h = seeded<D>(sample<D>(size));
      const Variable<D> energy = rubber.energy(h);
      Small<Variable<D>, D> p{};
      rubber.stress(h, p);
      Small<double, D> stress{};
      Small<double, D * D> moduli{};
      EXPECT_NEAR(rubber.stress_and_moduli(sample<D>(size), stress, moduli), rubber.stress(h, p).val(), 1e-15);
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) {
          EXPECT_NEAR(stress[i][j], energy.dx(static_cast<int>(i * D + j)), 1e-13 * size) << size;
          EXPECT_NEAR(stress[i][j], p[i][j].val(), 1e-14 * size);
          for (std::size_t c = 0; c < D * D; ++c)
            EXPECT_NEAR(moduli[i * D + j][c], p[i][j].dx(static_cast<int>(c)), 2e-13) << size;
        }
    }
}

/// x and y as they stand, in longer numbers.
TEST(IsochoricLawTest, TheInvariantsAreTheIsochoricOnes) {
  const auto rubber = law(VolumetricEnergy::Form::Logarithm);
  for (const double size : {0.01, 0.1, 0.4, 2.0}) {
    const Small<double, 3> h = sample<3>(size);
    Small<long double, 3> f{}, c{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) f[i][j] = h[i][j] + (i == j ? 1.0L : 0.0L);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < 3; ++k) c[i][j] += f[k][i] * f[k][j];
    const long double jacobian = determinant(f), first = c[0][0] + c[1][1] + c[2][2];
    long double square = 0;
    for (const auto& row : c)
      for (const long double value : row) square += value * value;
    ASSERT_GT(jacobian, 0);
    const long double x = first * std::pow(jacobian, -2.0L / 3) - 3;
    const long double y = (first * first - square) / 2 * std::pow(jacobian, -4.0L / 3) - 3;
    const long double l = std::log(jacobian);
    const double expected = static_cast<double>(General{}.energy(x, y) + l * l);
    EXPECT_NEAR(rubber.energy(h), expected, 1e-14 * expected) << size;
  }
}

/// Beyond the radius of every series. y has the rounding errors of C over the fourth power of the stretch.
TEST(IsochoricLawTest, ADilatationHasVolumetricEnergyAlone) {
  for (const double stretch : {0.03, 0.1, 0.5, 0.9, 0.99, 1.0 + 1e-9, 1.05, 3.0, 1e4}) {
    Small<double, 3> h{}, p;
    for (std::size_t i = 0; i < 3; ++i) h[i][i] = stretch - 1;
    const double l = 3 * std::log1p(h[0][0]), j = std::expm1(2 * l);
    // The second invariant of a compressed body comes from strains near -1/2, by J^(-4/3).
    const double rounding = 1e-15 / std::pow(stretch, 4);
    law(forms[0]).stress(h, p);
    EXPECT_NEAR(p[0][0] * stretch, 2.0 * l, 1e-11 * std::abs(l) + rounding) << stretch;
    law(forms[1]).stress(h, p);
    EXPECT_NEAR(p[1][1] * stretch, j, 1e-11 * std::abs(j) + rounding) << stretch;
    EXPECT_NEAR(p[0][1], 0, 1e-14);
    EXPECT_NEAR(law(forms[0]).energy(h), l * l, 1e-8 * l * l) << stretch;
  }
}

}  // namespace
}  // namespace ixos
