// Sets by place of meshes whose coordinates carry few digits, on any number of ranks.
#include <gtest/gtest.h>

#include <cmath>

#include "interaction/gap_law.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/placement.hpp"
#include "scene/simulation.hpp"
#include "support/refusal.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::list;
using test::numbers;
using test::word;

constexpr double lower_gap = 0.3;

/// A plate of 4 by 2 L0 without sets, turned about the origin.
Mesh plate(double angle) {
  BoxShape shape;
  shape.lengths = {4, 2, 1};
  shape.divisions = {8, 4, 1};
  Mesh mesh = box(shape);
  mesh.side_sets.clear();
  mesh.node_sets.clear();
  Placement placement;
  placement.angle = angle;
  move_nodes(placement, mesh);
  return mesh;
}
Mesh rounded(Mesh mesh) {
  for (double& x : mesh.coordinates) x = static_cast<double>(static_cast<float>(x));
  return mesh;
}

/// The plate's lower side before a wall, its upper side held: sets by place.
Teuchos::ParameterList scene(double angle) {
  const double c = std::cos(angle * M_PI / 180), s = std::sin(angle * M_PI / 180);
  const std::string normal = numbers("Plane Normal", {-s, c});
  return test::scene(
      list("Mesh", list("Sets", list("under", normal) + list("upper", word("Kind", "Nodes") + normal +
                                                                          numbers("Plane Point", {-2 * s, 2 * c})))) +
      list("Materials", list("Rubber", word("Block", "body"))) +
      list("Interactions", list("Wall", word("Side Set", "under") + numbers("Normal", {-s, c}) +
                                            numbers("Point", {lower_gap * s, -lower_gap * c}))) +
      list("Boundary Conditions", list("Hold", word("Node Set", "upper"))) +
      test::time_integrator("Average Vector Field", 0.01, 1));
}

double force(const Simulation& simulation) {
  const std::vector<double> u(simulation.integrator().state().u.size(), 0.0);
  const std::vector<double> sum = test::ReportAt(simulation.model(), u.data()).interaction_report().force;
  return std::hypot(sum[0], sum[1]);
}

TEST(RoundedMeshTest, TheForceIsThatOfTheWholeSide) {
  const Simulation straight(scene(0), plate(0), test::world());
  // The traction at the gap times the length: all points of a flat side have one gap.
  const GapLaw& law = *straight.interactions()[0].law;
  const double whole = std::abs(static_cast<double>(law.traction(Pack(lower_gap))[0])) * 4;
  EXPECT_NEAR(force(straight), whole, 1e-12 * whole);
  for (const double angle : {10.0, 33.0, 80.0}) {
    const Simulation turned(scene(angle), rounded(plate(angle)), test::world());
    EXPECT_NEAR(force(turned), whole, 1e-5 * whole) << angle;
    ASSERT_EQ(turned.set_sizes().size(), 2U);
    EXPECT_EQ(turned.set_sizes()[0].count, 8U);
    EXPECT_NEAR(turned.set_sizes()[0].measure, 4, 1e-6);
    EXPECT_EQ(turned.set_sizes()[1].count, 9U);
  }
}

TEST(RoundedMeshTest, WhatIsLeftOutNearThePlaneIsRefusedOnAllRanks) {
  Mesh mesh = plate(10);
  for (std::size_t k = 0; k < mesh.coordinates.size(); k += 8) mesh.coordinates[k + 1] += 0.002;  // edges of 0.5
  const std::string message = test::refusal([&] { Simulation(scene(10), mesh, test::world()); });
  test::expect_contains(message, "Mesh/Sets/under: the set \"under\" takes ");
  test::expect_contains(message, "Give the set a Tolerance");
}

}  // namespace
}  // namespace ixos
