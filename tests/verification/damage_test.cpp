// Bonds that do not heal, between bodies and rigid obstacles, in every scheme.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/snapshot.hpp"
#include "interaction/damage_law.hpp"
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

constexpr double stiffness = 0.5, strength = 0.05, range = 0.8, work = strength * range / 2;
const DamageLaw law(stiffness, strength, range);

const std::string on_touch = R"(<Parameter name="Bond on Touch" type="bool" value="true"/>)";

std::string bond(const std::string& more, const std::string& kind = "") {
  return list("Interactions",
              list("Bond", word("Side Set", "bottom") + word("Law", "Bilinear Damage") +
                               list("Bilinear Damage", number("Work of Adhesion", work) + number("Strength", strength) +
                                                           number("Stiffness", stiffness) + kind) +
                               more));
}

std::string block(const std::vector<int>& divisions) {
  std::vector<double> lengths(divisions.size(), 1.0);
  lengths.front() = 2;
  return list("Mesh", word("Type", "Box") +
                          list("Box", test::count("Dimension", static_cast<int>(divisions.size())) +
                                          numbers("Lengths", lengths) + test::counts("Divisions", divisions))) +
         list("Materials", list("Rubber", number("Poisson's Ratio", 0.3) + number("Density", 1)));
}

/// A block of 2 by 1 that is moved up and down as a whole: by 0.05 t (1 - cos t).
std::string driven_block() {
  const std::string lift = word("Components", "y") + word("History", "Up");
  return block({2, 1}) + bond("") +
         list("Histories",
              test::expression("Up", "0.05*t*(1-cos(t))", "0.05*(1-cos(t)+t*sin(t))", "0.05*(2*sin(t)+t*cos(t))")) +
         list("Boundary Conditions", list("Bottom", word("Node Set", "bottom") + lift) +
                                         list("Top", word("Node Set", "top") + lift) +
                                         list("Guide", word("Node Set", "left") + word("Components", "x")));
}
double height(double t) { return 0.05 * t * (1 - std::cos(t)); }

/// Expects the damage on the bottom, y = 0, and none elsewhere.
void expect_damage(const Simulation& s, double damage, const std::string& where) {
  const std::vector<double> values = test::report_of(s).interaction("Bond").mean(SurfaceNumber::Damage);
  const LocalMesh& mesh = s.model().mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.owned_nodes); ++node) {
    const bool bonded = mesh.coordinates[node * d + d - 1] == 0 && !mesh.is_derivative(node);
    ASSERT_NEAR(values[node], bonded ? damage : 0, 1e-13) << where;
  }
}

double contact_energy(const Simulation& s) { return test::report_of(s).energy(Part::Interaction); }
double traction(const Simulation& s) { return test::report_of(s).interaction_report().force.back() / 2; }

// Pulled to 0.33, brought back, pulled to 0.95 beyond the range, and brought back.
TEST(DamageTest, ARigidBlockUnloadsAlongTheSecantInEveryScheme) {
  std::vector<std::string> schemes = test::moving_schemes();
  schemes.emplace_back("Static");
  for (const std::string& scheme : schemes) {
    SCOPED_TRACE(scheme);
    Simulation s(test::scene(driven_block() + test::time_integrator(scheme, 0.1, 12.5)), test::world());
    Pack kappa = law.first(0.0);
    double largest = 0;
    for (int n = 1; n <= 125; ++n) {
      const StepResult result = s.integrator().step(0.1);
      ASSERT_TRUE(result.converged) << n << ": " << result.reason;
      const double gap = height(s.integrator().time());
      kappa = law.updated(kappa, gap);
      largest = std::max(largest, gap);
      ASSERT_NEAR(traction(s), law.at(kappa).traction(gap)[0], 1e-14) << n;
      ASSERT_NEAR(contact_energy(s), 2 * law.at(kappa).energy(gap)[0], 1e-14) << n;
      ASSERT_NEAR(s.integrator().dissipated_energy(), 2 * law.dissipated(law.adhesion_gap(), kappa)[0], 1e-14) << n;
      // From d0 = s0/K on, df (kappa - d0)/(kappa (df - d0)).
      const double start = strength / stiffness, most = std::min(std::max(largest, start), range);
      expect_damage(s, range * (most - start) / (most * (range - start)), scheme + ", step " + std::to_string(n));
    }
    EXPECT_GT(largest, range);
    EXPECT_NEAR(s.integrator().dissipated_energy(), 2 * work, 1e-14);
    EXPECT_EQ(s.model().dissipation_names(), (std::vector<std::string>{"damage of Bond"}));
  }
}

