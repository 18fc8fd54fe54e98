#include "base/ldl.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ixos {
namespace {

template <std::size_t N>
Small<double, N> waves(double phase) {
  Small<double, N> a{};
  for (auto& row : a)
    for (double& entry : row) entry = std::sin(phase += 1.7);
  return a;
}

/// Returns A A^T + I.
template <std::size_t N>
Small<double, N> positive_definite(double phase) {
  const Small<double, N> a = waves<N>(phase);
  Small<double, N> k{};
  for (std::size_t r = 0; r < N; ++r)
    for (std::size_t c = 0; c < N; ++c) {
      k[r][c] = r == c ? 1.0 : 0.0;
      for (std::size_t m = 0; m < N; ++m) k[r][c] += a[r][m] * a[c][m];
    }
  return k;
}

template <std::size_t N>
std::array<double, N> product(const Small<double, N>& k, const std::array<double, N>& x) {
  std::array<double, N> b{};
  for (std::size_t r = 0; r < N; ++r)
    for (std::size_t c = 0; c < N; ++c) b[r] += k[r][c] * x[c];
  return b;
}

template <std::size_t N>
void expect_solution() {
  const Small<double, N> k = positive_definite<N>(0.3);
  const std::array<double, N> x = waves<N>(2.1)[0];
  std::array<double, N> b = product(k, x);
  const Ldl<double, N> ldl(k);
  EXPECT_GT(ldl.least_pivot(), 0.0);
  ldl.solve(b);
  for (std::size_t r = 0; r < N; ++r) EXPECT_NEAR(b[r], x[r], 1e-13) << N << ' ' << r;
}

TEST(LdlTest, SolvesPositiveDefiniteSystems) {
  expect_solution<1>();
  expect_solution<2>();
  expect_solution<3>();
  expect_solution<6>();
}

// Worked out by hand; all numbers are exact. The upper triangle is not read.
TEST(LdlTest, FactorsASystemOfTwoAsByHand) {
  const Ldl<double, 2> ldl({{{4.0, std::numeric_limits<double>::quiet_NaN()}, {2.0, 3.0}}});
  EXPECT_EQ(ldl.inverse_pivot(0), 1 / 4.0);
  EXPECT_EQ(ldl.inverse_pivot(1), 1 / 2.0);
  EXPECT_EQ(ldl.least_pivot(), 2.0);
  std::array<double, 2> half{8.0, 7.0}, whole = half;
  ldl.forward(half);
  EXPECT_EQ(half[0], 8.0);
  EXPECT_EQ(half[1], 3.0);
  ldl.solve(whole);
  EXPECT_EQ(whole[0], 1.25);
  EXPECT_EQ(whole[1], 1.5);
}

TEST(LdlTest, PivotsAreTheGivenOnes) {
  constexpr std::size_t n = 4;
  const std::array<double, n> pivot{2.0, -3.0, 0.5, -1.0};
  Small<double, n> lower = waves<n>(0.3), k{};
  for (std::size_t r = 0; r < n; ++r) {
    lower[r][r] = 1;
    for (std::size_t c = r + 1; c < n; ++c) lower[r][c] = 0;
  }
  for (std::size_t r = 0; r < n; ++r)
    for (std::size_t c = 0; c < n; ++c)
      for (std::size_t m = 0; m < n; ++m) k[r][c] += lower[r][m] * pivot[m] * lower[c][m];
  const Ldl<double, n> ldl(k);
  for (std::size_t r = 0; r < n; ++r) EXPECT_NEAR(ldl.inverse_pivot(r) * pivot[r], 1, 1e-13) << r;
  EXPECT_NEAR(ldl.least_pivot(), -3, 1e-13);
}

TEST(LdlTest, PivotsMultiplyToTheDeterminant) {
  const Small<double, 3> k = positive_definite<3>(0.9);
  const Ldl<double, 3> ldl(k);
  EXPECT_NEAR(determinant(k) * ldl.inverse_pivot(0) * ldl.inverse_pivot(1) * ldl.inverse_pivot(2), 1, 1e-13);
}

TEST(LdlTest, ForwardSubstitutionIsHalfOfTheSolution) {
  constexpr std::size_t n = 5;
  const Ldl<double, n> ldl(positive_definite<n>(0.3));
  const std::array<double, n> x = waves<n>(1.1)[0];
  std::array<double, n> solution = x, half = x;
  ldl.solve(solution);
  ldl.forward(half);
  double form = 0, sum = 0;  // x^T K^-1 x, and the same from the squares of L^-1 x
  for (std::size_t r = 0; r < n; ++r) {
    form += x[r] * solution[r];
    sum += half[r] * half[r] * ldl.inverse_pivot(r);
  }
  EXPECT_NEAR(form, sum, 1e-13);
}

TEST(LdlTest, EachLaneIsASystemOfItsOwn) {
  constexpr std::size_t n = 3;
  Small<Pack, n> k{};
  std::array<Pack, n> x{};
  for (std::size_t i = 0; i < Pack::size(); ++i) {
    Small<double, n> own = positive_definite<n>(static_cast<double>(i));
    if (i == 1) own[1][1] = -1;  // not positive definite
    for (std::size_t r = 0; r < n; ++r) {
      x[r][i] = std::cos(static_cast<double>(i + r));
      for (std::size_t c = 0; c < n; ++c) k[r][c][i] = own[r][c];
    }
  }
  const Ldl<Pack, n> ldl(k);
  std::array<Pack, n> solution = x;
  ldl.solve(solution);
  for (std::size_t i = 0; i < Pack::size(); ++i) {
    EXPECT_EQ(lane(ldl.least_pivot(), i) > 0, i != 1) << i;
    for (std::size_t r = 0; r < n; ++r) {
      double sum = 0;
      for (std::size_t c = 0; c < n; ++c) sum += lane(k[r][c], i) * lane(solution[c], i);
      EXPECT_NEAR(sum, lane(x[r], i), 1e-12) << i << ' ' << r;
    }
  }
}

}  // namespace
}  // namespace ixos
