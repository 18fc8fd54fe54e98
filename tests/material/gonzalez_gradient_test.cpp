#include "material/gonzalez_gradient.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

#include "material/isochoric_law.hpp"
#include "material/ogden_law.hpp"
#include "support/automatic_differentiation.hpp"
#include "support/derivative.hpp"
#include "support/displacement_gradients.hpp"

namespace ixos {
namespace {

/// Gent's law near its limit: strongly curved.
struct Stiffening {
  static constexpr bool has_limit = true;
  template <class T>
  T energy(const T& x, const T&) const {
    return -1.0 * log_one_plus(T(-1.0 * x));
  }
  template <class T>
  Slopes<T> slopes(const T& x, const T&) const {
    return {T(1.0 / (1.0 - x)), T(0.0)};
  }
  template <class T>
  Curvatures<T> curvatures(const T& x, const T&) const {
    return {T(1.0 / ((1.0 - x) * (1.0 - x))), T(0.0), T(0.0)};
  }
  template <class T>
  T room(const T& x, const T&) const {
    return 1.0 - x;
  }
};
const IsochoricLaw<Stiffening> gent{{}, {5.0, VolumetricEnergy::Form::Logarithm}, {2.0, 5.0 - 4.0 / 3}};
const OgdenLaw ogden{{{1.2, 1.5}, {-0.2, -2.0}}, {3.0, VolumetricEnergy::Form::Convex}, {1.1, 3.0 - 2.2 / 3}};

using test::sample;

template <std::size_t D>
Small<double, D> sum(Small<double, D> a, const Small<double, D>& b) {
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) a[i][j] += b[i][j];
  return a;
}

template <class Law, std::size_t D>
double energy(const Law& law, const Small<double, D>& h) {
  return law.energy(StrainState<D, double>(green_strain_doubled(h), determinant(deformation_gradient(h))));
}
template <class Law, std::size_t D>
Small<double, D> stress(const Law& law, const Small<double, D>& h0, const Small<double, D>& h1) {
  return GonzalezGradient<Law, D, double>(law, h0, h1).stress();
}
template <std::size_t D>
double work(const Small<double, D>& p, const Small<double, D>& h0, const Small<double, D>& h1) {
  double sum = 0;
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) sum += p[i][j] * (h1[i][j] - h0[i][j]);
  return sum;
}

template <class D>
class GonzalezGradientTest : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<std::size_t, 2>, std::integral_constant<std::size_t, 3>>;
TYPED_TEST_SUITE(GonzalezGradientTest, Dimensions);

template <std::size_t D, class Law>
void expect_work_is_the_change_of_energy(const Law& law) {
  for (const double strain : {1e-8, 1e-4, 0.05, 0.15})
    for (const double step : {1e-12, 1e-9, 1e-7, 1e-5, 1e-3, 1e-2, 0.1, 1.0}) {
      const auto h0 = sample<D>(strain, 0.4), h1 = sum(h0, sample<D>(step * strain, 2.9));
      const double before = energy(law, h0), after = energy(law, h1);
      EXPECT_NEAR(work(stress(law, h0, h1), h0, h1), after - before, 2e-14 * (before + after)) << strain << ' ' << step;
    }
}

TYPED_TEST(GonzalezGradientTest, TheWorkIsTheChangeOfTheEnergyAtAnyStep) {
  expect_work_is_the_change_of_energy<TypeParam::value>(gent);
  expect_work_is_the_change_of_energy<TypeParam::value>(ogden);
}

