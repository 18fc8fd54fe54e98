// Bodies in one mesh that do not touch: each moves as if it were alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "scene/simulation.hpp"
#include "support/comparison.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::count;
using test::counts;
using test::list;
using test::number;
using test::numbers;
using test::texts;
using test::word;

/// One body: the list of its part, and what the scene says of it.
struct Body {
  std::string name, part, material, initial, interaction;
};

std::string material_of(const Body& body) {
  return list(body.name, word("Block", body.name + "_body") + body.material);
}

/// The scene of these bodies.
Teuchos::ParameterList scene_of(const std::vector<Body>& bodies, const std::string& mesh,
                                const std::string& integrator) {
  std::string parts, materials, interactions, initial;
  for (const Body& body : bodies) {
    parts += list(body.name, body.part);
    materials += material_of(body);
    initial += list(body.name, texts("Blocks", "{" + body.name + "_body}") + body.initial);
    if (!body.interaction.empty()) interactions += list(body.name, body.interaction);
  }
  return test::scene(list("Mesh", word("Type", "Parts") + mesh + list("Parts", parts)) + list("Materials", materials) +
                     list("Interactions", interactions) + list("Initial Conditions", initial) + integrator +
                     list("Nonlinear Solver", number("Tolerance", 1e-13)));
}

/// A disk that falls on a sticky wall, and a box elsewhere, of another material, that spins.
std::vector<Body> disk_and_box(const std::string& interaction = "") {
  return {{"ball", list("Disk", number("Diameter", 10)) + numbers("Translation", {0, 5.6}),
           number("Density", 1) + number("Poisson's Ratio", 0.2), numbers("Velocity", {0, -0.3}),
           word("Side Set", "ball_surface") + interaction},
          {"block",
           word("Type", "Box") + list("Box", numbers("Lengths", {4, 2}) + counts("Divisions", {4, 2})) +
               number("Rotation Angle", 30) + numbers("Translation", {40, 3}),
           number("Density", 3) + number("Young's Modulus", 2), numbers("Angular Velocity", {0.2}), ""}};
}

/// A cube that a map makes a ball, and a box.
std::vector<Body> ball_and_box() {
  const auto rounded = [](const std::string& x, const std::string& y, const std::string& z) {
    return x + "*sqrt(1 - " + y + "^2/2 - " + z + "^2/2 + " + y + "^2*" + z + "^2/3)";
  };
  return {{"ball",
           word("Type", "Box") +
               list("Box", count("Dimension", 3) + numbers("Lower", {-1, -1, -1}) + numbers("Lengths", {2, 2, 2}) +
                               counts("Divisions", {4, 4, 4})) +
               list("Map", word("X", rounded("x", "y", "z")) + word("Y", rounded("y", "z", "x")) +
                               word("Z", rounded("z", "x", "y"))) +
               numbers("Translation", {0, 0, 1.5}),
           number("Density", 1), numbers("Velocity", {0.1, 0, -0.5}),
           word("Side Set", "ball_surface") + numbers("Normal", {0, 0, 1})},
          {"block",
           word("Type", "Box") +
               list("Box", count("Dimension", 3) + numbers("Lengths", {2, 1, 1}) + counts("Divisions", {3, 2, 2})) +
               number("Rotation Angle", 50) + numbers("Rotation Axis", {1, 2, 3}) + numbers("Translation", {0, 20, 7}),
           number("Density", 2) + number("Mass Damping", 0.1), numbers("Angular Velocity", {0.1, 0.2, -0.1}), ""}};
}

/// By place in the reference configuration, the displacement of each node. Collective.
using Motion = std::map<std::vector<double>, std::vector<double>>;

