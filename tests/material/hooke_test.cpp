// Kelvin and Voigt's stress: its frame indifference, its derivative, and the digits of small changes of strain.
#include "material/hooke.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ixos {
namespace {

const Hooke law{{0.7, 0.4}};

Small<double, 3> rotation(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {{{c, -s * 0.6, s * 0.8},
           {s * 0.6, 0.64 + c * 0.36, 0.48 * (1 - c)},
           {-s * 0.8, 0.48 * (1 - c), 0.36 + 0.64 * c}}};
}

Small<double, 3> product(const Small<double, 3>& a, const Small<double, 3>& b) {
  Small<double, 3> c{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
  return c;
}

Small<double, 3> wave(double size, double phase) {
  Small<double, 3> m;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      m[i][j] = size * std::sin(phase + 2.1 * static_cast<double>(i) + 0.7 * static_cast<double>(j));
  return m;
}

Small<double, 3> stress(const Small<double, 3>& f, const Small<double, 3>& g) {
  return product(f, law.stress(symmetric_product(f, g)));
}

TEST(HookeTest, AStretchRateHasTheStressOfTheModuli) {
  const Small<double, 3> s = law.stress(Small<double, 3>{{{2, 0.5, 0}, {0.5, 0, 0}, {0, 0, 0}}});
  EXPECT_DOUBLE_EQ(s[0][0], 2 * 0.7 * 2 + 0.4 * 2);
  EXPECT_DOUBLE_EQ(s[1][1], 0.4 * 2);
  EXPECT_DOUBLE_EQ(s[0][1], 2 * 0.7 * 0.5);
}

// x = R(t) X: F = R, F' = W R with W antisymmetric.
TEST(HookeTest, ARigidRotationHasNoStress) {
  const Small<double, 3> r = rotation(1.1), w{{{0, -3, 2}, {3, 0, -1}, {-2, 1, 0}}};
  const Small<double, 3> s = law.stress(symmetric_product(r, product(w, r)));
  for (const auto& row : s)
    for (double value : row) EXPECT_NEAR(value, 0, 1e-15);
}

TEST(HookeTest, ARotatedMotionHasTheRotatedStress) {
  Small<double, 3> f = wave(0.3, 1), g = wave(0.8, 2);
  for (std::size_t i = 0; i < 3; ++i) f[i][i] += 1;
  const Small<double, 3> q = rotation(0.8), expected = product(q, stress(f, g)),
                         found = stress(product(q, f), product(q, g));
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(found[i][j], expected[i][j], 1e-14);
}

// P = F S(F^T G): the derivative by G with rate 1, and that by F with held 1 and G in place of the second factor.
TEST(HookeTest, ModuliAreTheDerivativesOfTheStress) {
  Small<double, 3> f = wave(0.3, 1), g = wave(0.8, 2);
  for (std::size_t i = 0; i < 3; ++i) f[i][i] += 1;
  const Small<double, 3> s = law.stress(symmetric_product(f, g));
  Small<double, 9> by_velocity{}, by_displacement{};
  law.add_moduli(f, f, s, 0.0, 1.0, by_velocity);
  law.add_moduli(f, g, s, 1.0, 1.0, by_displacement);
  const double step = 1e-6;
  for (std::size_t column = 0; column < 9; ++column) {
    const auto difference = [&](bool velocity) {
      Small<double, 3> result{};
      for (const double sign : {1.0, -1.0}) {
        Small<double, 3> f1 = f, g1 = g;
        (velocity ? g1 : f1)[column / 3][column % 3] += sign * step;
        const Small<double, 3> p = stress(f1, g1);
        for (std::size_t i = 0; i < 9; ++i) result[i / 3][i % 3] += sign * p[i / 3][i % 3] / (2 * step);
      }
      return result;
    };
    const Small<double, 3> velocity = difference(true), displacement = difference(false);
    for (std::size_t row = 0; row < 9; ++row) {
      EXPECT_NEAR(by_velocity[row][column], velocity[row / 3][row % 3], 1e-9);
      EXPECT_NEAR(by_displacement[row][column], displacement[row / 3][row % 3], 1e-9);
    }
  }
}

TEST(HookeTest, ASmallChangeOfStrainKeepsItsDigits) {
  const Small<double, 2> h0{{{1e3, 0}, {0, 1e3}}}, dh{{{1e-12, 0}, {0, 0}}};
  const Small<double, 2> e = change_of_strain(h0, dh);
  EXPECT_DOUBLE_EQ(e[0][0], 1001 * 1e-12);  // (F dF + dF F)/2; the differences of squares have lost all digits
  EXPECT_EQ(e[1][1], 0);
  EXPECT_EQ(contraction(h0, h0), 2e6);
}

}  // namespace
}  // namespace ixos
