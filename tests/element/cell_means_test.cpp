// Cauchy stresses at a point against closed forms, and their means.
#include "element/cell_means.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "material/linear_elastic.hpp"
#include "material/neo_hooke.hpp"
#include "support/displacement_gradients.hpp"

namespace ixos {
namespace {

constexpr Lame lame{0.4, 0.7};

template <std::size_t D>
Small<double, D> gradient() {
  return test::sample<D>(0.3, 0.4);
}

/// Returns the numbers of the components xx, yy, zz, xy, yz, zx.
constexpr std::size_t rows[] = {0, 1, 2, 0, 1, 2}, columns[] = {0, 1, 2, 1, 2, 0};

/// sigma = (mu (B - I) + lambda ln J I)/J, with F_33 = 1 in plane strain.
template <std::size_t D>
void expect_neo_hooke() {
  const Small<double, D> h = gradient<D>();
  Small<double, 3> f{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) f[i][j] += h[i][j];
  const double jacobian = determinant(f);
  const std::array<double, 6> sigma = cauchy_stress(NeoHooke{lame}, h, true);
  for (std::size_t k = 0; k < 6; ++k) {
    const std::size_t i = rows[k], j = columns[k];
    double b = 0;
    for (std::size_t m = 0; m < 3; ++m) b += f[i][m] * f[j][m];
    const double unit = i == j ? 1 : 0;
    const double expected = (lame.mu * (b - unit) + lame.lambda * std::log(jacobian) * unit) / jacobian;
    EXPECT_NEAR(sigma[k], expected, 1e-14) << D << " dimensions, component " << k;
  }
  const std::array<double, 3> means = invariants(NeoHooke{lame}, h);
  EXPECT_NEAR(means[0], sigma[0] + sigma[1] + sigma[2], 1e-14);
  EXPECT_NEAR(means[1], jacobian, 1e-14);
}

TEST(CellMeansTest, NeoHookeanStressIsTheClosedForm) {
  expect_neo_hooke<2>();
  expect_neo_hooke<3>();
}

TEST(CellMeansTest, LinearStressIsHookes) {
  const Small<double, 2> h = gradient<2>();
  const std::array<double, 6> sigma = cauchy_stress(LinearElastic{lame}, h, false);
  const double volume = lame.lambda * (h[0][0] + h[1][1]);
  EXPECT_NEAR(sigma[0], 2 * lame.mu * h[0][0] + volume, 1e-15);
  EXPECT_NEAR(sigma[1], 2 * lame.mu * h[1][1] + volume, 1e-15);
  EXPECT_NEAR(sigma[2], volume, 1e-15);
  EXPECT_NEAR(sigma[3], lame.mu * (h[0][1] + h[1][0]), 1e-15);
  EXPECT_EQ(sigma[4], 0);
  EXPECT_EQ(sigma[5], 0);
}

/// S = 2 mu E' + lambda tr(E') I.
struct Viscous {
  template <std::size_t D, class T>
  Small<T, D> stress(const Small<T, D>& rate) const {
    Small<T, D> s{};
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j)
        s[i][j] = 2 * lame.mu * rate[i][j] + (i == j ? lame.lambda * trace(rate) : T(0.0));
    return s;
  }
};

// F = diag(a, 1, 1), F' = diag(g, 0, 0): E'_11 = a g, and sigma = F S F^T/a.
template <std::size_t D>
void expect_stretched() {
  const double a = 1.4, g = 0.3;
  Small<double, D> h{}, rate{};
  h[0][0] = a - 1;
  rate[0][0] = g;
  const std::array<double, 6> sigma = viscous_cauchy_stress(Viscous(), h, rate);
  EXPECT_NEAR(sigma[0], (2 * lame.mu + lame.lambda) * a * a * g, 1e-14);
  EXPECT_NEAR(sigma[1], lame.lambda * g, 1e-14);
  EXPECT_NEAR(sigma[2], lame.lambda * g, 1e-14) << "out of the plane too";
  for (std::size_t k = 3; k < 6; ++k) EXPECT_NEAR(sigma[k], 0, 1e-15);
}

TEST(CellMeansTest, ViscousStressOfAStretchIsTheClosedForm) {
  expect_stretched<2>();
  expect_stretched<3>();
}

TEST(CellMeansTest, ASpinHasNoViscousStress) {
  const Small<double, 3> h = gradient<3>(), f = deformation_gradient(h);
  const Small<double, 3> spin{{{0, -0.3, 0.2}, {0.3, 0, -0.7}, {-0.2, 0.7, 0}}};
  Small<double, 3> rate{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) rate[i][j] += spin[i][k] * f[k][j];
  for (double component : viscous_cauchy_stress(Viscous(), h, rate)) EXPECT_NEAR(component, 0, 1e-15);
}

TEST(CellMeansTest, MeansWeighPointsByTheirVolumes) {
  const double weights[] = {1, 3};
  const auto mean = mean_over(2, weights, [](std::size_t q) { return std::array<double, 2>{q == 0 ? 2.0 : 6.0, 1.0}; });
  EXPECT_EQ(mean[0], 5);
  EXPECT_EQ(mean[1], 1);
}

}  // namespace
}  // namespace ixos
