// Kelvin-Voigt viscosity in motion: a closed form, what schemes conserve, and a life with rejected steps.
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/comparison.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::list;
using test::number;
using test::numbers;
using test::word;
using test::world;

std::string with_viscosity(std::string body, double viscosity) {
  return body.insert(body.find(number("Density", 1)), number("Viscosity", viscosity));
}

/// A linear body clamped below on rollers, one cell: E U''/3 ... an oscillator of circular frequency w = sqrt(3), whose
/// viscosity alpha damps it by zeta = alpha w/2 at small strains: U = U'(0) exp(-zeta w t) sin(w' t)/w'.
TEST(ViscosityTest, ASmallVibrationDecaysAsItsClosedFormSays) {
  const double alpha = 0.05, w = test::oscillator_frequency(), zeta = alpha * w / 2, speed = 1e-4, dt = 0.005, end = 5;
  const double damped = w * std::sqrt(1 - zeta * zeta);
  for (const std::string& scheme : test::moving_schemes()) {
    std::string body = with_viscosity(test::oscillator(), alpha);
    const std::string gradient = numbers("Velocity Gradient", {0, 0, 0, 1});
    body.replace(body.find(gradient), gradient.size(), numbers("Velocity Gradient", {0, 0, 0, speed}));
    const bool lumped = scheme == "Central Difference";  // half the mass at the top: w^2 = 2
    const double w1 = lumped ? std::sqrt(2.0) : w, z1 = alpha * w1 / 2, d1 = w1 * std::sqrt(1 - z1 * z1);
    Simulation s(test::scene(body + test::time_integrator(scheme, dt, end)), world());
    double worst = 0;
    for (int step = 1; step <= std::lround(end / dt); ++step) {
      ASSERT_TRUE(s.integrator().step(dt).converged) << scheme;
      const double t = step * dt;
      const double expected = speed * std::exp(-(lumped ? z1 * w1 : zeta * w) * t) *
                              std::sin((lumped ? d1 : damped) * t) / (lumped ? d1 : damped);
      const std::vector<double> u = test::gathered(s.model(), s.integrator().state().u);
      worst = std::max(worst, std::abs(u.back() - expected));
    }
    EXPECT_LT(worst, 3e-4 * speed) << scheme;  // strains of 1e-4, and dt^2
    EXPECT_GT(s.integrator().dissipated_energy(), 0.3 * speed * speed / 6) << scheme;
  }
}

TEST(ViscosityTest, WhatIsDissipatedClosesTheBalance) {
  for (const char* scheme : {"Average Vector Field", "Energy-Momentum"}) {
    Simulation s(test::scene(with_viscosity(test::block_2d(1.5), 0.05) + test::time_integrator(scheme, 0.05, 5)),
                 world());
    const double before = test::total_energy(s);
    for (int step = 0; step < 100; ++step) ASSERT_TRUE(s.integrator().step(0.05).converged) << scheme;
    const double dissipated = s.integrator().dissipated_energy();
    EXPECT_NEAR(test::total_energy(s) + dissipated, before, 1e-9 * before) << scheme;
    EXPECT_GT(dissipated, 1e-3 * before);
    ASSERT_EQ(s.integrator().dissipations().size(), 1U);
    EXPECT_EQ(s.integrator().dissipations()[0], dissipated);
    EXPECT_EQ(s.model().dissipation_names()[0], "viscosity of body");
  }
}

/// The largest error of the balance of a scheme whose forces act at the ends falls with the square of the step.
TEST(ViscosityTest, TheBalanceOfCollocationSchemesClosesWithTheirOrder) {
  // Generalized-alpha and HHT sum the work of their weighted forces, to first order.
  for (const char* scheme : {"Newmark", "Bathe Composite", "Central Difference"}) {
    double errors[2] = {};
    for (int halving = 0; halving < 2; ++halving) {
      const double dt = 0.02 / (1 << halving);
      Simulation s(test::scene(with_viscosity(test::block_2d(1.0), 0.02) + test::time_integrator(scheme, dt, 1)),
                   world());
      const double before = test::total_energy(s);
      for (int step = 0; step < std::lround(1 / dt); ++step) {
        ASSERT_TRUE(s.integrator().step(dt).converged) << scheme;
        const double error = test::total_energy(s) + s.integrator().dissipated_energy() - before;
        errors[halving] = std::max(errors[halving], std::abs(error));
      }
      EXPECT_GT(s.integrator().dissipated_energy(), 1e-3 * before) << scheme;
      EXPECT_LT(errors[halving], 0.05 * s.integrator().dissipated_energy()) << scheme;
    }
    EXPECT_GT(errors[0], 2.5 * errors[1]) << scheme;
  }
}