std::string flying(const std::vector<double>& velocity) {
  return list("Initial Conditions", numbers("Velocity", velocity));
}

// A block tears itself off by its own motion, turns, and comes back to the wall with one edge.
TEST(DamageTest, TheBalanceOfABlockThatTearsOffCloses) {
  const std::string sphere =
      word("Obstacle", "Sphere") + list("Sphere", number("Radius", 3) + numbers("Center", {1, -3}));
  for (const std::string& obstacle : {std::string(), sphere})
    for (const char* scheme : {"Average Vector Field", "Energy-Momentum"}) {
      SCOPED_TRACE(scheme + obstacle);
      const bool mean = std::string(scheme) == "Average Vector Field";
      const std::string exact =
          mean ? test::count("Elastic Points", 6) + test::count("Interaction Points", 0) : std::string();
      Simulation s(test::scene(block({4, 2}) + bond(obstacle) +
                               list("Initial Conditions", numbers("Velocity", {0.05, 0.2}) +
                                                              numbers("Velocity Gradient", {0, -0.1, 0.1, 0})) +
                               test::time_integrator(scheme, 0.1, 20, exact)),
                   test::world());
      const double first = test::total_energy(s), before = s.integrator().dissipated_energy();
      EXPECT_EQ(before, 0);
      double lost = 0;
      for (int n = 1; n <= 120; ++n) {
        const StepResult result = s.integrator().step(0.1);
        ASSERT_TRUE(result.converged) << n << ": " << result.reason;
        EXPECT_GE(s.integrator().dissipated_energy(), lost);
        lost = s.integrator().dissipated_energy();
        ASSERT_NEAR(test::total_energy(s) + lost, first, 1e-9) << n;
      }
      EXPECT_GT(lost, 0.1 * work);
      EXPECT_LE(lost, 2 * work * (1 + 1e-12));
    }
}

// The same before a wall that leaves the block and comes back, and before one that also turns. The wall works with the
// bonds that the step begins with.
TEST(DamageTest, TheBalanceOfABlockAndAMovedWallCloses) {
  const std::string histories =
      list("Histories", test::expression("Shake", "-0.1*sin(t)", "-0.1*cos(t)", "0.1*sin(t)") +
                            test::expression("Tilt", "0.05*sin(2*t)", "0.1*cos(2*t)", "-0.2*sin(2*t)"));
  const std::string shift = test::texts("Translation", "{-, Shake}");
  for (const std::string& motion : {shift, shift + word("Rotation", "Tilt")})
    for (const char* scheme : {"Average Vector Field", "Energy-Momentum"}) {
      SCOPED_TRACE(scheme + motion);
      const bool mean = std::string(scheme) == "Average Vector Field";
      const std::string exact =
          mean ? test::count("Elastic Points", 6) + test::count("Interaction Points", 0) : std::string();
      Simulation s(test::scene(block({4, 2}) + bond(list("Motion", motion)) + histories + flying({0.05, 0.2}) +
                               test::time_integrator(scheme, 0.1, 20, exact)),
                   test::world());
      const double first = test::total_energy(s);
      double largest_work = 0;
      for (int n = 1; n <= 120; ++n) {
        const StepResult result = s.integrator().step(0.1);
        ASSERT_TRUE(result.converged) << n << ": " << result.reason;
        const double external = s.integrator().external_work();
        largest_work = std::max(largest_work, std::abs(external));
        ASSERT_NEAR(test::total_energy(s) + s.integrator().dissipated_energy() - external, first, 1e-9) << n;
      }
      EXPECT_GT(s.integrator().dissipated_energy(), 0.1 * work);
      EXPECT_GT(largest_work, 0.1 * work);
    }
}

