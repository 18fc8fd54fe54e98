#include "material/neo_hooke.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

#include "support/displacement_gradients.hpp"

namespace ixos {
namespace {

constexpr Lame lame = lame_constants(1.0, 0.2);
constexpr NeoHooke material{lame};

using test::sample;
using test::seeded;
template <std::size_t D>
using Variable = test::OfGradient<D>;

/// W = mu/2 (tr C - 3) - mu ln J + lambda/2 (ln J)^2 as it stands, C_33 = 1 in plane strain. It loses digits at small
/// strain: hence the longer numbers.
template <std::size_t D>
double direct_energy(const Small<double, D>& h) {
  Small<long double, D> f{};
  long double trace = D == 2 ? 1.0L : 0.0L;  // of C
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) {
      f[i][j] = h[i][j];
      if (i == j) f[i][j] += 1;
      trace += f[i][j] * f[i][j];
    }
  const long double l = std::log(determinant(f));
  return static_cast<double>(lame.mu / 2 * (trace - 3) - lame.mu * l + lame.lambda / 2 * l * l);
}

/// Q F - I with a rotation Q by two radians about the last axis (in 2D: in the plane).
template <std::size_t D>
Small<double, D> turn(Small<double, D> a) {
  const double c = std::cos(2.0), s = std::sin(2.0);
  for (std::size_t j = 0; j < D; ++j) {
    const double x = a[0][j], y = a[1][j];
    a[0][j] = c * x - s * y;
    a[1][j] = s * x + c * y;
  }
  return a;
}

template <class D>
class NeoHookeTest : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<std::size_t, 2>, std::integral_constant<std::size_t, 3>>;
TYPED_TEST_SUITE(NeoHookeTest, Dimensions);

TYPED_TEST(NeoHookeTest, EnergyIsTheFormula) {
  constexpr std::size_t D = TypeParam::value;
  // Strains from small to large, on both sides of the switch to the series.
  for (double size : {1e-3, 3e-3, 0.01, 0.03, 0.1, 0.3}) {
    const double expected = direct_energy(sample<D>(size));
    EXPECT_NEAR(material.energy(sample<D>(size)), expected, 1e-12 * expected) << size;
  }
  // Uniform dilatation, j = det C - 1 across 0.02.
  for (double stretch : {-0.3, -0.02, -0.005, 0.001, 0.0033, 0.0034, 0.0049, 0.005, 0.2, 1.5}) {
    Small<double, D> h{};
    for (std::size_t i = 0; i < D; ++i) h[i][i] = stretch;
    EXPECT_NEAR(material.energy(h), direct_energy(h), 1e-12 * direct_energy(h)) << stretch;
  }
}

TYPED_TEST(NeoHookeTest, KeepsItsDigitsUnderStrongCompressionAndStretch) {
  constexpr std::size_t D = TypeParam::value;
  // F = diag(s, 1, ..): P = mu (F - F^-T) + lambda ln s F^-T.
  for (double squeezed : {0.5, 0.1, 1e-2, 1e-4, 1e-8, 1e-12}) {
    Small<double, D> h{}, p{};
    h[0][0] = squeezed - 1;
    const double s = 1 + h[0][0], l = std::log(s);
    EXPECT_EQ(material.stress(h, p), s);
    EXPECT_NEAR(p[0][0] / (lame.mu * (s - 1 / s) + lame.lambda * l / s), 1, 1e-15);
    EXPECT_NEAR(p[1][1] / (lame.lambda * l), 1, 1e-14);
    EXPECT_NEAR(material.energy(h) / (lame.mu / 2 * (s * s - 1 - 2 * l) + lame.lambda / 2 * l * l), 1, 1e-14);
    Small<Pack, D> packed{}, p_packed{};
    packed[0][0] = h[0][0];
    packed[0][0][0] = 0;  // a lane at rest beside
    material.stress(packed, p_packed);
    EXPECT_NEAR(p_packed[1][1][1] / (lame.lambda * l), 1, 1e-14);
    EXPECT_EQ(p_packed[0][0][0], 0);
  }
  for (double size : {3.0, 10.0, 100.0}) {
    auto h = sample<D>(size);
    for (std::size_t i = 0; i < D; ++i) h[i][i] += static_cast<double>(i + 2) * size;  // det F > 0
    EXPECT_NEAR(material.energy(h) / direct_energy(h), 1, 1e-14) << size;
  }
}

TYPED_TEST(NeoHookeTest, StressIsTheDerivativeOfTheEnergy) {
  constexpr std::size_t D = TypeParam::value;
  for (double size : {1e-3, 0.1, 0.3}) {
    const auto h = sample<D>(size);
    const Variable<D> energy = material.energy(seeded<D>(h));
    Small<double, D> p{};
    const double jacobian = material.stress(h, p);
    EXPECT_NEAR(jacobian, determinant(deformation_gradient(h)), 1e-15);
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) EXPECT_NEAR(p[i][j], energy.dx(static_cast<int>(i * D + j)), 1e-14);
  }
}

