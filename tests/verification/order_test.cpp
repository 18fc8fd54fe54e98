// Order of convergence on a smooth nonlinear problem: a spinning, stretching block of rubber, with and without damping.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/comparison.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::time_integrator;
using test::world;

struct Solution {
  std::vector<double> u, v;
};

Solution at_one(const std::string& body, const std::string& scheme, double dt, const std::string& parameters = "") {
  Simulation s(test::scene(body + time_integrator(scheme, dt, 1, parameters)), world());
  for (int step = 0; step < std::lround(1 / dt); ++step) EXPECT_TRUE(s.integrator().step(dt).converged) << scheme;
  return {test::gathered(s.model(), s.integrator().state().u), test::gathered(s.model(), s.integrator().state().v)};
}

std::string damped_block() {
  std::string body = test::block_2d(1.0);
  body.insert(body.find(test::number("Density", 1)),
              test::number("Mass Damping", 0.1) + test::number("Stiffness Damping", 0.02));
  return body;
}

std::string viscous_block() {
  std::string body = test::block_2d(1.0);
  return body.insert(body.find(test::number("Density", 1)), test::number("Viscosity", 0.02));
}

/// Returns the state at time 1 by another scheme with short steps, so that a common limit is tested too. Computes it
/// once for each body and scheme.
const Solution& reference_of(const std::string& body, const std::string& scheme) {
  static std::map<std::string, Solution> known;
  // With a lumped mass it is another body.
  const bool lumped = scheme == "Central Difference";
  const std::string other = lumped ? scheme : scheme == "Newmark" ? "Bathe Composite" : "Newmark";
  const auto found = known.find(body + other);
  if (found != known.end()) return found->second;
  return known[body + other] = at_one(body, other, lumped ? 1.0 / 2560 : 1.0 / 1280);
}

void expect_order(const std::string& body, const std::string& scheme, const std::string& parameters, int order,
                  double steps = 20) {
  const Solution& reference = reference_of(body, scheme);
  const Solution coarse = at_one(body, scheme, 1 / steps, parameters);
  const Solution fine = at_one(body, scheme, 1 / (2 * steps), parameters);
  const double ratio = std::pow(2.0, order);
  EXPECT_NEAR(test::distance(coarse.u, reference.u) / test::distance(fine.u, reference.u), ratio, 0.15 * ratio)
      << scheme << " displacement";
  EXPECT_NEAR(test::distance(coarse.v, reference.v) / test::distance(fine.v, reference.v), ratio, 0.15 * ratio)
      << scheme << " velocity";
}

TEST(OrderTest, SchemesAreOfSecondOrder) {
  for (const std::string& body : {test::block_2d(1.0), damped_block(), viscous_block()}) {
    expect_order(body, "Newmark", "", 2);
    expect_order(body, "Bathe Composite", "", 2);
    expect_order(body, "Bathe Composite", test::number("Spectral Radius", 0.5) + test::number("Split", 0), 2);
    expect_order(body, "Gautam-Sauer Composite", "", 2);
    expect_order(body, "Average Vector Field", "", 2);
    expect_order(body, "Generalized-Alpha", "", 2);
    expect_order(body, "HHT-Alpha", test::number("Alpha", -0.2), 2);
    expect_order(body, "Midpoint", "", 2);
    expect_order(body, "Energy-Momentum", "", 2);
    expect_order(body, "Central Difference", "", 2);
  }
}

/// A damped block on a shaking table, in a wind that grows and turns.
std::string shaken_block() {
  return damped_block() +
         test::list("Histories", test::expression("Shake", "0.2*sin(3*t)", "0.6*cos(3*t)", "-1.8*sin(3*t)") +
                                     test::expression("Gust", "0.3*t*cos(4*t)")) +
         test::list("Boundary Conditions",
                    test::list("Table", test::word("Node Set", "bottom") + test::word("History", "Shake")) +
                        test::list("Wind", test::word("Type", "Traction") + test::word("Side Set", "left") +
                                               test::numbers("Vector", {1, 0.5}) + test::word("History", "Gust")));
}

TEST(OrderTest, DrivenAndLoadedToo) {
  for (const char* scheme : {"Newmark", "Bathe Composite", "Gautam-Sauer Composite", "Average Vector Field",
                             "Generalized-Alpha", "HHT-Alpha", "Midpoint", "Energy-Momentum", "Central Difference"})
    expect_order(shaken_block(), scheme, "", 2, 80);
}

TEST(OrderTest, NewmarkWithNumericalDampingIsOfFirstOrder) {
  expect_order(test::block_2d(1.0), "Newmark", test::number("Beta", 0.4225) + test::number("Gamma", 0.8), 1);
}

}  // namespace
}  // namespace ixos
