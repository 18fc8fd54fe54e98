// One quadrature point under a mean dilatation: what the scaled deformation keeps, and derivatives of one energy.
#include "element/mean_dilatation_point.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "material/linear_elastic.hpp"
#include "material/neo_hooke.hpp"
#include "material/strain.hpp"
#include "support/automatic_differentiation.hpp"
#include "support/displacement_gradients.hpp"

namespace ixos {
namespace {

/// A point with any displacement gradient H and mean dilatation Jm - 1.
template <class MaterialType, std::size_t Dim>
struct Sample {
  using Material = MaterialType;
  static constexpr std::size_t D = Dim;
  static constexpr bool finite = Material::can_invert;
  using Point = MeanDilatationPoint<D>;
  template <class T>
  using State = typename Point::template State<T>;
  using Moduli = typename Point::template Moduli<double>;
  /// Its derivatives are those by the entries of F, row by row, then that by theta = ln Jm; theta = Jm - 1 for a linear
  /// law.
  using Variable = test::Dual<static_cast<int>(D* D + 1)>;
  static constexpr int theta = static_cast<int>(D * D);

  State<double> state() const { return {finite, h, mean}; }
  State<Variable> seeded() const {
    Small<Variable, D> gradient;
    for (std::size_t k = 0; k < D * D; ++k)
      gradient[k / D][k % D] = test::variable<theta + 1>(static_cast<int>(k), h[k / D][k % D]);
    Variable dilatation = test::variable<theta + 1>(theta, mean);
    if (finite) dilatation.fastAccessDx(theta) = 1 + mean;  // dJm = Jm dtheta
    return {finite, gradient, dilatation};
  }

  Moduli moduli(const State<double>& s, double along, double across) const {
    Small<double, D> p;
    Small<double, D * D> a;
    law.stress_and_moduli(s.scaled, p, a);
    return {s, p, a, along, across};
  }

  /// The first derivatives of the energy W(F~).
  template <class T>
  struct Slopes {
    Small<T, D> by_gradient;
    T by_theta;
  };
  template <class T>
  Slopes<T> slopes(const State<T>& s) const {
    Small<T, D> p;
    law.stress(s.scaled, p);
    Slopes<T> result;
    result.by_theta = s.product(p) * (1.0 / D);
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j)
        result.by_gradient[i][j] = s.scale * p[i][j] - result.by_theta * s.inverse[j][i];
    return result;
  }

  Material law{lame_constants(1.0, 0.3)};
  Small<double, D> h = test::sample<D>(0.2, 0.2);
  double mean = 0.15;
};

template <class S>
class MeanDilatationPointTest : public testing::Test {};
using Samples =
    testing::Types<Sample<NeoHooke, 2>, Sample<NeoHooke, 3>, Sample<LinearElastic, 2>, Sample<LinearElastic, 3>>;
TYPED_TEST_SUITE(MeanDilatationPointTest, Samples);

TYPED_TEST(MeanDilatationPointTest, TheScaledDeformationHasTheMeanDilatation) {
  constexpr std::size_t D = TypeParam::D;
  const TypeParam at;
  const auto s = at.state();
  EXPECT_NEAR(TypeParam::Point::dilatation(TypeParam::finite, s.scaled), at.mean, 1e-14);
  // A multiple of F; for a linear law, F and a multiple of I.
  const auto f = deformation_gradient<D>(at.h), scaled = deformation_gradient<D>(s.scaled);
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) {
      const double shift = TypeParam::finite || i != j ? 0.0 : s.scaled[0][0] - at.h[0][0];
      EXPECT_NEAR(scaled[i][j], s.scale * f[i][j] + shift, 1e-14) << i << ' ' << j;
    }
}

TYPED_TEST(MeanDilatationPointTest, QuantitiesOfALinearLawAreThoseAtRest) {
  constexpr std::size_t D = TypeParam::D;
  const TypeParam at;
  const auto s = at.state();
  const auto f = deformation_gradient<D>(TypeParam::finite ? at.h : Small<double, D>{});
  EXPECT_NEAR(s.jacobian, determinant(f), 1e-14);
  if (!TypeParam::finite) {
    EXPECT_EQ(s.scale, 1.0);
  }
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) {
      double product = 0;
      for (std::size_t k = 0; k < D; ++k) product += s.inverse[i][k] * f[k][j];
      EXPECT_NEAR(product, i == j ? 1.0 : 0.0, 1e-14) << i << ' ' << j;
    }
}