TYPED_TEST(NeoHookeTest, ModuliAreTheSymmetricDerivativeOfTheStress) {
  constexpr std::size_t D = TypeParam::value;
  for (double size : {1e-3, 0.1, 0.3}) {
    const auto h = sample<D>(size);
    Small<Variable<D>, D> derivative{};
    material.stress(seeded<D>(h), derivative);
    Small<double, D> p{}, p_alone{};
    Small<double, D * D> moduli{};
    EXPECT_DOUBLE_EQ(material.stress_and_moduli(h, p, moduli), material.stress(h, p_alone));
    for (std::size_t r = 0; r < D * D; ++r) {
      EXPECT_NEAR(p[r / D][r % D], p_alone[r / D][r % D], 1e-15);
      for (std::size_t c = 0; c < D * D; ++c) {
        EXPECT_NEAR(moduli[r][c], derivative[r / D][r % D].dx(static_cast<int>(c)), 1e-13) << r << ' ' << c;
        EXPECT_NEAR(moduli[r][c], moduli[c][r], 1e-14) << r << ' ' << c;
      }
    }
  }
}

TYPED_TEST(NeoHookeTest, RotationTurnsTheStressAndKeepsTheEnergy) {
  constexpr std::size_t D = TypeParam::value;
  const auto h = sample<D>(0.3);
  auto turned = turn<D>(deformation_gradient(h));
  for (std::size_t i = 0; i < D; ++i) turned[i][i] -= 1;
  EXPECT_NEAR(material.energy(turned), material.energy(h), 1e-14);
  Small<double, D> p{}, p_turned{};
  material.stress(h, p);
  material.stress(turned, p_turned);
  const auto expected = turn<D>(p);
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) EXPECT_NEAR(p_turned[i][j], expected[i][j], 1e-14);
}

TYPED_TEST(NeoHookeTest, SmallStrainIsLinearElasticityToTheLastDigits) {
  constexpr std::size_t D = TypeParam::value;
  // The laws differ by a term of third order: by less than 10 |H| relative to the energy, unless digits are lost.
  for (double size : {1e-6, 1e-9, 1e-12}) {
    const auto h = sample<D>(size);
    double squares = 0, trace = 0;
    for (std::size_t i = 0; i < D; ++i) {
      trace += h[i][i];
      for (std::size_t j = 0; j < D; ++j) squares += (h[i][j] + h[j][i]) * (h[i][j] + h[j][i]) / 4;
    }
    const double linear = lame.mu * squares + lame.lambda / 2 * trace * trace;
    EXPECT_NEAR(material.energy(h) / linear, 1.0, 10 * size) << size;
    Small<double, D> p{};
    material.stress(h, p);
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) {
        const double sigma = lame.mu * (h[i][j] + h[j][i]) + (i == j ? lame.lambda * trace : 0.0);
        EXPECT_NEAR(p[i][j] / size, sigma / size, 10 * size) << size;
      }
  }
}