// Each kind of contact side, in two and three dimensions, and before a wall that is moved instead of the block.
TEST(DamageTest, TheDamageOfAUniformSeparationIsUniform) {
  const double gap = 0.5, start = strength / stiffness, damage = range * (gap - start) / (gap * (range - start));
  const std::string away =
      list("Histories", list("Away", word("Type", "Ramp") + list("Ramp", number("Value", -gap) + number("Length", 1))));
  for (const char* element : {"Q1C1", "Q1C2", "Q1C3", "Q1C4", "Q1CH"})
    for (const int dimension : {2, 3}) {
      const bool plane = dimension == 2;
      const std::string wall = plane ? std::string() : numbers("Point", {0, 0, 0}) + numbers("Normal", {0, 0, 1});
      const std::string motion = list("Motion", test::texts("Translation", plane ? "{-, Away}" : "{-, -, Away}"));
      const std::string all = word("Components", plane ? "xy" : "xyz");
      Simulation s(test::scene(block(plane ? std::vector<int>{3, 1} : std::vector<int>{3, 2, 1}) +
                               bond(wall + motion + word("Contact Element", element)) + away +
                               list("Boundary Conditions", list("Bottom", word("Node Set", "bottom") + all) +
                                                               list("Top", word("Node Set", "top") + all)) +
                               test::time_integrator("Newmark", 0.25, 1)),
                   test::world());
      expect_damage(s, 0, element);
      for (int n = 0; n < 4; ++n) ASSERT_TRUE(s.integrator().step(0.25).converged);
      expect_damage(s, damage, element);
    }
}

// A step that nobody accepts, and steps that are taken back.
TEST(DamageTest, StepsThatAreTakenBackLeaveNoDamage) {
  for (const std::string& scheme : {std::string("Average Vector Field"), std::string("Bathe Composite")}) {
    Simulation s(test::scene(block({2, 1}) + bond("") + flying({0, 0.25}) + test::time_integrator(scheme, 0.1, 20)),
                 test::world());
    Integrator& integrator = s.integrator();
    for (int n = 0; n < 6; ++n) ASSERT_TRUE(integrator.step(0.1).converged);
    const double lost = integrator.dissipated_energy(), energy = contact_energy(s);
    ASSERT_GT(lost, 0);
    ASSERT_TRUE(integrator.attempt(0.5).converged);
    EXPECT_EQ(contact_energy(s), energy) << scheme;
    Snapshot snapshot([&](Record& record) { integrator.transfer(record); });
    snapshot.save();
    for (int n = 0; n < 6; ++n) ASSERT_TRUE(integrator.step(0.1).converged);
    EXPECT_GT(integrator.dissipated_energy(), lost);
    const std::vector<double> after = integrator.state().u;
    snapshot.restore();
    EXPECT_EQ(integrator.dissipated_energy(), lost) << scheme;
    EXPECT_EQ(contact_energy(s), energy) << scheme;
    for (int n = 0; n < 6; ++n) ASSERT_TRUE(integrator.step(0.1).converged);
    EXPECT_EQ(integrator.state().u, after) << scheme;
  }
}

TEST(DamageTest, ASurfaceThatStartsApartHasNoBond) {
  const std::string apart = numbers("Point", {0, -0.5}), far = numbers("Point", {0, -0.9});
  for (const std::string& place : {apart, far}) {
    const double gap = place == apart ? 0.5 : 0.9;
    Simulation s(test::scene(block({2, 1}) + bond(place) + test::time_integrator("Newmark", 0.1, 1)), test::world());
    const FrozenDamage own = law.at(gap);
    EXPECT_NEAR(contact_energy(s), 2 * own.energy(gap)[0], 1e-15);
    EXPECT_NEAR(traction(s), own.traction(gap)[0], 1e-15);
    EXPECT_EQ(s.integrator().dissipated_energy(), 0);
  }
}

