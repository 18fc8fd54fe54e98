// Spectral radius, period error and decay of every scheme for the undamped linear oscillator, over dt/T from 0.01 to
// 10: the library follows the amplification matrices of the literature, and these have the closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "scene/simulation.hpp"
#include "support/amplification.hpp"
#include "support/bodies.hpp"
#include "support/comparison.hpp"
#include "support/scene_text.hpp"
#include "time/catalogue.hpp"

namespace ixos {
namespace {

using test::Amplification;
using test::SpectralProperties;
using test::world;
using Complex = std::complex<double>;
using Roots = std::vector<Complex>;

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr double step_ratios[] = {0.01, 0.03, 0.1, 0.3, 1, 3, 10};  ///< dt/T

/// Roots of x^2 - p x + q.
Roots quadratic(double p, double q) {
  const Complex half_width = std::sqrt(Complex(p * p / 4 - q));
  return {p / 2 + half_width, p / 2 - half_width};
}

/// Roots of c3 x^3 + c2 x^2 + c1 x + c0, by Cardano's formula.
Roots cubic(double c3, double c2, double c1, double c0) {
  const double b = c2 / c3, c = c1 / c3, d = c0 / c3;
  const double d0 = b * b - 3 * c, d1 = 2 * b * b * b - 9 * b * c + 27 * d;
  const Complex root = std::sqrt(Complex(d1 * d1 - 4 * d0 * d0 * d0));
  const Complex first = std::pow((d1 + (d1 > 0 ? root : -root)) / 2.0, 1.0 / 3);
  if (first == 0.0) return {-b / 3, -b / 3, -b / 3};
  Roots roots;
  for (int k = 0; k < 3; ++k) {
    const Complex turned = first * std::polar(1.0, 2 * M_PI * k / 3);
    roots.push_back(-(b + turned + d0 / turned) / 3.0);
  }
  return roots;
}

/// Both roots are R(i omega dt) and its conjugate where the scheme is a Runge-Kutta method of stability function R.
Roots conjugates(Complex value) { return {value, std::conj(value)}; }

Roots trapezoid_roots(double x) { return conjugates(Complex(1, x / 2) / Complex(1, -x / 2)); }

// Zienkiewicz 1977, for beta = 0 too.
Roots newmark_roots(double beta, double gamma, double x) {
  const double z = x * x / (1 + beta * x * x);
  return quadratic(2 - (gamma + 0.5) * z, 1 - (gamma - 0.5) * z);
}

// The determinant is 1 for any r = gamma/beta.
Roots composite_roots(double r, double x) { return quadratic(2 - r * x * x / (r + x * x / 2), 1); }

Roots bathe_roots(double rho, double split, double x) {
  const double q1 = (rho + 1) / (2 * split * (rho - 1) + 4);
  const double q0 = (split - 1) * q1 + 0.5;
  const double q2 = 0.5 - split * q1;
  const Complex z(0, x);
  const Complex first = (1.0 + split / 2 * z) / (1.0 - split / 2 * z);
  return conjugates((1.0 + q0 * z + q1 * z * first) / (1.0 - q2 * z));
}

/// Of D (x - 1)^2 + (omega dt)^2 F N = 0 with D = (1 - a_m) x + a_m and F = (1 - a_f) x + a_f; Newmark's kinematics are
/// (x - 1)^2 u = N dt^2 a, N = beta x^2 + (gamma + 1/2 - 2 beta) x + 1/2 - gamma + beta.
Roots alpha_roots(double a_m, double a_f, double beta, double gamma, double omega_dt) {
  const double z = omega_dt * omega_dt;
  const double n1 = gamma + 0.5 - 2 * beta, n0 = 0.5 - gamma + beta;
  return cubic(1 - a_m + z * (1 - a_f) * beta, 3 * a_m - 2 + z * ((1 - a_f) * n1 + a_f * beta),
               1 - 3 * a_m + z * ((1 - a_f) * n0 + a_f * n1), a_m + z * a_f * n0);
}

Roots generalized_alpha_roots(double rho, double x) {
  // The same parameters in terms of s = 1 - a_m + a_f.
  const double s = 2 / (rho + 1);
  return alpha_roots(2 - 1.5 * s, 1 - s / 2, s * s / 4, s - 0.5, x);
}

Roots hht_roots(double alpha, double x) { return alpha_roots(0, -alpha, std::pow((1 - alpha) / 2, 2), 0.5 - alpha, x); }

/// A scheme with parameters, as a scene writes them.
struct Case {
  std::string scheme;
  std::string parameters;
  std::function<Amplification(double)> amplification;  ///< of omega dt
  std::function<Roots(double)> roots;  ///< its eigenvalues in closed form, without those that are always zero
  double at_infinity;                  ///< the spectral radius where omega dt goes to infinity
  double critical = unbounded;         ///< stable for omega dt up to this
};

Case newmark(double beta, double gamma, double at_infinity, double critical = unbounded) {
  return {"Newmark",
          test::number("Beta", beta) + test::number("Gamma", gamma),
          [=](double x) { return test::newmark_amplification(beta, gamma, x); },
          [=](double x) { return newmark_roots(beta, gamma, x); },
          at_infinity,
          critical};
}

Case bathe(double rho, double split) {
  const double chosen = split != 0 ? split : test::equal_tangents_split(rho);
  return {"Bathe Composite", test::number("Spectral Radius", rho) + test::number("Split", split),
          [=](double x) { return test::bathe_amplification(rho, chosen, x); },
          [=](double x) { return bathe_roots(rho, chosen, x); }, rho};
}

Case composite(double beta, double gamma, double at_infinity, double critical = unbounded) {
  return {"Gautam-Sauer Composite",
          test::number("Beta", beta) + test::number("Gamma", gamma),
          [=](double x) { return test::composite_amplification(beta, gamma, x); },
          [=](double x) { return composite_roots(gamma / beta, x); },
          at_infinity,
          critical};
}

Case trapezoid(const std::string& scheme, const std::string& parameters = "") {
  return {scheme, parameters, test::trapezoid_amplification, trapezoid_roots, 1};
}

Case generalized_alpha(double rho) {
  return {"Generalized-Alpha", test::number("Spectral Radius", rho),
          [=](double x) { return test::generalized_alpha_amplification(rho, x); },
          [=](double x) { return generalized_alpha_roots(rho, x); }, rho};
}

Case hht(double alpha) {
  // At infinity F N = 0, N with the double root -(1 + alpha)/(1 - alpha), the larger one.
  return {"HHT-Alpha", test::number("Alpha", alpha), [=](double x) { return test::hht_amplification(alpha, x); },
          [=](double x) { return hht_roots(alpha, x); }, (1 + alpha) / (1 - alpha)};
}

Case central_difference() {
  return {"Central Difference",
          "",
          test::central_difference_amplification,
          [](double x) { return newmark_roots(0, 0.5, x); },
          unbounded,
          2};
}

/// Those of the library's defaults come without parameters.
Case with_defaults(Case one) {
  one.parameters.clear();
  return one;
}

const std::vector<Case>& cases() {
  // Newmark at infinity: the larger root of N above; stable up to 1/sqrt(gamma/2 - beta) (Hughes 1987). The composite,
  // r = gamma/beta: of x^2 + 2 (r - 1) x + 1; up to sqrt(4 r/(r - 2)).
  static const std::vector<Case> all{with_defaults(newmark(0.25, 0.5, 1)),
                                     newmark(0.3025, 0.6, 0.9 / 1.1),
                                     newmark(0.4, 0.8, 1),
                                     newmark(1.0 / 6, 0.5, 2 + std::sqrt(3.0), std::sqrt(12.0)),
                                     with_defaults(bathe(0, 0.5)),
                                     bathe(0.5, 0),
                                     bathe(0.8, 0.4),
                                     bathe(0.3, 0.7),
                                     bathe(1, 0.5),
                                     with_defaults(composite(0.25, 0.5, 1)),
                                     composite(0.3, 0.6, 1),
                                     composite(0.5, 0.75, 1),
                                     composite(0.25, 0.75, 2 + std::sqrt(3.0), std::sqrt(12.0)),
                                     trapezoid("Average Vector Field"),
                                     trapezoid("Average Vector Field", test::count("Elastic Points", 1)),
                                     trapezoid("Energy-Momentum"),
                                     with_defaults(generalized_alpha(0.5)),
                                     generalized_alpha(0),
                                     generalized_alpha(0.8),
                                     generalized_alpha(1),
                                     with_defaults(hht(-0.05)),
                                     hht(0),
                                     hht(-0.15),
                                     hht(-1.0 / 3),
                                     trapezoid("Midpoint"),
                                     central_difference()};
  return all;
}

/// The scheme and the values of its parameters.
std::string name(const Case& one) {
  const std::string before = "value=\"";
  std::string result = one.scheme;
  for (std::size_t at = one.parameters.find(before); at != std::string::npos; at = one.parameters.find(before, at)) {
    at += before.size();
    result += " " + one.parameters.substr(at, one.parameters.find('"', at) - at);
  }
  return result;
}

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