TEST(ViscosityTest, AnEnrichedBallLosesEnergyInAnImpact) {
  for (const char* scheme : {"Newmark", "Average Vector Field", "Energy-Momentum"})
    for (const double viscosity : {0.001, 0.02}) {
      Simulation s(test::scene_file("ball.xml", {std::string("Time Integrator/Type=") + scheme,
                                                 "Interactions/Wall/Contact Element=Q1C4",
                                                 "Materials/Ball/Viscosity=" + std::to_string(viscosity)}),
                   world());
      const double before = test::total_energy(s);
      for (int step = 0; step < 400; ++step) ASSERT_TRUE(s.integrator().step(1e-3).converged) << scheme << step;
      const double error = test::total_energy(s) + s.integrator().dissipated_energy() - before;
      EXPECT_GT(s.integrator().dissipated_energy(), 1e-3) << scheme;
      EXPECT_NEAR(error, 0, std::string(scheme) == "Newmark" ? 0.1 : 1e-9) << scheme;
    }
}

TEST(ViscosityTest, WhereItIsNotOfferedItIsRefused) {
  const std::string body = with_viscosity(test::block_2d(1.0), 0.05);
  const auto message = [](const std::string& scene) -> std::string {
    try {
      Simulation(test::scene(scene), world());
    } catch (const InputError& error) {
      return error.what();
    }
    return "not refused";
  };
  std::string enhanced = body;
  enhanced.insert(enhanced.find(number("Density", 1)), word("Element Formulation", "Enhanced"));
  EXPECT_EQ(
      message(enhanced + test::time_integrator("Newmark", 0.1, 1)),
      "Materials/Rubber/Viscosity: 0.05 is not there for elements other than \"Standard\": their viscous stress would "
      "lock; use 0, Stiffness Damping, or the Element Formulation \"Standard\"");
  EXPECT_EQ(
      message(body + list("Linear Solver", word("Operator", "Matrix-Free")) + test::time_integrator("Newmark", 0.1, 1)),
      "Linear Solver/Operator: \"Matrix-Free\" is not offered for Materials/Rubber/Viscosity; use \"Assembled\"");
}

TEST(ViscosityTest, EachSourceIsBookedUnderItsName) {
  std::string body = with_viscosity(test::block_2d(1.5), 0.05);
  body.insert(body.find(number("Density", 1)), number("Mass Damping", 0.1));
  Simulation s(test::scene(body + test::time_integrator("Average Vector Field", 0.05, 1)), world());
  const double before = test::total_energy(s);
  for (int step = 0; step < 20; ++step) ASSERT_TRUE(s.integrator().step(0.05).converged);
  const std::vector<double>& by_name = s.integrator().dissipations();
  ASSERT_EQ(s.model().dissipation_names(), (std::vector<std::string>{"viscosity of body", "damping"}));
  EXPECT_GT(by_name[0], 1e-3);
  EXPECT_GT(by_name[1], 1e-3);
  EXPECT_NEAR(test::total_energy(s) + by_name[0] + by_name[1], before, 1e-9 * before);
}

/// Returns the angular momentum after `steps` steps over that at first.
double spin_kept(const std::string& scheme, const std::string& damping) {
  std::string body = test::block_2d(1.5);
  body.insert(body.find(number("Density", 1)), damping);
  Simulation s(test::scene(body + test::time_integrator(scheme, 0.05, 5)), world());
  const auto spin = [&] { return test::report_of(s).momenta().angular[0]; };
  const double before = spin();
  for (int step = 0; step < 100; ++step) EXPECT_TRUE(s.integrator().step(0.05).converged) << scheme;
  return spin() / before;
}

TEST(ViscosityTest, AngularMomentumStaysWhereTheSchemeKeepsIt) {
  EXPECT_NEAR(spin_kept("Midpoint", number("Viscosity", 0.05)), 1, 1e-10);
  EXPECT_NEAR(spin_kept("Energy-Momentum", number("Viscosity", 0.05)), 1, 1e-10);
  EXPECT_NEAR(spin_kept("Central Difference", number("Viscosity", 0.01)), 1, 1e-10);
  for (const char* scheme : {"Newmark", "Average Vector Field", "Generalized-Alpha"})
    EXPECT_NEAR(spin_kept(scheme, number("Viscosity", 0.05)), 1, 0.02) << scheme;
  EXPECT_LT(spin_kept("Midpoint", number("Stiffness Damping", 0.05)), 0.9) << "it damps the rotation too";
}