void add_motion(const Simulation& s, Motion& motion) {
  const LocalMesh& mesh = s.model().mesh();
  const std::vector<double> u = test::gathered(s.model(), s.integrator().state().u),
                            x = test::gathered(s.model(), mesh.coordinates);
  const auto d = static_cast<std::ptrdiff_t>(mesh.dimension);
  for (auto from = x.begin(), value = u.begin(); from != x.end(); from += d, value += d)
    EXPECT_TRUE(motion.insert({{from, from + d}, {value, value + d}}).second);
}

/// Sums over the bodies: kinetic energy, energy of the interactions, linear and angular momenta.
struct Sums {
  double kinetic = 0, interaction = 0;
  std::vector<double> linear = std::vector<double>(3), angular = std::vector<double>(3);
};

void add_sums(const Simulation& s, Sums& sums) {
  const State& state = s.integrator().state();
  const Momenta own = StateReport(s.model(), state).momenta();
  sums.kinetic += own.kinetic_energy;
  std::transform(own.linear.begin(), own.linear.end(), sums.linear.begin(), sums.linear.begin(), std::plus<>());
  std::transform(own.angular.begin(), own.angular.end(), sums.angular.begin(), sums.angular.begin(), std::plus<>());
  sums.interaction += StateReport(s.model(), state).energy(Part::Interaction);
}

/// Expects that all bodies move as each does alone, on one rank, to a tolerance over the largest displacement.
void expect_alone(const std::vector<Body>& bodies, const std::string& mesh, const std::string& integrator, double step,
                  int steps, double tolerance) {
  const auto run = [&](Simulation& s) {
    for (int k = 0; k < steps; ++k) ASSERT_TRUE(s.integrator().step(step).converged) << k;
  };
  Simulation together(scene_of(bodies, mesh, integrator), test::world());
  run(together);
  Motion all, expected;
  Sums sums, alone_sums;
  add_motion(together, all);
  add_sums(together, sums);
  for (const Body& body : bodies) {
    Simulation alone(scene_of({body}, mesh, integrator), test::self());
    run(alone);
    add_motion(alone, expected);
    add_sums(alone, alone_sums);
  }
  ASSERT_EQ(all.size(), expected.size());
  double largest = 0, error = 0;
  for (const auto& [place, u] : all) {
    ASSERT_EQ(expected.count(place), 1U);
    for (const double value : u) largest = std::max(largest, std::abs(value));
    error = std::max(error, test::distance(u, expected[place]));
  }
  EXPECT_LT(error, tolerance * largest);
  EXPECT_NE(sums.interaction, 0);
  EXPECT_NEAR(sums.interaction, alone_sums.interaction, 100 * tolerance * std::abs(sums.interaction));
  const double size = std::sqrt(sums.kinetic);
  EXPECT_NEAR(sums.kinetic, alone_sums.kinetic, 100 * tolerance * sums.kinetic);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(sums.linear[i], alone_sums.linear[i], 100 * tolerance * size);
    EXPECT_NEAR(sums.angular[i], alone_sums.angular[i], 4000 * tolerance * size);  // arms of 40
  }
}

std::string every(const std::string& scheme, double step) { return test::time_integrator(scheme, step, 1000); }

// Rounding only: explicit steps solve nothing.
TEST(PartsTest, BodiesThatDoNotTouchMoveAsEachAlone) {
  for (const char* cells : {"1", "2"})
    expect_alone(disk_and_box(), count("Cell Order", std::stoi(cells)), every("Central Difference", 0.01), 0.01, 50,
                 1e-12);
  expect_alone(ball_and_box(), "", every("Central Difference", 0.01), 0.01, 30, 1e-12);
}

// Newton's method stops at its tolerance over all bodies together.
TEST(PartsTest, SoTheyDoInImplicitSteps) {
  expect_alone(disk_and_box(word("Contact Element", "Q1C4")), "", every("Energy-Momentum", 0.1), 0.1, 8, 1e-9);
  expect_alone(ball_and_box(), "", every("Average Vector Field", 0.1), 0.1, 5, 1e-9);
}

}  // namespace
}  // namespace ixos