// A block that is moved from a gap of 0.5 down to -0.02, then up to 1.15, as a whole.
TEST(DamageTest, ABondOnTouchFormsAtTheFirstContact) {
  const std::string lift = word("Components", "y") + word("History", "Path");
  const std::string path =
      list("Histories", test::expression("Path", "0.13*(t^2 - 4*t)", "0.13*(2*t - 4)", "0.26")) +
      list("Boundary Conditions", list("Bottom", word("Node Set", "bottom") + lift) +
                                      list("Top", word("Node Set", "top") + lift) +
                                      list("Guide", word("Node Set", "left") + word("Components", "x")));
  const double start = strength / stiffness;
  for (const char* scheme : {"Static", "Newmark", "Average Vector Field"})
    for (const bool bonds : {true, false}) {
      SCOPED_TRACE(std::string(scheme) + (bonds ? ", on touch" : ""));
      Simulation s(test::scene(block({2, 1}) + bond(numbers("Point", {0, -0.5}), bonds ? on_touch : "") + path +
                               (std::string(scheme) == "Static" ? "" : flying({0, -0.52})) +
                               test::time_integrator(scheme, 0.1, 5)),
                   test::world());
      bool touched = false;
      double lost = 0;
      for (int n = 1; n <= 50; ++n) {
        const StepResult result = s.integrator().step(0.1);
        ASSERT_TRUE(result.converged) << n << ": " << result.reason;
        const double t = s.integrator().time(), gap = 0.5 + 0.13 * (t * t - 4 * t);
        touched = touched || gap <= 0;
        if (!bonds) continue;
        const double fall = -strength * (range - gap) / (range - start);
        const double expected = gap <= 0 || (touched && gap <= start) ? -stiffness * gap
                                : touched && gap < range              ? fall
                                                                      : 0;
        ASSERT_NEAR(traction(s), expected, 1e-13) << n;
        if (touched && gap > start) lost = work * (std::min(gap, range) - start) / (range - start);
        ASSERT_NEAR(s.integrator().dissipated_energy(), 2 * lost, 1e-13) << n;
      }
      EXPECT_TRUE(touched);
      // The bond that half broke at the start loses the other half.
      const double rest = 0.5 * strength / (range - start) * range * (range - 0.5);
      EXPECT_NEAR(s.integrator().dissipated_energy(), 2 * (bonds ? work : rest), 1e-13);
    }
}

// A block falls on glue with one edge first, and the bond brakes its rebound.
TEST(DamageTest, TheBalanceOfABlockThatFallsOnGlueCloses) {
  for (const char* scheme : {"Average Vector Field", "Energy-Momentum"}) {
    SCOPED_TRACE(scheme);
    const bool mean = std::string(scheme) == "Average Vector Field";
    const std::string exact =
        mean ? test::count("Elastic Points", 6) + test::count("Interaction Points", 0) : std::string();
    Simulation s(test::scene(block({4, 2}) + bond(numbers("Point", {0, -0.9}), on_touch) +
                             list("Initial Conditions", numbers("Velocity", {0.05, -0.2}) +
                                                            numbers("Velocity Gradient", {0, -0.03, 0.03, 0})) +
                             test::time_integrator(scheme, 0.1, 20, exact)),
                 test::world());
    const double first = test::total_energy(s);
    EXPECT_EQ(contact_energy(s), 0);
    double lost = 0;
    for (int n = 1; n <= 150; ++n) {
      const StepResult result = s.integrator().step(0.1);
      ASSERT_TRUE(result.converged) << n << ": " << result.reason;
      EXPECT_GE(s.integrator().dissipated_energy(), lost);
      lost = s.integrator().dissipated_energy();
      ASSERT_NEAR(test::total_energy(s) + lost, first, 1e-9) << n;
    }
    EXPECT_GT(lost, 0.05 * work);
  }
}

TEST(DamageTest, AFactorScalesTheDissipationAndSolidsTearOff) {
  const std::string factor =
      word("Factor", "x &lt; 1 ? 0.5 : 2") + numbers("Point", {0, 0, 0}) + numbers("Normal", {0, 0, 1});
  const std::string lift = word("Components", "z") + word("History", "Up");
  Simulation s(test::scene(block({2, 1, 1}) + bond(factor) +
                           list("Histories", list("Up", word("Type", "Ramp") +
                                                            list("Ramp", number("Value", 1) + number("Length", 1)))) +
                           list("Boundary Conditions", list("Bottom", word("Node Set", "bottom") + lift) +
                                                           list("Top", word("Node Set", "top") + lift)) +
                           test::time_integrator("Newmark", 0.25, 1)),
               test::world());
  for (int n = 0; n < 4; ++n) ASSERT_TRUE(s.integrator().step(0.25).converged);
  EXPECT_NEAR(s.integrator().dissipated_energy(), 2.5 * work, 1e-14);
}

}  // namespace
}  // namespace ixos