TEST(ViscosityTest, ARejectedStepLeavesNoTrace) {
  for (const std::string& scheme : test::moving_schemes()) {
    const auto scene = test::scene(with_viscosity(test::block_2d(1.0), 0.05) + test::time_integrator(scheme, 0.05, 5));
    Simulation straight(scene, world()), with_rejections(scene, world());
    for (int step = 0; step < 5; ++step) {
      ASSERT_TRUE(straight.integrator().step(0.02).converged);
      with_rejections.integrator().attempt(0.05);  // judged too long: the next attempt begins at the accepted state
      ASSERT_TRUE(with_rejections.integrator().step(0.02).converged);
    }
    const auto dissipated = [](const Simulation& s) { return test::report_of(s).cell_fields()[0].dissipated; };
    const double largest = test::distance(straight.integrator().state().u, with_rejections.integrator().state().u);
    EXPECT_LT(straight.model().space().maximum(largest), 1e-9) << scheme;
    EXPECT_NEAR(straight.integrator().dissipated_energy(), with_rejections.integrator().dissipated_energy(), 1e-10)
        << scheme;
    EXPECT_LT(straight.model().space().maximum(test::distance(dissipated(straight), dissipated(with_rejections))),
              1e-10);
  }
}

TEST(ViscosityTest, CreepUnderALoadIsExponential) {
  // One cell on rollers under a traction s, without inertia: E e + alpha E e' = s, e = s/E (1 - exp(-t/alpha)).
  const double alpha = 0.5, load = 1e-5, dt = 0.005;
  std::string body = with_viscosity(test::oscillator(), alpha);
  const std::string conditions = "<ParameterList name=\"Boundary Conditions\">";
  body.insert(body.find(conditions) + conditions.size(),
              list("Pull", word("Type", "Traction") + word("Side Set", "top") + numbers("Vector", {0, load})));
  const std::string motion = list("Initial Conditions", numbers("Velocity Gradient", {0, 0, 0, 1}));
  body.replace(body.find(motion), motion.size(), "");
  Simulation s(test::scene(body + test::time_integrator("Static", dt, 2)), world());
  for (int step = 1; step <= 200; ++step) {
    ASSERT_TRUE(s.integrator().step(dt).converged);
    const std::vector<double> u = test::gathered(s.model(), s.integrator().state().u);
    EXPECT_NEAR(u.back(), load * (1 - std::pow(1 + dt / alpha, -step)), 1e-4 * load) << "backward Euler's closed form";
  }
}

/// One cell with nu = 0, without inertia: the stress in the field is that of the force, P = E U + (1 + U) alpha E e/dt
/// with the change e of Green's strain. A load holds it, or a motion drives it.
TEST(ViscosityTest, StaticFieldsHaveTheRateOfTheForce) {
  const double alpha = 0.5, load = 0.2, dt = 0.5;
  for (const bool driven : {false, true}) {
    SCOPED_TRACE(driven);
    std::string body = with_viscosity(test::oscillator(), alpha);
    const std::string conditions = "<ParameterList name=\"Boundary Conditions\">";
    const std::string top = driven ? word("Node Set", "top") + word("Components", "y") + word("History", "Way")
                                   : word("Type", "Traction") + word("Side Set", "top") + numbers("Vector", {0, load});
    body.insert(body.find(conditions) + conditions.size(), list("Top", top));
    if (driven) body += list("Histories", test::expression("Way", "0.2*t^2", "0.4*t", "0.4"));
    const std::string motion = list("Initial Conditions", numbers("Velocity Gradient", {0, 0, 0, 1}));
    body.replace(body.find(motion), motion.size(), "");
    Simulation s(test::scene(body + test::time_integrator("Static", dt, 2)), world());
    double before = 0;
    for (int step = 1; step <= 3; ++step) {
      ASSERT_TRUE(s.integrator().step(dt).converged);
      const State& state = s.integrator().state();
      const double now = test::gathered(s.model(), state.u).back();
      const double viscous = (1 + now) * alpha * ((now - before) + (now * now - before * before) / 2) / dt;
      before = now;
      const auto stress = StateReport(s.model(), state).cell_stress()[0];
      const auto all = StateReport(s.model(), state).cell_fields()[0].stress_invariant,
                 elastic = test::ReportAt(s.model(), state.u.data()).cell_fields()[0].stress_invariant;
      for (std::size_t cell = 0; cell < stress.size(); ++cell) {
        EXPECT_NEAR(stress[cell][1], now + viscous, 1e-12);
        EXPECT_NEAR(all[cell] - elastic[cell], viscous, 1e-12);
        if (!driven) {
          EXPECT_NEAR(stress[cell][1], load, 1e-8);
        }
      }
      EXPECT_GT(std::abs(viscous), 1e-3);
    }
  }
}

}  // namespace
}  // namespace ixos
