// Period error and amplitude decay of the linear oscillator, against the values of the literature.
#include <gtest/gtest.h>

#include <cmath>

#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/comparison.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::world;

struct Response {
  double period_error;  ///< [%]
  double decay;         ///< of the amplitude in a period [%]
};

/// Runs the oscillator and reads its two principal eigenvalues from u_n+1 = p u_n - q u_n-1.
Response response(const std::string& scheme, const std::string& parameters, double dt_over_period) {
  const double period = 2 * M_PI / test::oscillator_frequency();
  const double dt = dt_over_period * period;
  Simulation s(test::scene(test::oscillator() + test::time_integrator(scheme, dt, 1, parameters)), world());
  std::vector<double> u;
  for (int step = 0; step < 40; ++step) {
    EXPECT_TRUE(s.integrator().step(dt).converged);
    if (step >= 30) u.push_back(test::gathered(s.model(), s.integrator().state().u).back());
  }
  const double determinant = u[1] * u[1] - u[0] * u[2];
  const double p = (u[1] * u[2] - u[0] * u[3]) / determinant;
  const double q = (u[2] * u[2] - u[1] * u[3]) / determinant;
  const double angle = std::acos(p / (2 * std::sqrt(q)));
  return {100 * (2 * M_PI / angle * dt_over_period - 1), 100 * (1 - std::pow(q, M_PI / angle))};
}

TEST(OscillatorTest, PeriodErrorAndDecayAtATenthOfThePeriod) {
  const std::string rho = test::number("Spectral Radius", 0.5) + test::number("Split", 0);
  const struct {
    const char* scheme;
    std::string parameters;
    double period_error, decay;
  } expected[] = {{"Newmark", "", 3.207, 0},
                  {"Gautam-Sauer Composite", "", 3.207, 0},
                  {"Average Vector Field", "", 3.207, 0},
                  {"Bathe Composite", "", 1.618, 0.513},
                  {"Bathe Composite", rho, 1.149, 0.288},
                  {"Generalized-Alpha", "", 4.672, 2.347},
                  {"Generalized-Alpha", test::number("Spectral Radius", 1), 3.207, 0},
                  {"HHT-Alpha", "", 3.611, 0.741},
                  {"HHT-Alpha", test::number("Alpha", 0), 3.207, 0},
                  {"Midpoint", "", 3.207, 0}};
  for (const auto& e : expected) {
    const Response r = response(e.scheme, e.parameters, 0.1);
    EXPECT_NEAR(r.period_error, e.period_error, 6e-4) << e.scheme;
    EXPECT_NEAR(r.decay, e.decay, 6e-4) << e.scheme;
  }
}

TEST(OscillatorTest, TrapezoidHasTheClosedFormPeriod) {
  // tan(omega_h dt/2) = omega dt/2.
  for (double ratio : {0.02, 0.05, 0.2, 0.4}) {
    const double half = M_PI * ratio;
    EXPECT_NEAR(response("Newmark", "", ratio).period_error, 100 * (half / std::atan(half) - 1), 1e-6);
  }
}

TEST(OscillatorTest, NewmarkWithNumericalDampingDecaysAsItsEigenvaluesSay) {
  // From the two-step form u_n+1 = p u_n - q u_n-1 (Zienkiewicz 1977): p = 2 - (gamma + 1/2) z/(1 + beta z), q = 1 -
  // (gamma - 1/2) z/(1 + beta z), z = (omega dt)^2.
  const double beta = 0.4225, gamma = 0.8, ratio = 0.1;
  const double z = std::pow(2 * M_PI * ratio, 2);
  const double q = 1 - (gamma - 0.5) * z / (1 + beta * z);
  const double p = 2 - (gamma + 0.5) * z / (1 + beta * z);
  const double angle = std::acos(p / (2 * std::sqrt(q)));
  const Response r = response("Newmark", test::number("Beta", beta) + test::number("Gamma", gamma), ratio);
  EXPECT_NEAR(r.period_error, 100 * (2 * M_PI * ratio / angle - 1), 1e-6);
  EXPECT_NEAR(r.decay, 100 * (1 - std::pow(q, M_PI / angle)), 1e-6);
}

}  // namespace
}  // namespace ixos
