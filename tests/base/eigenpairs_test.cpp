#include "base/eigenpairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace ixos {
namespace {

/// Expects A = sum_i value_i n_i n_i^T and n_i . n_j = delta_ij, to rounding errors of the largest entry.
template <std::size_t D>
void expect_decomposition(const Small<double, D>& a, const Eigenpairs<double, D>& pairs) {
  double size = 0;
  for (const auto& row : a)
    for (const double value : row) size = std::max(size, std::abs(value));
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) {
      double sum = 0, dot = 0;
      for (std::size_t k = 0; k < D; ++k) {
        sum += pairs.value[k] * pairs.vector[k][i] * pairs.vector[k][j];
        dot += pairs.vector[i][k] * pairs.vector[j][k];
      }
      EXPECT_NEAR(sum, a[i][j], 4e-15 * size);
      EXPECT_NEAR(dot, i == j ? 1 : 0, 2e-15);
    }
}

template <std::size_t D>
Small<double, D> noise(std::mt19937& engine, double size) {
  std::uniform_real_distribution<double> number(-size, size);
  Small<double, D> a;
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = i; j < D; ++j) a[i][j] = a[j][i] = number(engine);
  return a;
}

TEST(EigenpairsTest, OfRandomMatricesGiveThemBack) {
  std::mt19937 engine(1);
  for (const double size : {1e-12, 1.0, 1e9})
    for (int k = 0; k < 1000; ++k) {
      const auto plane = noise<2>(engine, size);
      const auto space = noise<3>(engine, size);
      expect_decomposition(plane, eigenpairs(plane));
      expect_decomposition(space, eigenpairs(space));
    }
}

TEST(EigenpairsTest, OfEqualAndNearlyEqualEigenvaluesAreOrthonormal) {
  std::mt19937 engine(2);
  for (const double gap : {0.0, 1e-16, 1e-12, 1e-8, 1e-4}) {
    const Small<double, 3> frame = eigenpairs(noise<3>(engine, 1)).vector;
    Small<double, 3> a{};
    const std::array<double, 3> values{0.7, 0.7 + gap, 0.7 - 3 * gap};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < 3; ++k) a[i][j] += values[k] * frame[k][i] * frame[k][j];
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < i; ++j) a[i][j] = a[j][i];
    expect_decomposition(a, eigenpairs(a));
  }
  expect_decomposition(Small<double, 3>{}, eigenpairs(Small<double, 3>{}));
}

TEST(EigenpairsTest, OfAPlaneMatrixAreTheClosedForm) {
  const Small<double, 2> a{{{0.3, 0.4}, {0.4, -0.3}}};  // eigenvalues 1/2 and -1/2
  auto values = eigenpairs(a).value;
  std::sort(values.begin(), values.end());
  EXPECT_NEAR(values[0], -0.5, 1e-16);
  EXPECT_NEAR(values[1], 0.5, 1e-16);
}

TEST(EigenpairsTest, LanesOfAPackAreIndependent) {
  std::mt19937 engine(3);
  Small<Pack, 3> a;
  std::array<Small<double, 3>, Pack::size()> single;
  for (std::size_t lane = 0; lane < Pack::size(); ++lane) {
    single[lane] = noise<3>(engine, std::pow(10.0, -static_cast<double>(lane)));
    if (lane == 1) single[lane] = {};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) a[i][j][lane] = single[lane][i][j];
  }
  const Eigenpairs<Pack, 3> all = eigenpairs(a);
  for (std::size_t lane = 0; lane < Pack::size(); ++lane) {
    Eigenpairs<double, 3> own;
    for (std::size_t i = 0; i < 3; ++i) {
      own.value[i] = all.value[i][lane];
      for (std::size_t j = 0; j < 3; ++j) own.vector[i][j] = all.vector[i][j][lane];
    }
    expect_decomposition(single[lane], own);
  }
}

}  // namespace
}  // namespace ixos
