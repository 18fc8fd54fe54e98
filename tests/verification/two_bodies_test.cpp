// Two bodies that stick to each other: conservation laws, closed forms, and the rigid wall.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "interaction/gap_law.hpp"
#include "interaction/van_der_waals.hpp"
#include "mesh/generators/shapes.hpp"
#include "scene/simulation.hpp"
#include "support/comparison.hpp"
#include "support/refusal.hpp"
#include "support/reports.hpp"
#include "support/two_bodies.hpp"
#include "time/integrator.hpp"
#include "verification/collision.hpp"

namespace ixos {
namespace {

using test::Collision;
using test::count;
using test::expect_kept;
using test::list;
using test::material;
using test::number;
using test::scene_of;
using test::texts;
using test::word;

/// Off centre, two disks meet, roll over each other and vibrate: linear momentum stays to rounding with every scheme,
/// also where the matrix lacks the stiffness of far sides.
TEST(TwoBodiesTest, LinearMomentumIsKept) {
  for (const char* scheme : {"Newmark", "Generalized-Alpha", "Midpoint", "Bathe Composite", "Gautam-Sauer Composite",
                             "Average Vector Field", "Central Difference"}) {
    const bool averages = std::string(scheme) == "Average Vector Field" || scheme[1] == 'a';
    const double dt = std::string(scheme) == "Central Difference" ? 1e-4 : 0.001;
    Collision collision(scheme, dt, averages && scheme[0] != 'B' ? count("Interaction Points", 5) : "");
    const double mass_times_speed = 2 * M_PI * 9 * 5e-7 * Collision::speed;
    double least = 1;
    for (int step = 0; step < std::lround(0.04 / dt); ++step) {
      ASSERT_TRUE(collision.simulation().integrator().step(dt).converged) << scheme << " " << step;
      least = std::min(least, collision.least_gap());
    }
    for (double momentum : collision.momenta().linear) EXPECT_NEAR(momentum, 0, 2e-14 * mass_times_speed) << scheme;
    EXPECT_LT(least, 0.25) << scheme;
  }
}

/// Two balls that meet in space: 3 Gauss points a direction.
Mesh balls() { return test::two_balls(3, {6.1, 1.9, 1.5}, 4, 1); }
const std::string in_space = count("Surface Points", 3) + number("Cutoff", 2);

/// Energy-Momentum keeps energy and both momenta to the solver's tolerance, on straight sides as on smooth ones.
TEST(TwoBodiesTest, EnergyMomentumKeepsEnergyAndBothMomenta) {
  Collision smooth("Energy-Momentum", 0.001), straight("Energy-Momentum", 0.001, "", word("Smoothing", "None"));
  expect_kept(smooth, 0.001, 200, 1e-11, 1e-12, 1e-11);
  expect_kept(straight, 0.001, 60, 1e-11, 1e-12, 1e-11);
  Collision in_space_too("Energy-Momentum", 0.002, "", in_space, balls());
  expect_kept(in_space_too, 0.002, 18, 1e-11, 1e-12, 1e-11);
}

TEST(TwoBodiesTest, TheAverageVectorFieldKeepsEnergyAndLinearMomentumInSpace) {
  Collision collision("Average Vector Field", 0.001, count("Interaction Points", 8), in_space, balls());
  expect_kept(collision, 0.001, 32, 5e-6, 1e-12, 1e-2);
}

/// In one step the disks would move by 1, 3, 10 times their diameter: they do not pass through each other. A scheme
/// finds a state in which they are still on their sides, or the step fails. Newmark's method looks at the end of the
/// step only, where they are beyond each other: Ixos looks at the way, too.
TEST(TwoBodiesTest, FastBodiesDoNotTunnel) {
  for (const char* scheme : {"Newmark", "Average Vector Field", "Energy-Momentum"})
    for (const double diameters : {1.0, 3.0, 10.0}) {
      const double dt = diameters * 6 / (2 * Collision::speed);
      Collision collision(scheme, dt, scheme[0] == 'A' ? count("Interaction Points", 5) : "");
      if (!collision.simulation().integrator().step(dt).converged) continue;
      const LocalMesh& mesh = collision.simulation().model().mesh();
      const std::vector<double>& u = collision.simulation().integrator().state().u;
      double sums[2] = {0, 0};  // along the line of their first centres
      for (std::size_t k = 0; k < static_cast<std::size_t>(2 * mesh.owned_nodes); k += 2)
        sums[mesh.coordinates[k] > 3.05 ? 1 : 0] +=
            6.1 * (mesh.coordinates[k] + u[k]) + 2.4 * (mesh.coordinates[k + 1] + u[k + 1]);
      collision.simulation().model().space().sum(sums, 2);
      EXPECT_LT(sums[0], sums[1]) << scheme << " " << diameters;
      EXPECT_GT(collision.least_gap(), 0);
    }
}

/// The energy error of the average vector field is that of the quadrature in time.
TEST(TwoBodiesTest, TheAverageVectorFieldKeepsTheEnergy) {
  Collision collision("Average Vector Field", 0.001, count("Interaction Points", 8) + count("Elastic Points", 4));
  const double before = test::total_energy(collision.simulation());
  double largest = 0, least = 1;
  for (int step = 0; step < 100; ++step) {
    ASSERT_TRUE(collision.simulation().integrator().step(0.001).converged);
    largest = std::max(largest, std::abs(test::total_energy(collision.simulation()) - before));
    least = std::min(least, collision.least_gap());
  }
  EXPECT_LT(largest, 1e-7 * Collision::work_of_adhesion);
  EXPECT_LT(least, 0.25);
}

/// Returns the largest attraction between two rigid cylinders of radius 10, per length.
double pull_off(int core, int rings) {
  const Mesh mesh = test::two_disks(10, {0, 20.2}, core, rings);
  const auto model = test::model_of_bodies(mesh, {"a_surface", "b_surface"});
  SurfacePair pair;
  pair.side_set = "a_surface";
  pair.primary = "b_surface";
  pair.law = gap_law(VanDerWaals(2.5, 25));
  add_pair(*model, pair);
  std::vector<double> u = test::at_rest(*model);
  double largest = 0;
  for (double shift = 0; shift < 0.2; shift += 0.0025) {
    for (std::size_t k = 0; k < u.size(); k += 2)
      if (model->mesh().coordinates[k + 1] > 10.1) u[k + 1] = shift;
    largest = std::max(largest, test::ReportAt(*model, u.data()).interaction_report().force[1]);
  }
  return largest;
}

/// The exact value is that of all pairs of the two bodies' molecules (Argento, Jagota and Carter 1997), 0.165710. The
/// law of the least distance is 3.4 % above it.
TEST(TwoBodiesTest, CylindersPullOffNearTheExactForce) { EXPECT_NEAR(pull_off(24, 2) / 0.165710, 1.034, 0.001); }

/// Two spheres of radius 10: the exact value of all pairs of molecules is 0.457676, the law of the least distance 9.5 %
/// above it. Patches of a sphere of n^2 faces a side of the cube converge with the fourth power of their size.
TEST(TwoBodiesSerialTest, SpheresPullOffNearTheExactForce) {
  const Mesh mesh = test::two_balls(10, {0, 0, 20.2}, 24, 1);
  const auto model = test::model_of_bodies(mesh, {"a_surface", "b_surface"});
  SurfacePair pair;
  pair.side_set = "a_surface";
  pair.primary = "b_surface";
  pair.law = gap_law(VanDerWaals(2.5, 25));
  pair.cutoff = 6;  // takes 0.7 % of the work of adhesion and of the force away
  pair.points = 4;
  add_pair(*model, pair);
  std::vector<double> u = test::at_rest(*model);
  double largest = 0;
  for (double shift = 0.02; shift < 0.1; shift += 0.01) {
    for (std::size_t k = 0; k < u.size(); k += 3)
      if (model->mesh().coordinates[k + 2] > 10.1) u[k + 2] = shift;
    largest = std::max(largest, test::ReportAt(*model, u.data()).interaction_report().force[2]);
  }
  EXPECT_NEAR(largest / 0.457676, 1.095, 0.015);
}

/// A flat primary surface whose body is held is the rigid wall.
TEST(TwoBodiesTest, AHeldBodyWithAFlatFaceIsTheWall) {
  const std::string time = test::time_integrator("Average Vector Field", 2e-4, 1, count("Interaction Points", 5));
  const std::string held =
      list("Boundary Conditions", list("Held", word("Node Set", "lower_inside") + word("Components", "xy")));
  Mesh mesh = test::two_blocks(0.4);
  NodeSet inside{"lower_inside", {}};
  for (int node = 0; node < mesh.nodes(); ++node)
    if (mesh.coordinates[2 * static_cast<std::size_t>(node) + 1] < 0.1) inside.nodes.push_back(node);
  mesh.node_sets.push_back(inside);
  Simulation pair(
      scene_of("lower_body", "upper_body", "upper_bottom", "lower_top", time, word("Smoothing", "None"), held), mesh,
      test::world());
  Teuchos::ParameterList scene =
      scene_of("lower_body", "upper_body", "upper_bottom", "lower_top", time, word("Smoothing", "None"), held);
  scene.sublist("Interactions").sublist("Pair").remove("Primary Side Set");
  Simulation wall(scene, mesh, test::world());
  double least = 1;
  for (int step = 0; step < 60; ++step) {
    for (Simulation* simulation : {&pair, &wall}) ASSERT_TRUE(simulation->integrator().step(2e-4).converged);
    least = std::min(least, test::report_of(pair).interaction_report().least_gap);
  }
  const auto a = test::gathered(pair.model(), pair.integrator().state().u);
  const auto b = test::gathered(wall.model(), wall.integrator().state().u);
  EXPECT_LT(test::distance(a, b), 1e-9);
  EXPECT_LT(least, 0.25);
}

/// A U of `cells` by 2 cells with arms of length 12 and thickness 1, 1.2 apart.
Mesh hairpin(int cells) {
  BoxShape shape;
  shape.dimension = 2;
  shape.lengths = {24 + 1.1 * M_PI, 1, 0};
  shape.divisions = {cells, 2, 1};
  Mesh mesh = box(shape);
  for (std::size_t k = 0; k < mesh.coordinates.size(); k += 2) {
    // From the end of the upper arm around the bend to that of the lower one; the box's top faces the space between.
    const double s = mesh.coordinates[k], r = 1.6 - mesh.coordinates[k + 1];
    const double angle = std::min(std::max((s - 12) / 1.1, 0.0), M_PI);
    const double along = s < 12 ? 12 - s : std::max(0.0, s - 12 - 1.1 * M_PI);
    mesh.coordinates[k] = along - r * std::sin(angle);
    mesh.coordinates[k + 1] = r * std::cos(angle);
  }
  return mesh;
}

/// The arms of a hairpin fly at each other, stick, and bounce: energy is kept but for jumps where parts begin to face
/// each other, which are booked, and so are both momenta.
TEST(TwoBodiesTest, AHairpinSticksToItself) {
  Mesh mesh = hairpin(60);
  const std::string self = number("Cutoff", 0.8) + number("Exclusion", 3);
  const auto scene = [&](const std::string& pair) {
    return test::scene(
        list("Materials", material("body")) +
        list("Interactions", list("Pair", word("Side Set", "surface") + word("Primary Side Set", "surface") +
                                              number("Gamma L", 2.5) + number("Gamma W", 25) + pair)) +
        test::time_integrator("Average Vector Field", 0.001, 1, count("Interaction Points", 8)) +
        list("Nonlinear Solver", number("Tolerance", 1e-11)));
  };
  EXPECT_NE(test::refusal([&] {
              Simulation(scene(number("Cutoff", 0.8)), mesh, test::world());
            }).find("Exclusion: 0 is too short"),
            std::string::npos);
  EXPECT_NE(
      test::refusal([&] { Simulation(scene(number("Exclusion", 3)), mesh, test::world()); }).find("Cutoff: 0 is none"),
      std::string::npos);
  Simulation simulation(scene(self), mesh, test::world());
  std::vector<double> u = test::at_rest(simulation.model()), v = u;
  for (std::size_t k = 1; k < v.size(); k += 2) {
    const double x = simulation.model().mesh().coordinates[k - 1], y = simulation.model().mesh().coordinates[k];
    v[k] = (y > 0 ? -1 : 1) * 3.0 * std::max(0.0, x) / 12;
  }
  Integrator& integrator = simulation.integrator();
  integrator.initialize(u, v, 0);
  const double before = test::total_energy(simulation);
  double largest = 0, least = 10, contact = 0;
  for (int step = 0; step < 200; ++step) {
    const StepResult result = integrator.step(0.001);
    ASSERT_TRUE(result.converged) << step << ": " << result.reason;
    largest = std::max(largest, std::abs(test::total_energy(simulation) + integrator.dissipated_energy() - before));
    const InteractionReport report = StateReport(simulation.model(), integrator.state()).interaction_report();
    least = std::min(least, report.least_gap);
    contact = std::max(contact, report.measure);
  }
  EXPECT_LT(least, 0.3);
  EXPECT_GT(contact, 2);
  EXPECT_LT(largest, 1e-3 * Collision::work_of_adhesion);
  const Momenta momenta =
      test::ReportAt(simulation.model(), integrator.state().u.data(), integrator.state().v.data()).momenta();
  for (const double momentum : momenta.linear) EXPECT_NEAR(momentum, 0, 1e-9 * 24 * 5e-7 * 3);
}

TEST(TwoBodiesTest, ScenesThatPairsDoNotTakeAreRefusedAtTheirPlace) {
  const std::string time = test::time_integrator("Newmark", 0.001, 1);
  const auto expect_refusal = [&](const std::string& pair, const std::string& place, const std::string& words = "",
                                  const char* primary = "b_surface") {
    try {
      Simulation(scene_of("a_body", "b_body", "a_surface", primary, time, pair), test::two_disks(3, {6.1, 2.4}),
                 test::world());
      ADD_FAILURE() << place;
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.find("Interactions/Pair" + place), 0U) << message;
      EXPECT_NE(message.find(words), std::string::npos) << message;
    }
  };
  expect_refusal(
      list("Friction", word("Type", "Extended Amontons") + number("Coefficient", 0.5) + word("Threshold", "Current")),
      "/Friction/Threshold");
  expect_refusal(word("Contact Element", "Q1CH"), "/Contact Element", "\"Q1CH\" is not there for surfaces of two");
  const std::string rubbing = list("Friction", word("Type", "Extended Amontons") + number("Coefficient", 0.5));
  expect_refusal(rubbing + number("Cutoff", 1) + number("Exclusion", 3), "/Friction/Type",
                 "\"Extended Amontons\" is not there for a surface that interacts with itself yet; use \"None\"",
                 "a_surface");
  expect_refusal(rubbing + word("Passes", "Two Without Reaction"), "/Friction/Type", "use \"None\", or the Passes");
  expect_refusal(list("Motion", texts("Translation", "{Up, Up}")), "/Motion");
  expect_refusal(number("Cutoff", 0.1), "/Cutoff");
  Teuchos::ParameterList scene = scene_of("a_body", "b_body", "a_surface", "c_surface", time);
  EXPECT_THROW(Simulation(scene, test::two_disks(3, {6.1, 2.4}), test::world()), InputError);
  scene = scene_of("a_body", "b_body", "a_surface", "b_surface", time);
  EXPECT_THROW(Simulation(scene, test::two_disks(3, {5, 2.4}), test::world()), InputError);  // they overlap
}

/// Faces have the direction of their cells: a cell of the wrong direction is refused by its number, and so is a side
/// whose outer side is its own body.
TEST(TwoBodiesTest, FacesInsideOutAreRefusedAtTheirPlace) {
  const auto refusal = [](const Mesh& mesh) {
    return test::refusal([&] {
      Simulation(scene_of("a_body", "b_body", "a_surface", "b_surface", test::time_integrator("Newmark", 0.001, 1), "",
                          list("Mesh", word("Type", "Given") + list("Given", count("Dimension", mesh.dimension)))),
                 mesh, test::world());
    });
  };
  for (const Mesh& sound : {test::two_disks(3, {6.1, 2.4}), test::two_balls(3, {6.1, 1.9, 1.5}, 2, 1)}) {
    ASSERT_EQ(sound.side_sets.back().name, "b_surface");
    const Side& side = sound.side_sets.back().sides.front();
    Mesh mesh = sound;
    ElementBlock& block = mesh.blocks[static_cast<std::size_t>(side.block)];
    const auto corners = static_cast<std::ptrdiff_t>(nodes_per_cell(block.type));
    const auto first = block.nodes.begin() + corners * side.cell;
    if (mesh.dimension == 2)
      std::reverse(first, first + corners);
    else
      std::swap_ranges(first, first + 4, first + 4);
    std::string message = refusal(mesh);
    test::expect_contains(message, "block \"b_body\", ");
    test::expect_contains(message, "inverted");
    mesh = sound;
    mesh.side_sets.back().sides.push_back({side.block, 0, 0});  // of the core
    message = refusal(mesh);
    test::expect_contains(message, "Interactions/Pair/Primary Side Set");
    test::expect_contains(message, "side 1 of element");
    test::expect_contains(message, "inside the body");
  }
}

TEST(TwoBodiesTest, SchemesWithMeansInClosedFormAreRefused) {
  try {
    Collision collision("Average Vector Field", 0.001, count("Interaction Points", 0));
    ADD_FAILURE();
  } catch (const InputError& error) {
    test::expect_contains(error.what(), "Interactions/Pair/Primary Side Set");
    test::expect_contains(error.what(), "0 Interaction Points, which two surfaces do not have; use 1 or more");
  }
}

}  // namespace
}  // namespace ixos