TYPED_TEST(GonzalezGradientTest, TheWorkIsTheChangeOfTheEnergyAfterALargeRotation) {
  constexpr std::size_t D = TypeParam::value;
  auto h0 = sample<D>(0.1, 0.4), h1 = h0;
  const double c = std::cos(1.0), s = std::sin(1.0);  // F1 = R F0, then a small strain
  for (std::size_t j = 0; j < D; ++j) {
    const double x = h0[0][j] + (j == 0 ? 1 : 0), y = h0[1][j] + (j == 1 ? 1 : 0);
    h1[0][j] = c * x - s * y - (j == 0 ? 1 : 0);
    h1[1][j] = s * x + c * y - (j == 1 ? 1 : 0);
  }
  EXPECT_NEAR(work(stress(ogden, h0, h1), h0, h1), 0, 2e-15);
  h1 = sum(h1, sample<D>(0.05, 1.1));
  EXPECT_NEAR(work(stress(ogden, h0, h1), h0, h1), energy(ogden, h1) - energy(ogden, h0), 4e-15);
}

/// Order 2: the stress in the middle up to the square of the step. Without a step, the stress itself.
TYPED_TEST(GonzalezGradientTest, IsConsistent) {
  constexpr std::size_t D = TypeParam::value;
  const auto h = sample<D>(0.1, 0.4), direction = sample<D>(1, 2.9);
  const auto middle = stress(gent, h, h);
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) {
      const double p = test::derivative([&](double step) {
        auto there = h;
        there[i][j] += step;
        return energy(gent, there);
      });
      EXPECT_NEAR(middle[i][j], p, 1e-9);
    }
  double previous = 0;
  for (const double step : {0.04, 0.02, 0.01}) {
    auto h0 = h, h1 = h;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) {
        h0[i][j] -= step / 2 * direction[i][j];
        h1[i][j] += step / 2 * direction[i][j];
      }
    const auto p = stress(gent, h0, h1);
    double error = 0;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) error += (p[i][j] - middle[i][j]) * (p[i][j] - middle[i][j]);
    error = std::sqrt(error);
    if (previous > 0) {
      EXPECT_NEAR(previous / error, 4, 0.4);
    }
    previous = error;
  }
}

/// P F_m^T is symmetric: no moment.
TYPED_TEST(GonzalezGradientTest, KeepsAngularMomentum) {
  constexpr std::size_t D = TypeParam::value;
  const auto h0 = sample<D>(0.15, 0.4), h1 = sum(h0, sample<D>(0.1, 2.9));
  for (const auto& p : {stress(gent, h0, h1), stress(ogden, h0, h1)}) {
    Small<double, D> moment{};
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j)
        for (std::size_t k = 0; k < D; ++k)
          moment[i][j] += p[i][k] * (0.5 * (h0[j][k] + h1[j][k]) + (j == k ? 1.0 : 0.0));
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < i; ++j) EXPECT_NEAR(moment[i][j], moment[j][i], 1e-15);
  }
}

TYPED_TEST(GonzalezGradientTest, ModuliAreTheDerivativeOfTheStress) {
  constexpr std::size_t D = TypeParam::value;
  using Variable = test::Dual<static_cast<int>(D * D)>;
  for (const double step : {0.0, 1e-9, 1e-3, 0.03, 0.2}) {  // without and with the correction
    const auto h0 = sample<D>(0.1, 0.4), h1 = sum(h0, sample<D>(step, 2.9));
    Small<Variable, D> start{}, end{};
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) {
        start[i][j] = h0[i][j];
        end[i][j] = test::variable<static_cast<int>(D * D)>(static_cast<int>(i * D + j), h1[i][j]);
      }
    const auto p = GonzalezGradient<IsochoricLaw<Stiffening>, D, Variable>(gent, start, end).stress();
    Small<double, D * D> moduli;
    GonzalezGradient<IsochoricLaw<Stiffening>, D, double>(gent, h0, h1).moduli(moduli);
    for (std::size_t r = 0; r < D * D; ++r)
      for (std::size_t c = 0; c < D * D; ++c)
        EXPECT_NEAR(moduli[r][c], p[r / D][r % D].dx(static_cast<int>(c)), 1e-11) << step;
  }
}

}  // namespace
}  // namespace ixos
