// Spectral radius, period error and decay of every scheme for the undamped linear oscillator, over dt/T from 0.01 to
// 10: the library follows the amplification matrices of the literature, and these have the closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/comparison.hpp"
#include "support/scene_text.hpp"
#include "time/catalogue.hpp"
#include "verification/spectral_cases.hpp"

namespace ixos {
namespace {

using test::Amplification;
using test::bathe;
using test::Case;
using test::cases;
using test::central_difference;
using test::composite;
using test::generalized_alpha;
using test::hht;
using test::name;
using test::newmark;
using test::SpectralProperties;
using test::trapezoid;
using test::unbounded;
using test::world;

constexpr double step_ratios[] = {0.01, 0.03, 0.1, 0.3, 1, 3, 10};  ///< dt/T

SpectralProperties properties(const Case& one, double omega_dt) {
  return test::spectral_properties(test::eigenvalues(one.amplification(omega_dt)), omega_dt);
}

/// Circular frequency of the oscillator's scene with this scheme. Lumped, the mass of each of both nodes at the top is
/// a quarter of the whole, 1: the kinetic energy is U'^2/4, the elastic energy U^2/2.
double frequency(const std::string& scheme) {
  return scheme == "Central Difference" ? std::sqrt(2.0) : test::oscillator_frequency();
}

TEST(SpectralTest, EverySchemeHasAClosedForm) {
  for (const Scheme& scheme : schemes()) {
    if (scheme.name == "Static") continue;
    bool found = false;
    for (const Case& one : cases()) found = found || one.scheme == scheme.name;
    EXPECT_TRUE(found) << "\"" << scheme.name << "\" has no closed form: add it to the cases of this test";
  }
}

/// The largest of |u|, |v|/omega, |a|/omega^2.
double size(const std::vector<double>& x, double omega_dt) {
  double largest = 0, scale = 1;
  for (double component : x) {
    largest = std::max(largest, std::abs(component) / scale);
    scale *= omega_dt;
  }
  return largest;
}

/// Five steps of the library from u = 0.02, v = 0.015 omega beside those of the matrix; the last degree of freedom is a
/// vertical one of the top.
void expect_to_follow(Simulation& s, const std::vector<double>& shape, const Amplification& amplification,
                      double omega_dt, double omega) {
  Integrator& integrator = s.integrator();
  const double dt = omega_dt / omega;
  const auto scaled = [&](double factor) {
    std::vector<double> result = shape;
    for (double& value : result) value *= factor;
    return result;
  };
  integrator.initialize(scaled(0.02), scaled(0.015 * omega), 0);
  const bool kinematic = integrator.table().closing == Closing::Kinematic;
  const auto components = static_cast<std::size_t>(amplification.numRows());
  std::vector<double> expected{0.02, 0.015 * omega_dt, -0.02 * omega_dt * omega_dt};
  expected.resize(components);
  double largest = size(expected, omega_dt);
  for (int step = 1; step <= 5; ++step) {
    ASSERT_TRUE(integrator.step(dt).converged);
    std::vector<double> next(components, 0.0);
    for (std::size_t i = 0; i < components; ++i)
      for (std::size_t j = 0; j < components; ++j)
        next[i] += amplification(static_cast<int>(i), static_cast<int>(j)) * expected[j];
    expected = next;
    largest = std::max(largest, size(expected, omega_dt));

    const State& state = integrator.state();
    std::vector<double> error{test::gathered(s.model(), state.u).back() - expected[0],
                              dt * test::gathered(s.model(), state.v).back() - expected[1]};
    if (kinematic && components == 3)
      error.push_back(dt * dt * test::gathered(s.model(), state.a).back() - expected[2]);
    EXPECT_LE(size(error, omega_dt), 1e-11 * largest) << "step " << step << ": " << testing::PrintToString(error);
  }
}

TEST(SpectralTest, TheLibraryFollowsTheMatrices) {
  for (const Scheme& scheme : schemes())
    for (const Case& one : cases()) {
      if (one.scheme != scheme.name) continue;
      const double omega = frequency(scheme.name);
      Simulation s(test::scene(test::oscillator() + test::time_integrator(scheme.name, 0.01, 1, one.parameters)),
                   world());
      const std::vector<double> shape = s.integrator().state().v;  // 1 at the top
      for (double ratio : step_ratios) {
        const double omega_dt = 2 * M_PI * ratio;
        if (scheme.name == "Central Difference" && omega_dt >= 2) continue;
        SCOPED_TRACE(name(one) + " at dt/T = " + testing::PrintToString(ratio));
        expect_to_follow(s, shape, one.amplification(omega_dt), omega_dt, omega);
      }
    }
}

void expect_same(const SpectralProperties& found, const SpectralProperties& expected) {
  const double scale = std::max(1.0, expected.spectral_radius);
  EXPECT_NEAR(found.spectral_radius, expected.spectral_radius, 1e-11 * scale);
  ASSERT_EQ(std::isnan(found.period_error), std::isnan(expected.period_error));
  if (std::isnan(expected.period_error)) return;
  EXPECT_NEAR(found.period_error, expected.period_error, 1e-10 * (1 + std::abs(expected.period_error)));
  EXPECT_NEAR(found.decay, expected.decay, 1e-10 * (1 + std::abs(expected.decay)));
}

TEST(SpectralTest, TheMatricesHaveTheClosedForms) {
  for (const Case& one : cases())
    for (double ratio : step_ratios) {
      const double omega_dt = 2 * M_PI * ratio;
      SCOPED_TRACE(name(one) + " at dt/T = " + testing::PrintToString(ratio));
      expect_same(properties(one, omega_dt), test::spectral_properties(one.roots(omega_dt), omega_dt));
    }
}

TEST(SpectralTest, TheTrapezoidHasItsPeriodAndNoDecay) {
  const std::vector<Case> trapezoids{newmark(0.25, 0.5, 1), composite(0.25, 0.5, 1), composite(0.3, 0.6, 1),
                                     trapezoid("Midpoint"), generalized_alpha(1),    hht(0)};
  for (const Case& one : trapezoids)
    for (double ratio : step_ratios) {
      const double omega_dt = 2 * M_PI * ratio;
      SCOPED_TRACE(name(one) + " at dt/T = " + testing::PrintToString(ratio));
      expect_same(properties(one, omega_dt), {1, omega_dt / (2 * std::atan(omega_dt / 2)) - 1, 0});
    }
}

TEST(SpectralTest, CentralDifferenceHasItsPeriodAndItsLimit) {
  for (double ratio : step_ratios) {
    const double half = M_PI * ratio;
    const SpectralProperties found = properties(central_difference(), 2 * half);
    SCOPED_TRACE("dt/T = " + testing::PrintToString(ratio));
    if (half <= 1) {
      expect_same(found, {1, half / std::asin(half) - 1, 0});
    } else {
      const double larger = std::pow(half + std::sqrt(half * half - 1), 2);
      EXPECT_NEAR(found.spectral_radius, larger, 1e-12 * larger);
      EXPECT_TRUE(std::isnan(found.period_error));
    }
  }
}

TEST(SpectralTest, ValuesAtATenthOfThePeriod) {
  const struct {
    Case one;
    double period_error, decay;  ///< [%]
  } expected[] = {{trapezoid("Midpoint"), 3.207, 0},
                  {bathe(0, 0.5), 1.618, 0.513},
                  {bathe(0.5, 0), 1.149, 0.288},
                  {generalized_alpha(0.5), 4.672, 2.347},
                  {hht(-0.05), 3.611, 0.741}};
  for (const auto& e : expected) {
    const SpectralProperties found = properties(e.one, 0.2 * M_PI);
    EXPECT_NEAR(100 * found.period_error, e.period_error, 6e-4) << name(e.one);
    EXPECT_NEAR(100 * found.decay, e.decay, 6e-4) << name(e.one);
  }
}

TEST(SpectralTest, SpectralRadiusAtInfiniteFrequency) {
  for (const Case& one : cases()) {
    if (one.at_infinity == unbounded) continue;
    // A root of multiplicity m is reached like x^(-2/m). Generalized-alpha's is triple: its distance is ((1 - rho)
    // (1 + rho)^5)^(1/3) x^(-2/3), the factor 1.62 at most.
    for (double omega_dt : {1e3, 1e4, 1e5, 1e6})
      EXPECT_NEAR(properties(one, omega_dt).spectral_radius, one.at_infinity, 2 * std::pow(omega_dt, -2.0 / 3))
          << name(one) << " at omega dt = " << omega_dt;
  }
}

TEST(SpectralTest, StableUpToTheCriticalStep) {
  constexpr int count = 200;
  for (const Case& one : cases()) {
    for (int i = 0; i < count; ++i) {
      const double ratio = std::pow(10, -2 + 3.0 * i / (count - 1));
      const double omega_dt = 2 * M_PI * ratio;
      const double radius = properties(one, omega_dt).spectral_radius;
      if (omega_dt <= one.critical)
        EXPECT_LE(radius, 1 + 1e-12) << name(one) << " at dt/T = " << ratio;
      else
        EXPECT_GT(radius, 1 + 1e-12) << name(one) << " at dt/T = " << ratio;
    }
    if (one.critical == unbounded) continue;
    EXPECT_LE(properties(one, 0.999 * one.critical).spectral_radius, 1 + 1e-12) << name(one);
    EXPECT_GT(properties(one, 1.001 * one.critical).spectral_radius, 1.01) << name(one);
  }
}

}  // namespace
}  // namespace ixos
