// The viscous stress of a stage: gradient of its energy, its moduli, and the energy that its work dissipates.
#include "element/viscous_point.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ixos {
namespace {

template <std::size_t D>
Small<double, D> wave(double size, double phase) {
  Small<double, D> m;
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j)
      m[i][j] = size * std::sin(phase + 1.3 * static_cast<double>(i) + 0.7 * static_cast<double>(j));
  return m;
}

const Hooke law{{0.7, 0.4}};
constexpr double dt = 0.25;

/// A finite change of a strained body.
template <std::size_t D>
ViscousPoint<D, double> point(RateForm form) {
  Small<double, D> known = wave<D>(0.05, 3);
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < i; ++j) known[i][j] = known[j][i];
  if (form == RateForm::Middle) return {law, form, 1.0, 1 / dt, wave<D>(0.4, 1), wave<D>(0.3, 2), {}};
  return {law, form, 2.0, 1 / dt, wave<D>(0.4, 1), wave<D>(0.3, 2), known};
}

template <std::size_t D>
void expect_gradient(RateForm form) {
  const ViscousPoint<D, double> here = point<D>(form);
  const Small<double, D> p = here.stress();
  const double step = 1e-5;
  for (std::size_t i = 0; i < D * D; ++i) {
    ViscousPoint<D, double> more = here, less = here;
    more.change[i / D][i % D] += step;
    less.change[i / D][i % D] -= step;
    EXPECT_NEAR((more.energy() - less.energy()) / (2 * step), p[i / D][i % D], 1e-8) << D << " " << i;
  }
}

TEST(ViscousPointTest, TheStressIsTheGradientOfTheEnergy) {
  expect_gradient<2>(RateForm::End);
  expect_gradient<3>(RateForm::End);
}

template <std::size_t D>
void expect_moduli(RateForm form) {
  const ViscousPoint<D, double> here = point<D>(form);
  Small<double, D * D> moduli{}, differences{};
  here.add_moduli(3.0, moduli);
  const double step = 1e-5;
  for (std::size_t c = 0; c < D * D; ++c) {
    ViscousPoint<D, double> more = here, less = here;
    more.change[c / D][c % D] += step;
    less.change[c / D][c % D] -= step;
    const Small<double, D> high = more.stress(), low = less.stress();
    for (std::size_t r = 0; r < D * D; ++r)
      differences[r][c] = 3 * (high[r / D][r % D] - low[r / D][r % D]) / (2 * step);
  }
  double asymmetry = 0;
  for (std::size_t r = 0; r < D * D; ++r)
    for (std::size_t c = 0; c < D * D; ++c) {
      EXPECT_NEAR(moduli[r][c], (differences[r][c] + differences[c][r]) / 2, 1e-7) << D << " " << r << " " << c;
      asymmetry = std::max(asymmetry, std::abs(differences[r][c] - differences[c][r]));
    }
  if (form == RateForm::End)
    EXPECT_LT(asymmetry, 1e-7);
  else
    EXPECT_GT(asymmetry, 1e-3);
}

TEST(ViscousPointTest, ModuliAreTheSymmetricPartOfTheDerivative) {
  for (RateForm form : {RateForm::End, RateForm::Middle}) {
    expect_moduli<2>(form);
    expect_moduli<3>(form);
  }
}

TEST(ViscousPointTest, InMomentumFormTheWorkIsWhatIsDissipated) {
  const ViscousPoint<3, double> here = point<3>(RateForm::Middle);
  EXPECT_NEAR(contraction(here.stress(), here.change), here.dissipated(), 1e-14);
  EXPECT_GT(here.dissipated(), 0.01);
}

// The row of the trapezoid, 2 (E - E_n) - dt E'_n, on strains that grow evenly: the rate at the end is that at the
// start.
TEST(ViscousPointTest, TheRowOfAnEvenRateIsThatRate) {
  const Small<double, 2> zero{};
  const Small<double, 2> rate{{{0.4, 0}, {0, 0}}};
  Small<double, 2> stretched{};
  stretched[0][0] = std::sqrt(1 + 2 * dt * 0.4) - 1;  // E_11 = dt 0.4
  const ViscousPoint<2, double> here{law, RateForm::End, 2.0, 1 / dt, zero, stretched, {{{-dt * 0.4, 0}, {0, 0}}}};
  const Small<double, 2> s = law.stress(rate), p = here.stress();
  EXPECT_NEAR(p[0][0], (1 + stretched[0][0]) * s[0][0], 1e-14);
  EXPECT_NEAR(p[1][1], s[1][1], 1e-14);
}

}  // namespace
}  // namespace ixos