/// Pairs of ends: small and large steps from small and large strains, and none at all.
template <std::size_t D>
std::vector<std::pair<Small<double, D>, Small<double, D>>> steps() {
  std::vector<std::pair<Small<double, D>, Small<double, D>>> result;
  for (double size : {0.0, 1e-9, 1e-3, 0.3})
    for (double step : {0.0, 1e-12, 1e-6, 0.01, 0.03, 0.4}) {
      Small<double, D> from = sample<D>(size), to = from;
      double phase = 0.2;
      for (auto& row : to)
        for (double& value : row) value += step * std::cos(phase += 0.9);
      result.emplace_back(from, to);
    }
  return result;
}

TYPED_TEST(NeoHookeTest, WorkOfTheDiscreteGradientIsTheChangeOfTheEnergy) {
  constexpr std::size_t D = TypeParam::value;
  for (const auto& [from, to] : steps<D>()) {
    Small<double, D> p;
    material.discrete_gradient(from, to, p);
    double work = 0, scale = 0;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) {
        work += p[i][j] * (to[i][j] - from[i][j]);
        scale += std::abs(p[i][j] * (to[i][j] - from[i][j]));
      }
    // What rounding the ends costs: epsilon in F, times the stress.
    const double energies = std::abs(material.energy(to)) + std::abs(material.energy(from));
    EXPECT_NEAR(work, material.energy(to) - material.energy(from), 1e-14 * (energies + scale) + 1e-30);
  }
}

TYPED_TEST(NeoHookeTest, DiscreteGradientKeepsItsDigitsUnderStrongCompression) {
  constexpr std::size_t D = TypeParam::value;
  // From F = diag(r, 1, ..) to diag(s, 1, ..): P_11 by the energies' difference; P_22 = mu + c q D_22 with the mean
  // D_22 = (r^2 + s^2)/2 of C's cofactor, q = 2 ln(s/r)/(s^2 - r^2) and c = -mu + lambda/2 (ln r + ln s).
  const auto energy = [](long double s) {
    const long double l = std::log(s);
    return lame.mu / 2 * (s * s - 1 - 2 * l) + lame.lambda / 2 * l * l;
  };
  for (double start : {1.0, 0.5, 0.1, 1e-2, 1e-4, 1e-8})
    for (double factor : {1e-6, 0.1, 0.9, 1.001, 1.5, 10.0, 1e4, 1e8}) {
      Small<double, D> h0{}, h1{}, p;
      h0[0][0] = start - 1;
      h1[0][0] = factor * start - 1;
      const long double r = 1.0L + h0[0][0], s = 1.0L + h1[0][0];
      if (s < 1e-13L || s > 20) continue;
      const long double first = (energy(s) - energy(r)) / (s - r);
      const long double c = lame.lambda / 2 * std::log(r * s) - lame.mu;
      const long double second = lame.mu + c * 2 * std::log(s / r) / (s * s - r * r) * (r * r + s * s) / 2;
      material.discrete_gradient(h0, h1, p);
      EXPECT_NEAR(p[0][0] / static_cast<double>(first), 1, 2e-13) << start << ' ' << factor;
      EXPECT_NEAR(p[1][1] / static_cast<double>(second), 1, 1e-13) << start << ' ' << factor;
      Small<Pack, D> from{}, to{}, packed;
      from[0][0] = h0[0][0];
      to[0][0] = h1[0][0];
      from[0][0][0] = to[0][0][0] = 0;  // a lane at rest beside
      material.discrete_gradient(from, to, packed);
      EXPECT_NEAR(packed[1][1][1] / static_cast<double>(second), 1, 1e-13);
      EXPECT_EQ(packed[0][0][0], 0);
      // The moduli along the way are the derivative of P in the end.
      Small<double, D * D> moduli;
      Small<Variable<D>, D> fixed, derivative;
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) fixed[i][j] = Variable<D>(h0[i][j]);
      material.discrete_gradient(fixed, seeded<D>(h1), derivative);
      material.discrete_gradient_moduli(h0, h1, moduli);
      double largest = 0;
      for (const auto& row : moduli)
        for (double value : row) largest = std::max(largest, std::abs(value));
      for (std::size_t k = 0; k < D * D; ++k)
        for (std::size_t m = 0; m < D * D; ++m)
          EXPECT_NEAR(moduli[k][m], derivative[k / D][k % D].dx(static_cast<int>(m)), 1e-12 * largest)
              << start << ' ' << factor << ' ' << k << ' ' << m;
    }
}