TYPED_TEST(MeanDilatationPointTest, ADilatationThatIsTheMeanChangesNothing) {
  constexpr std::size_t D = TypeParam::D;
  TypeParam at;
  at.mean = TypeParam::Point::dilatation(TypeParam::finite, at.h);
  const auto s = at.state();
  EXPECT_NEAR(s.scale, 1.0, 1e-15);
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) EXPECT_NEAR(s.scaled[i][j], at.h[i][j], 1e-15);
}

// The exponent (ln (1 + mean) - ln J)/D gives the dilatation that is asked for.
TYPED_TEST(MeanDilatationPointTest, StretchedStatesAreThoseOfTheirDilatation) {
  constexpr std::size_t D = TypeParam::D;
  using State = typename TypeParam::template State<double>;
  TypeParam at;
  for (const double mean : {0.15, -0.6, 3.0}) {
    at.mean = mean;
    const double theta = TypeParam::finite ? std::log1p(mean) : mean;
    const double exponent = (theta - TypeParam::Point::log_ratio(TypeParam::finite, at.h)) / static_cast<double>(D);
    const auto s = State::stretched(TypeParam::finite, at.h, exponent);
    const auto expected = at.state();
    EXPECT_NEAR(s.scale, expected.scale, 1e-14);
    EXPECT_NEAR(s.jacobian, expected.jacobian, 1e-15);
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) {
        EXPECT_NEAR(s.scaled[i][j], expected.scaled[i][j], 1e-14) << mean;
        EXPECT_NEAR(s.inverse[i][j], expected.inverse[i][j], 1e-15);
      }
  }
}

// A uniform stretch s of all axes: D ln s, or D (s - 1) for a linear law.
TYPED_TEST(MeanDilatationPointTest, RatiosOfVolumesKeepTheirDigits) {
  constexpr std::size_t D = TypeParam::D;
  for (const double change : {1e-12, 1e-5, 0.04, 0.5, 2.0, -0.04, -0.5, -0.9999}) {
    Small<double, D> h{};
    for (std::size_t i = 0; i < D; ++i) h[i][i] = change;
    const double expected = static_cast<double>(D) * (TypeParam::finite ? std::log1p(change) : change);
    EXPECT_NEAR(TypeParam::Point::log_ratio(TypeParam::finite, h) / expected, 1, 1e-11 * (1e-3 + std::abs(change)))
        << change;
  }
}

// At H = 0 the scaled deformation is (1 + m)^(1/D) I: m/D, up to a relative change below m.
TYPED_TEST(MeanDilatationPointTest, SmallDilatationsKeepTheirDigits) {
  constexpr std::size_t D = TypeParam::D;
  TypeParam at;
  at.h = {};
  for (double mean : {1e-6, 1e-9, 1e-12, -1e-12}) {
    at.mean = mean;
    const auto s = at.state();
    for (std::size_t i = 0; i < D; ++i)
      EXPECT_NEAR(s.scaled[i][i] * static_cast<double>(D) / mean, 1, std::abs(mean) + 1e-15);
  }
}

TYPED_TEST(MeanDilatationPointTest, AProductIsThatWithTheScaledDeformation) {
  constexpr std::size_t D = TypeParam::D;
  const TypeParam at;
  const auto s = at.state();
  const auto f = deformation_gradient<D>(TypeParam::finite ? s.scaled : Small<double, D>{});
  Small<double, D> m{};
  double phase = 0.4, expected = 0;
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) {
      m[i][j] = std::cos(phase += 0.9);
      expected += m[i][j] * f[i][j];
    }
  EXPECT_NEAR(s.product(m), expected, 1e-14);
}

// The trace of H takes the place of J for a linear law.
TYPED_TEST(MeanDilatationPointTest, CofactorsAreDerivativesOfTheVolume) {
  constexpr std::size_t D = TypeParam::D;
  const TypeParam at;
  Small<typename TypeParam::Variable, D> h;
  for (std::size_t k = 0; k < D * D; ++k)
    h[k / D][k % D] = test::variable<TypeParam::theta + 1>(static_cast<int>(k), at.h[k / D][k % D]);
  const typename TypeParam::Variable volume = TypeParam::Point::dilatation(TypeParam::finite, h);
  const auto cofactors = at.state().cofactors();
  for (std::size_t k = 0; k < D * D; ++k)
    EXPECT_NEAR(cofactors[k / D][k % D], volume.dx(static_cast<int>(k)), 1e-14) << k;
}

