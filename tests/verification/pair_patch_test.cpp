// Blocks with different meshes that press on each other: the patch test.
#include <gtest/gtest.h>

#include <cmath>

#include "interaction/van_der_waals.hpp"
#include "support/pair_of_bodies.hpp"
#include "support/reports.hpp"
#include "verification/collision.hpp"

namespace ixos {
namespace {

using test::list;
using test::word;

/// Two blocks of 2 by 1, the upper one with more cells along the faces that meet, the gap of equilibrium apart. The
/// node sets "foot" and "head" are their other ends.
Mesh stack(double gap) {
  Mesh mesh;
  BoxShape shape;
  shape.dimension = 2;
  shape.lengths = {2, 1, 0};
  shape.divisions = {5, 3, 1};
  shape.lower = {0, -1, 0};
  test::append(mesh, box(shape), "lower_");
  shape.divisions = {9, 4, 1};
  shape.lower = {0, gap, 0};
  test::append(mesh, box(shape), "upper_");
  NodeSet foot{"foot", {}}, head{"head", {}};
  for (int node = 0; node < mesh.nodes(); ++node) {
    const double y = mesh.coordinates[2 * static_cast<std::size_t>(node) + 1];
    if (y < -1 + 1e-9) foot.nodes.push_back(node);
    if (y > gap + 1 - 1e-9) head.nodes.push_back(node);
  }
  mesh.node_sets.insert(mesh.node_sets.end(), {foot, head});
  return mesh;
}

/// Without lateral contraction a pressed stack has one strain, one gap and the law's pressure, as far as the forces on
/// the coarser face are those of a constant pressure: within 0.3 % of straight sides with 5 points on sides 1.4 times
/// finer (Gauss points do not see where the other surface's sides end).
TEST(PairPatchTest, UnmatchedMeshesTransferAConstantPressure) {
  const double gap = 0.2547, pressed = 0.06;
  for (const char* passes : {"One", "Two"}) {
    SCOPED_TRACE(passes);
    Teuchos::ParameterList scene = test::scene_of(
        "lower_body", "upper_body", "upper_bottom", "lower_top", test::time_integrator("Static", 0.2, 1),
        word("Passes", passes) + word("Smoothing", "None"),
        list("Histories", test::expression("Press", "-0.06*t", "-0.06", "0")) +
            list("Boundary Conditions",
                 list("Foot", word("Node Set", "foot") + word("Components", "xy")) +
                     list("Head x", word("Node Set", "head") + word("Components", "x")) +
                     list("Head", word("Node Set", "head") + word("Components", "y") + word("History", "Press"))));
    for (const char* body : {"lower_body", "upper_body"})
      scene.sublist("Materials").sublist(body).set("Poisson's Ratio", 0.0);
    Simulation simulation(scene, stack(gap), test::world());
    for (int step = 0; step < 5; ++step) ASSERT_TRUE(simulation.integrator().step(0.2).converged) << step;
    const LocalMesh& mesh = simulation.model().mesh();
    const std::vector<double>& u = simulation.integrator().state().u;
    // Both blocks are shortened alike, by e per length; the gap takes the rest.
    const InteractionReport report = test::ReportAt(simulation.model(), u.data()).interaction_report();
    const double pressure = report.force[1] / 2;
    double largest = 0, shortening[2] = {0, 0}, count[2] = {0, 0};
    const auto owned = 2 * static_cast<std::size_t>(mesh.owned_nodes);
    const auto at_face = [&](std::size_t k) { return mesh.coordinates[k] > -1e-9 && mesh.coordinates[k] < gap + 1e-9; };
    for (std::size_t k = 1; k < owned; k += 2) {
      if (!at_face(k)) continue;
      const std::size_t body = mesh.coordinates[k] > gap / 2 ? 1 : 0;
      shortening[body] += body == 1 ? pressed + u[k] : -u[k];
      count[body] += 1;
    }
    simulation.model().space().sum(shortening, 2);
    simulation.model().space().sum(count, 2);
    for (std::size_t body = 0; body < 2; ++body) shortening[body] /= count[body];
    for (std::size_t k = 1; k < owned; k += 2) {
      if (!at_face(k)) continue;
      const std::size_t body = mesh.coordinates[k] > gap / 2 ? 1 : 0;
      largest = std::max(largest, std::abs((body == 1 ? pressed + u[k] : -u[k]) - shortening[body]));
    }
    largest = simulation.model().space().maximum(largest);
    EXPECT_GT(shortening[0], 0.01);
    EXPECT_LT(largest, 3e-3 * shortening[0]);
    EXPECT_NEAR(shortening[0], shortening[1], 1e-3 * shortening[0]);
    const double closed = gap - pressed + shortening[0] + shortening[1];
    EXPECT_NEAR(pressure, VanDerWaals(2.5, 25).traction(closed), 3e-3 * pressure);
    // The linear law of the small strain, whose error is of the order of the strain.
    EXPECT_NEAR(pressure, shortening[0], 2 * shortening[0] * shortening[0]);
  }
}

/// On smooth sides a constant pressure acts with the curve's weights. The ghost node beyond a free end makes them 10/24
/// and 26/24 of a side's force at the last two nodes, in place of 12/24 and 24/24.
TEST(PairPatchSerialTest, SmoothSidesMoveForceFromTheEndToTheNextNode) {
  const test::PairOfBodies bodies(test::two_blocks(0.3), "upper_bottom", "lower_top", Smoothing::CatmullRom);
  const std::vector<double>& x = bodies.model->mesh().coordinates;
  std::vector<double> u = test::at_rest(*bodies.model), f(u.size(), 0.0);
  EXPECT_TRUE(bodies.term->add_force({nullptr, nullptr, u.data()}, end_rule(), f.data()));
  const double side = 0.4 * VanDerWaals(2.5, 25).traction(0.3);
  int found = 0;
  for (std::size_t k = 0; k < x.size(); k += 2) {
    if (std::abs(x[k + 1] - 0.3) > 1e-9) continue;
    const double from_end = std::min(x[k], 2 - x[k]);
    EXPECT_NEAR(f[k + 1], -side * (from_end < 0.1 ? 10 : from_end < 0.5 ? 26 : 24) / 24, 1e-13);
    ++found;
  }
  EXPECT_EQ(found, 6);
}

}  // namespace
}  // namespace ixos
