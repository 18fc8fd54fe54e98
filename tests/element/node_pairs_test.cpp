#include "element/node_pairs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ixos {
namespace {

template <std::size_t Rows, std::size_t Columns>
Small<double, Rows, Columns> waves(double phase) {
  Small<double, Rows, Columns> result{};
  for (auto& row : result)
    for (double& entry : row) entry = std::sin(phase += 1.7);
  return result;
}

/// Moduli A[iJ][kL] = A[kL][iJ].
template <std::size_t D>
Small<double, D * D> symmetric_moduli(double phase) {
  Small<double, D* D> moduli = waves<D * D, D * D>(phase);
  for (std::size_t r = 0; r < D * D; ++r)
    for (std::size_t c = 0; c < r; ++c) moduli[r][c] = moduli[c][r];
  return moduli;
}

/// Adds the sum over all indices, as it is written.
template <std::size_t L, std::size_t R, std::size_t D>
void add_all(const Small<double, L, D>& left, const Small<double, R, D>& right, const Small<double, D * D>& moduli,
             Small<double, L * D, R * D>& k) {
  for (std::size_t row = 0; row < L * D; ++row)
    for (std::size_t column = 0; column < R * D; ++column)
      for (std::size_t j = 0; j < D; ++j)
        for (std::size_t l = 0; l < D; ++l)
          k[row][column] += left[row / D][j] * moduli[row % D * D + j][column % D * D + l] * right[column / D][l];
}

template <std::size_t Rows, std::size_t Columns>
void expect_near(const Small<double, Rows, Columns>& k, const Small<double, Rows, Columns>& expected) {
  for (std::size_t r = 0; r < Rows; ++r)
    for (std::size_t c = 0; c < Columns; ++c) EXPECT_NEAR(k[r][c], expected[r][c], 1e-12) << r << ' ' << c;
}

template <std::size_t L, std::size_t R, std::size_t D>
void expect_contraction() {
  const auto left = waves<L, D>(0.3);
  const auto right = waves<R, D>(1.1);
  const auto moduli = waves<D * D, D * D>(2.3);
  auto k = waves<L * D, R * D>(0.7), expected = k;
  add_contraction<false>(left, right, moduli, k);
  add_all(left, right, moduli, expected);
  expect_near(k, expected);
}

TEST(AddContractionTest, AddsTheSumOverAllIndices) {
  expect_contraction<4, 4, 2>();
  expect_contraction<3, 5, 2>();
  expect_contraction<8, 2, 3>();
}

template <std::size_t N, std::size_t D>
void expect_mirrored_contraction() {
  const auto gradients = waves<N, D>(0.3);
  const auto moduli = symmetric_moduli<D>(2.3);
  auto k = waves<N * D, N * D>(0.7), expected = k;  // what is there already need not be symmetric
  add_contraction<true>(gradients, gradients, moduli, k);
  add_all(gradients, gradients, moduli, expected);
  expect_near(k, expected);
}

TEST(AddContractionTest, TheMirroredTriangleIsThatOfTheSum) {
  expect_mirrored_contraction<4, 2>();
  expect_mirrored_contraction<8, 3>();
}

template <std::size_t N, std::size_t D>
using Points = std::array<SpatialPoint<double, N, D>, points_at_once>;

/// `count` points; the others hold no numbers.
template <std::size_t N, std::size_t D>
Points<N, D> some_points(std::size_t count) {
  constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
  Points<N, D> points{};
  for (std::size_t q = 0; q < points_at_once; ++q) {
    const double phase = static_cast<double>(q);
    points[q].reference = waves<N, D>(q < count ? phase : not_a_number);
    points[q].current = waves<N, D>(q < count ? phase + 0.5 : not_a_number);
    points[q].moduli = {1.5 + std::sin(phase), 0.8 + std::cos(phase), std::sin(3 * phase + 1)};
  }
  return points;
}

template <std::size_t N, std::size_t D>
void expect_products(std::size_t count) {
  const Points<N, D> points = some_points<N, D>(count);
  auto k = waves<N * D, N * D>(0.7), expected = k;
  add_products(points, count, k);
  for (std::size_t q = 0; q < count; ++q)
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t b = 0; b < N; ++b) {
        const auto &n = points[q].reference, &g = points[q].current;
        const SpatialTangent<double>& moduli = points[q].moduli;
        for (std::size_t i = 0; i < D; ++i)
          for (std::size_t j = 0; j < D; ++j) {
            double& entry = expected[a * D + i][b * D + j];
            entry += moduli.c * g[b][i] * g[a][j] + moduli.lambda * g[a][i] * g[b][j];
            for (std::size_t m = 0; m < D && i == j; ++m) entry += moduli.mu * n[a][m] * n[b][m];
          }
      }
  expect_near(k, expected);
}

TEST(AddProductsTest, AddsTheSumOverThePoints) {
  for (std::size_t count : {std::size_t{1}, std::size_t{3}, points_at_once}) {
    expect_products<4, 2>(count);
    expect_products<8, 3>(count);
  }
}

// Pulled back to the reference body, the moduli are A_iJkL = mu delta_ik delta_JL + c G_Li G_Jk + lambda G_Ji G_Lk with
// G = F^-1: both ways of computing a tangent meet.
template <std::size_t N, std::size_t D>
void expect_same_tangent() {
  Small<double, D> f = waves<D, D>(0.4);
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) f[i][j] = (i == j ? 1.0 : 0.0) + 0.3 * f[i][j];
  const Small<double, D> inverse_f = inverse(f, determinant(f));
  const double mu = 1.3, c = 0.6, lambda = 0.9;

  Points<N, D> points{};
  points[0].reference = waves<N, D>(0.3);
  points[0].moduli = {mu, c, lambda};
  for (std::size_t a = 0; a < N; ++a)
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) points[0].current[a][i] += points[0].reference[a][j] * inverse_f[j][i];
  Small<double, N * D> spatial{}, material{};
  add_products(points, 1, spatial);

  Small<double, D * D> moduli{};
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j)
      for (std::size_t k = 0; k < D; ++k)
        for (std::size_t l = 0; l < D; ++l)
          moduli[i * D + j][k * D + l] = (i == k && j == l ? mu : 0.0) + c * inverse_f[l][i] * inverse_f[j][k] +
                                         lambda * inverse_f[j][i] * inverse_f[l][k];
  add_contraction<true>(points[0].reference, points[0].reference, moduli, material);
  expect_near(spatial, material);
}

TEST(AddProductsTest, TheTangentIsThatOfTheReferenceBody) {
  expect_same_tangent<4, 2>();
  expect_same_tangent<8, 3>();
}

}  // namespace
}  // namespace ixos
