// Bending vibrations of slender solids against Timoshenko's beam.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "mesh/generators/shapes.hpp"
#include "support/solids.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

using test::at_rest;
using test::model_of;

enum class Ends { Cantilever, Free };

/// det(omega) of Timoshenko's beam (length L, 1 x 1, E = rho = 1, nu = 0, so G = 1/2): w' = phi + V/(kappa G A),
/// phi' = M/(E I), M' = -V - rho I omega^2 phi, V' = -rho A omega^2 w, from one end to the other by Runge and Kutta's
/// method. kappa = 1, as the shear of one layer of elements is uniform through the thickness.
double timoshenko_determinant(Ends ends, double length, double omega) {
  using State = std::array<double, 4>;  // w, phi, M, V
  const double inertia = 1.0 / 12, shear = 0.5;
  const auto slope = [&](const State& y) {
    return State{y[1] + y[3] / shear, y[2] / inertia, -y[3] - inertia * omega * omega * y[1], -omega * omega * y[0]};
  };
  const auto sum = [](const State& y, double h, const State& k) {
    State z = y;
    for (std::size_t i = 0; i < 4; ++i) z[i] += h * k[i];
    return z;
  };
  const auto at_end = [&](State y) {
    const int n = 400;
    const double h = length / n;
    for (int i = 0; i < n; ++i) {
      const State a = slope(y), b = slope(sum(y, h / 2, a)), c = slope(sum(y, h / 2, b)), d = slope(sum(y, h, c));
      y = sum(sum(sum(sum(y, h / 6, a), h / 3, b), h / 3, c), h / 6, d);
    }
    return y;
  };
  const bool clamped = ends == Ends::Cantilever;
  const State p = at_end(clamped ? State{0, 0, 1, 0} : State{1, 0, 0, 0});
  const State q = at_end(clamped ? State{0, 0, 0, 1} : State{0, 1, 0, 0});
  return p[2] * q[3] - p[3] * q[2];
}

/// Euler and Bernoulli's lowest: k^2 sqrt(E I/(rho A))/L^2.
double bernoulli_frequency(Ends ends, double length) {
  const double k = ends == Ends::Cantilever ? 1.875104069 : 4.730040745;
  return k * k / std::sqrt(12.0) / (length * length);
}

double timoshenko_frequency(Ends ends, double length) {
  double high = bernoulli_frequency(ends, length), low = 0.8 * high;
  const bool rises = timoshenko_determinant(ends, length, high) > 0;
  EXPECT_NE(timoshenko_determinant(ends, length, low) > 0, rises);
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    ((timoshenko_determinant(ends, length, middle) > 0) == rises ? high : low) = middle;
  }
  return low;
}

/// Bernoulli's mode at x/L = s.
double bending_mode(Ends ends, double s) {
  if (ends == Ends::Cantilever) {
    const double k = 1.875104069, ratio = 0.734095514;
    return std::cosh(k * s) - std::cos(k * s) - ratio * (std::sinh(k * s) - std::sin(k * s));
  }
  const double k = 4.730040745, ratio = 0.982502215;
  return std::cosh(k * s) + std::cos(k * s) - ratio * (std::sinh(k * s) + std::sin(k * s));
}

/// Of the box, length x 1 x 1, from its motion by the trapezoid: of every mode q_n+1 + q_n-1 = 2 cos(theta) q_n with
/// tan(theta/2) = omega dt/2, so the period error is none. q is the momentum's moment with the mode, to which the other
/// modes that the start excites contribute little.
double measured_frequency(Ends ends, double length, const std::array<int, 3>& divisions, Formulation formulation) {
  BoxShape shape;
  shape.dimension = 3;
  shape.lengths = {length, 1, 1};
  shape.divisions = divisions;
  Material material = test::elastic(linear_elastic, 0);  // nu = 0: no lateral contraction for the clamp to hold
  material.formulation = formulation;
  const auto model = model_of(box(shape), material, Inertia::Consistent);
  const LocalMesh& mesh = model->mesh();
  if (ends == Ends::Cantilever)
    for (int node : mesh.node_sets[mesh.node_set("left")])
      for (int i = 0; i < 3; ++i) model->constraints().add(3 * node + i, 0.0, nullptr);
  std::vector<double> mode = at_rest(*model), weighted(mode.size(), 0.0);
  const double step = 1e-4;  // sections stay plane and turn with the axis
  for (std::size_t n = 0; n < mode.size(); n += 3) {
    const double s = mesh.coordinates[n] / length;
    const double slope = (bending_mode(ends, s + step) - bending_mode(ends, s - step)) / (2 * step * length);
    mode[n] = -(mesh.coordinates[n + 2] - 0.5) * slope;
    mode[n + 2] = bending_mode(ends, s);
  }
  model->mass()->multiply(mode.data(), weighted.data());
  Integrator integrator = test::direct(*model, newmark(0.25, 0.5), 1e-11);
  integrator.initialize(at_rest(*model), mode, 0.0);
  const double dt = 2 * M_PI / bernoulli_frequency(ends, length) / 40;
  std::vector<double> q{0};
  for (int n = 0; n < 24; ++n) {
    const StepResult result = integrator.step(dt);
    EXPECT_TRUE(result.converged) << result.reason;
    double sum = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(model->space().owned()); ++i)
      sum += weighted[i] * integrator.state().u[i];
    model->space().sum(&sum, 1);
    q.push_back(sum);
  }
  double numerator = 0, denominator = 0;
  for (std::size_t n = 1; n + 1 < q.size(); ++n) {
    numerator += q[n] * (q[n + 1] + q[n - 1]);
    denominator += q[n] * q[n];
  }
  return 2 * std::tan(std::acos(numerator / denominator / 2) / 2) / dt;
}

TEST(BeamFrequencyTest, LowestBendingFrequenciesAreThoseOfTimoshenkosBeam) {
  const double length = 16;
  for (Ends ends : {Ends::Cantilever, Ends::Free}) {
    const double exact = timoshenko_frequency(ends, length);
    EXPECT_NEAR(exact / bernoulli_frequency(ends, length), 1, 0.015);
    std::vector<double> errors;
    for (int n : {8, 16, 32})
      errors.push_back(measured_frequency(ends, length, {n, 1, 1}, Formulation::Enhanced) / exact - 1);
    EXPECT_NEAR(errors[1] / errors[0], 0.25, 0.02);
    EXPECT_NEAR(errors[2] / errors[1], 0.25, 0.01);
    EXPECT_NEAR(errors[2], 0, 2e-3);
    // Parasitic shear of standard elements of length l: the bending stiffness grows by the factor 1 + G/E l^2/1^2.
    for (int n : {32, 64}) {
      const double l = length / n, ratio = measured_frequency(ends, length, {n, 1, 1}, Formulation::Standard) / exact;
      EXPECT_NEAR(ratio, std::sqrt(1 + l * l / 2), 2e-3) << n;
    }
  }
}

}  // namespace
}  // namespace ixos
