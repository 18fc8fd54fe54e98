// Collisions keep energy and momenta, also over 2,000 steps.
#include <gtest/gtest.h>

#include <cstdio>

#include "mesh/selection.hpp"
#include "mesh/splitting/refine.hpp"
#include "support/simplices.hpp"
#include "verification/collision.hpp"

namespace ixos {
namespace {

using test::Collision;
using test::count;
using test::KeptErrors;
using test::number;
using test::word;

constexpr int many = 2000;

const Mesh& disks() {
  static const Mesh mesh = test::two_disks(3, {6.1, 2.4});
  return mesh;
}

/// The errors, which it prints, of a scheme; points: in time, 0 for none.
KeptErrors errors_of(const char* what, const char* scheme, const Mesh& mesh, double dt, int steps, int points = 0,
                     const std::string& pair = "") {
  Collision collision(
      scheme, dt, points > 0 ? count("Interaction Points", points) : "",
      mesh.dimension == 3 ? count("Surface Points", 3) + (pair.empty() ? number("Cutoff", 2) : pair) : pair, mesh);
  const KeptErrors errors = test::kept_errors(collision, dt, steps);
  if (test::world()->getRank() == 0)
    std::printf("%s, %s, %d steps of %g, points %d: energy %.1e, linear momentum %.1e, angular momentum %.1e\n", what,
                scheme, steps, dt, points, errors.energy, errors.linear, errors.angular);
  EXPECT_LT(errors.least_gap, 0.25) << what;
  return errors;
}

void expect_all_kept(const KeptErrors& errors) {
  EXPECT_LT(errors.energy, 1e-11);
  EXPECT_LT(errors.linear, 1e-12);
  EXPECT_LT(errors.angular, 1e-11);
}

/// The disks and the rings stick, the balls part.
TEST(PairConservationLongTest, EnergyMomentumKeepsEnergyAndBothMomenta) {
  const char* scheme = "Energy-Momentum";
  expect_all_kept(errors_of("disks", scheme, disks(), 0.002, many));
  const KeptErrors straight =
      errors_of("disks of straight sides", scheme, disks(), 0.001, many, 0, word("Smoothing", "None"));
  EXPECT_LT(straight.energy, 1e-11);
  EXPECT_LT(straight.linear, 1e-12);
  EXPECT_LE(straight.turned, 5);  // a point that rolls over a kink gives a moment
  EXPECT_LT(straight.angular, 1e-3);
  expect_all_kept(errors_of("rings", scheme, test::two_rings(3, 2.2, {6.1, 2.4}, 32, 2), 0.001, many));
  expect_all_kept(errors_of("balls", scheme, test::two_balls(3, {6.1, 1.9, 1.5}, 3, 1), 0.001, many));
}

/// Two disks of 64 sides each attract each other from rest. The closest points of many points roll.
TEST(PairConservationTest, EnergyMomentumTakesProjectionsThatRoll) {
  Collision collision("Energy-Momentum", 0.0005, "", "", test::two_disks(2, {0.3, 4.4}, 16), "b_surface", "a_surface");
  Simulation& simulation = collision.simulation();
  const std::vector<double> rest = test::at_rest(simulation.model());
  simulation.integrator().initialize(rest, rest, 0);
  const double before = test::total_energy(simulation);
  for (int step = 0; step < 50; ++step) {
    const StepResult result = simulation.integrator().step(0.0005);
    ASSERT_TRUE(result.converged) << step << ": " << result.reason;
    EXPECT_NEAR(test::total_energy(simulation), before, 1e-11 * Collision::work_of_adhesion);
  }
}

/// Two balls whose cells between them are split once: their surfaces have hanging nodes. The set "both" has both.
Mesh refined_balls() {
  Mesh mesh = test::two_balls(3, {6.1, 1.9, 1.5}, 2, 1);
  RefinedRegion between;
  between.sphere_radius = 1.5;
  between.sphere_center = {3.05, 0.95, 0.75};
  refine(mesh, {{"between", between}}, 1);
  SideSet both{"both", {}};
  for (const char* name : {"a_surface", "b_surface"}) {
    const SideSet& own = side_set_named(mesh, name);
    both.sides.insert(both.sides.end(), own.sides.begin(), own.sides.end());
  }
  mesh.side_sets.push_back(both);
  return mesh;
}

/// Passes over two surfaces, and over one that has both bodies.
TEST(PairConservationTest, SurfacesWithHangingNodesKeepEnergyAndBothMomenta) {
  const Mesh mesh = refined_balls();
  ASSERT_FALSE(mesh.ties.empty());
  for (const char* surface : {"a_surface", "both"}) {
    SCOPED_TRACE(surface);
    const std::string other = surface == std::string("both") ? "both" : "b_surface";
    Collision collision("Energy-Momentum", 0.002, "",
                        count("Surface Points", 3) + number("Cutoff", 1) + word("Smoothing", "None") +
                            (other == "both" ? number("Exclusion", 3.14) : ""),
                        mesh, surface, other);
    const KeptErrors errors = test::kept_errors(collision, 0.002, 30);
    EXPECT_LT(errors.linear, 1e-12);
    EXPECT_LT(errors.angular, 1e-11);
    // Points of one surface with itself begin and end to act within steps, with or without hanging nodes.
    if (other != "both") {
      EXPECT_LT(errors.energy, 1e-11);
    }
    EXPECT_LT(errors.least_gap, 0.45);
  }
}

/// Balls of tetrahedra.
TEST(PairConservationTest, SurfacesOfTrianglesKeepEnergyAndBothMomenta) {
  const Mesh mesh = test::split_cells(test::two_balls(3, {6.1, 1.9, 1.5}, 2, 1), "twelve tetrahedra");
  for (const char* smoothing : {"None", "Catmull-Rom"}) {
    SCOPED_TRACE(smoothing);
    Collision collision("Energy-Momentum", 0.002, "",
                        count("Surface Points", 3) + number("Cutoff", 1) + word("Smoothing", smoothing), mesh,
                        "a_surface", "b_surface");
    const KeptErrors errors = test::kept_errors(collision, 0.002, 30);
    expect_all_kept(errors);
    EXPECT_LT(errors.least_gap, 0.45);
  }
}

/// On curves of Catmull-Rom the power of a force has a kink where its closest point crosses a node, on splines it has
/// none. With the cutoff, points that are as near to two parts of a ring do not act.
TEST(PairConservationLongTest, TheAverageVectorFieldKeepsEnergyAndLinearMomentum) {
  const char* scheme = "Average Vector Field";
  const Mesh rings = test::two_rings(3, 2.2, {6.1, 2.4}, 32, 2), balls = test::two_balls(3, {6.1, 1.9, 1.5}, 3, 1);
  const std::string spline = word("Smoothing", "Spline"), near = spline + number("Cutoff", 3);
  const auto expect = [](const KeptErrors& errors, double energy) {
    EXPECT_LT(errors.energy, energy);
    EXPECT_LT(errors.linear, 1e-12);
  };
  expect(errors_of("disks", scheme, disks(), 0.0005, many, 16), 2e-7);
  expect(errors_of("disks of splines", scheme, disks(), 0.0005, many, 8, spline), 1e-7);
  expect(errors_of("rings of splines, cutoff", scheme, rings, 0.0005, many, 8, near), 1e-7);
  expect(errors_of("balls", scheme, balls, 0.001, many, 8), 1e-5);
  const Mesh large = test::two_balls(5, {11, 4, 0}, 4, 2);
  expect(errors_of("large balls of splines", scheme, large, 0.001, 200, 8, spline), 1e-7);
}

TEST(PairConservationTest, TheAverageVectorFieldsErrorOfTheAngularMomentumIsOfSecondOrder) {
  const char* scheme = "Average Vector Field";
  const double coarse = errors_of("disks", scheme, disks(), 0.0005, 120, 8).angular;
  const double fine = errors_of("disks", scheme, disks(), 0.00025, 240, 8).angular;
  EXPECT_NEAR(coarse / fine, 4, 0.6);
}

}  // namespace
}  // namespace ixos