TYPED_TEST(NeoHookeTest, DiscreteGradientTendsToTheStressWithSecondOrder) {
  constexpr std::size_t D = TypeParam::value;
  const auto error = [](double step) {
    Small<double, D> from = sample<D>(0.3), to = from, middle = from, p, q;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) {
        const double change = std::cos(static_cast<double>(i + 2 * j));
        to[i][j] += step * change;
        middle[i][j] += step / 2 * change;
      }
    material.discrete_gradient(from, to, p);
    material.stress(middle, q);
    double largest = 0;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) largest = std::max(largest, std::abs(p[i][j] - q[i][j]));
    return largest;
  };
  EXPECT_NEAR(error(0.02) / error(0.01), 4, 0.2);
  EXPECT_LT(error(0), 1e-15);
}

TYPED_TEST(NeoHookeTest, DiscreteGradientTurnsWithTheBody) {
  constexpr std::size_t D = TypeParam::value;
  const auto turned = [](Small<double, D> h) {
    for (std::size_t i = 0; i < D; ++i) h[i][i] += 1;
    Small<double, D> f = turn<D>(h);
    for (std::size_t i = 0; i < D; ++i) f[i][i] -= 1;
    return f;
  };
  for (const auto& [from, to] : steps<D>()) {
    Small<double, D> p, q;
    material.discrete_gradient(from, to, p);
    material.discrete_gradient(turned(from), turned(to), q);
    const Small<double, D> expected = turn<D>(p);
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) EXPECT_NEAR(q[i][j], expected[i][j], 3e-15);
  }
}

TYPED_TEST(NeoHookeTest, DiscreteModuliAreTheDerivativeInTheEnd) {
  constexpr std::size_t D = TypeParam::value;
  double skew = 0;
  for (const auto& [from, to] : steps<D>()) {
    Small<Variable<D>, D> start, p;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) start[i][j] = Variable<D>(from[i][j]);
    material.discrete_gradient(start, seeded<D>(to), p);
    Small<double, D * D> moduli;
    material.discrete_gradient_moduli(from, to, moduli);
    for (std::size_t r = 0; r < D * D; ++r)
      for (std::size_t c = 0; c < D * D; ++c) {
        EXPECT_NEAR(moduli[r][c], p[r / D][r % D].dx(static_cast<int>(c)), 2e-12) << r << ' ' << c;
        skew = std::max(skew, std::abs(moduli[r][c] - moduli[c][r]));
      }
  }
  EXPECT_GT(skew, 0.001) << "it is not symmetric";
}

TEST(NeoHookePlaneStrainTest, IsThreeDimensionalWithoutDisplacementAcross) {
  const auto flat = sample<2>(0.3);
  Small<double, 3> deep{};
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) deep[i][j] = flat[i][j];
  EXPECT_NEAR(material.energy(flat), material.energy(deep), 1e-14);
  Small<double, 2> p2{};
  Small<double, 3> p3{};
  Small<double, 4> moduli2{};
  Small<double, 9> moduli3{};
  EXPECT_NEAR(material.stress_and_moduli(flat, p2, moduli2), material.stress_and_moduli(deep, p3, moduli3), 1e-14);
  for (std::size_t r = 0; r < 4; ++r) {
    const std::size_t i = r / 2, j = r % 2;
    EXPECT_NEAR(p2[i][j], p3[i][j], 1e-14);
    for (std::size_t c = 0; c < 4; ++c)
      EXPECT_NEAR(moduli2[r][c], moduli3[i * 3 + j][(c / 2) * 3 + c % 2], 1e-14) << r << ' ' << c;
  }
  // What holds the strain plane.
  EXPECT_NEAR(p3[2][2], lame.lambda * std::log(determinant(deformation_gradient(flat))), 1e-14);
}

}  // namespace
}  // namespace ixos