TYPED_TEST(MeanDilatationPointTest, StatesGiveTheSlopesOfTheEnergy) {
  constexpr std::size_t D = TypeParam::D;
  const TypeParam at;
  const typename TypeParam::Variable energy = at.law.energy(at.seeded().scaled);
  const auto slopes = at.slopes(at.state());
  EXPECT_GT(energy.val(), 0.0);
  for (std::size_t k = 0; k < D * D; ++k)
    EXPECT_NEAR(slopes.by_gradient[k / D][k % D], energy.dx(static_cast<int>(k)), 1e-13) << k;
  EXPECT_NEAR(slopes.by_theta, energy.dx(TypeParam::theta), 1e-13);
}

TYPED_TEST(MeanDilatationPointTest, ModuliAreTheSlopesOfTheSlopes) {
  constexpr std::size_t D = TypeParam::D;
  const TypeParam at;
  const auto slopes = at.slopes(at.seeded());
  const typename TypeParam::Moduli moduli = at.moduli(at.state(), 0.0, 0.0);
  for (std::size_t r = 0; r < D * D; ++r) {
    for (std::size_t c = 0; c < D * D; ++c) {
      EXPECT_NEAR(moduli.local[r][c], slopes.by_gradient[r / D][r % D].dx(static_cast<int>(c)), 1e-12) << r << ' ' << c;
      EXPECT_NEAR(moduli.local[r][c], moduli.local[c][r], 1e-14) << r << ' ' << c;
    }
    EXPECT_NEAR(moduli.coupling[r / D][r % D], slopes.by_gradient[r / D][r % D].dx(TypeParam::theta), 1e-12) << r;
    EXPECT_NEAR(moduli.coupling[r / D][r % D], slopes.by_theta.dx(static_cast<int>(r)), 1e-12) << r;
  }
  EXPECT_NEAR(moduli.second, slopes.by_theta.dx(TypeParam::theta), 1e-12);
}

// Linear laws have no such part.
template <class S>
class MeanDilatationPressureTest : public testing::Test {};
using FiniteSamples = testing::Types<Sample<NeoHooke, 2>, Sample<NeoHooke, 3>>;
TYPED_TEST_SUITE(MeanDilatationPressureTest, FiniteSamples);

// sigma/J times the second derivative of J by F; dJ/dF_iJ = J F^-1_Ji.
TYPED_TEST(MeanDilatationPressureTest, APressureAddsTheCurvatureOfTheVolume) {
  constexpr std::size_t D = TypeParam::D;
  const TypeParam at;
  const double sigma = -0.7;
  const auto s = at.state();
  const auto seeded = at.seeded();
  const typename TypeParam::Moduli without = at.moduli(s, 0.0, 0.0), with = at.moduli(s, sigma, sigma);
  for (std::size_t r = 0; r < D * D; ++r) {
    const typename TypeParam::Variable slope = seeded.jacobian * seeded.inverse[r % D][r / D];
    for (std::size_t c = 0; c < D * D; ++c)
      EXPECT_NEAR(with.local[r][c] - without.local[r][c], sigma / s.jacobian * slope.dx(static_cast<int>(c)), 1e-13)
          << r << ' ' << c;
    EXPECT_EQ(with.coupling[r / D][r % D], without.coupling[r / D][r % D]);
  }
  EXPECT_EQ(with.second, without.second);
}

// The second derivative of ln J by F is that of its slope, F^-1_Ji.
TYPED_TEST(MeanDilatationPressureTest, OneOfALogarithmAddsItsCurvature) {
  constexpr std::size_t D = TypeParam::D;
  const TypeParam at;
  const double pressure = -0.7;
  const auto s = at.state();
  const auto seeded = at.seeded();
  const typename TypeParam::Moduli without = at.moduli(s, 0.0, 0.0), with = at.moduli(s, 0.0, pressure);
  for (std::size_t r = 0; r < D * D; ++r)
    for (std::size_t c = 0; c < D * D; ++c)
      EXPECT_NEAR(with.local[r][c] - without.local[r][c],
                  pressure * seeded.inverse[r % D][r / D].dx(static_cast<int>(c)), 1e-13)
          << r << ' ' << c;
}

// A mirrored element is inadmissible; its numbers stay finite, so that it spoils no other lane of a pack.
TYPED_TEST(MeanDilatationPressureTest, RatiosOfInvertedPointsAreFinite) {
  constexpr std::size_t D = TypeParam::D;
  Small<double, D> h{};
  for (const double change : {-1.0, -2.5}) {
    h[0][0] = change;
    EXPECT_EQ(TypeParam::Point::log_ratio(TypeParam::finite, h), 0.0);
  }
}

}  // namespace
}  // namespace ixos
