// Scenes with quadratic cells: meshes, contact elements, refusals.
#include <gtest/gtest.h>

#include <cmath>

#include "mesh/cell_order.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/quality.hpp"
#include "mesh/selection.hpp"
#include "scene/explain/explanation.hpp"
#include "scene/read/scene_mesh.hpp"
#include "scene/read/scene_units.hpp"
#include "scene/simulation.hpp"
#include "support/refusal.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::count;
using test::counts;
using test::expect_contains;
using test::list;
using test::number;
using test::numbers;
using test::word;

std::string box_of(int order, const std::string& more = "") {
  return list("Mesh",
              word("Type", "Box") + count("Cell Order", order) +
                  list("Box", numbers("Lower", {0, 0.28}) + numbers("Lengths", {4, 2}) + counts("Divisions", {4, 2})) +
                  more);
}

Teuchos::ParameterList scene(const std::string& mesh, const std::string& interaction = "",
                             const std::string& material = "") {
  return test::scene(mesh + list("Materials", list("Rubber", number("Density", 1) + material)) +
                     list("Interactions", list("Wall", word("Side Set", "bottom") + interaction)) +
                     test::time_integrator("Newmark", 0.1, 1));
}

std::string refusal(const Teuchos::ParameterList& scene) {
  return test::refusal([&] { Simulation(scene, test::world()); });
}

TEST(QuadraticSceneTest, TheSidesOfQuadraticCellsAreContactElements) {
  for (const std::string element : {"Q1C1", "Q2C2"}) {
    const Simulation s(scene(box_of(2), word("Contact Element", element)), test::world());
    EXPECT_EQ(s.interactions()[0].element, ContactElement::Q2C2);
    EXPECT_EQ(s.model().mesh().global_nodes, 9 * 5);
    EXPECT_EQ(s.model().mesh().global_cells, 8);
    expect_contains(explain(s), "Q2C2 contact elements");
    const std::vector<double> rest(static_cast<std::size_t>(s.model().space().local()), 0.0);
    EXPECT_NEAR(test::ReportAt(s.model(), rest.data()).interaction_report().measure, 4, 1e-13);
  }
  const Simulation rich(scene(box_of(2), word("Contact Element", "Q2C4") + count("Bulk Points", 6)), test::world());
  EXPECT_EQ(rich.interactions()[0].element, ContactElement::Q2C4);
  EXPECT_EQ(rich.model().mesh().global_nodes, 9 * 5 + 4 * 2);
  expect_contains(explain(rich), "Q2C4 contact elements");
  const Simulation linear(scene(box_of(1)), test::world());
  EXPECT_EQ(linear.interactions()[0].element, ContactElement::Q1C1);
  expect_contains(explain(linear), "Q1C1 contact elements");
}

TEST(QuadraticSceneTest, WhatDoesNotFitIsRefusedWithTheReason) {
  for (const std::string element : {"Q1C2", "Q1C4", "Q1CH"})
    expect_contains(refusal(scene(box_of(2), word("Contact Element", element))),
                    "Interactions/Wall/Contact Element: side set \"bottom\", block \"body\": Q1C2, Q1C3, Q1C4 and "
                    "Q1CH are contact elements of linear cells, and these cells are quadratic; choose Q2C2");
  for (const std::string element : {"Q2C2", "Q2C4"})
    expect_contains(refusal(scene(box_of(1), word("Contact Element", element))),
                    "Interactions/Wall/Contact Element: side set \"bottom\", block \"body\": Q2C2 and Q2C4 are contact "
                    "elements of quadratic cells, and these cells are linear; choose Q1C1");
  expect_contains(refusal(scene(box_of(2), count("Bulk Points", 4))),
                  "Interactions/Wall/Bulk Points: 4 has no effect on Q2C2");
  expect_contains(refusal(scene(box_of(2), "", word("Element Formulation", "Enhanced"))),
                  "Materials: block \"body\": quadratic cells do not lock in bending and have no Enhanced formulation");
  EXPECT_EQ(refusal(scene(box_of(2), "", word("Element Formulation", "Mean Dilatation"))), "");
  expect_contains(refusal(scene(box_of(3))), "Cell Order");
}

Mesh made(const std::string& mesh) {
  Teuchos::ParameterList complete = complete_scene(scene(mesh));
  return scene_mesh(complete.sublist("Mesh"), ".");
}

TEST(QuadraticSceneTest, TheMapMovesTheMiddleNodesAndSetsSeeThem) {
  const Mesh mesh =
      made(box_of(2, list("Map", word("Y", "y + 0.1*x*(4 - x)")) +
                         list("Sets", list("right half", word("Kind", "Nodes") + numbers("Lower", {2, -9})))));
  // Under a parabola the body has the area of the box: each column keeps its height.
  EXPECT_NEAR(mesh_quality(mesh).volume, 8, 1e-13);
  for (const int node : mesh.node_sets.at(0).nodes) EXPECT_LT(node, mesh.nodes());
  const auto found = std::find_if(mesh.node_sets.begin(), mesh.node_sets.end(),
                                  [](const NodeSet& set) { return set.name == "right half"; });
  ASSERT_NE(found, mesh.node_sets.end());
  EXPECT_EQ(found->nodes.size(), 5 * 5);
  bool is_curved = false;
  for (std::size_t k = 0; k < mesh.coordinates.size(); k += 2)
    is_curved = is_curved || (mesh.coordinates[k] == 0.5 && std::abs(mesh.coordinates[k + 1] - 0.455) < 1e-14);
  EXPECT_TRUE(is_curved) << "the middle of a side at the bottom does not follow the map";
}

TEST(QuadraticSceneTest, ADiskIsMadeByItsGenerator) {
  const Mesh mesh = made(list("Mesh", word("Type", "Disk") + count("Cell Order", 2)));
  DiskShape shape;
  shape.cell_order = 2;
  EXPECT_EQ(mesh.coordinates, disk(shape).coordinates);
}

TEST(QuadraticSceneTest, GivenMeshesMayBeQuadraticOrBecomeSo) {
  BoxShape shape;
  shape.lower = {0, 0.28, 0};
  shape.divisions = {3, 2, 1};
  Mesh mesh = box(shape);
  const Simulation raised(scene(list("Mesh", count("Cell Order", 2))), mesh, test::world());
  raise_order(mesh);
  const Simulation own(scene(list("Mesh", "")), mesh, test::world());
  for (const Simulation* s : {&raised, &own}) {
    EXPECT_EQ(s->model().mesh().global_nodes, 7 * 5);
    EXPECT_EQ(s->interactions()[0].element, ContactElement::Q2C2);
  }
  EXPECT_EQ(raised.mesh_fingerprint(), own.mesh_fingerprint());
}

}  // namespace
}  // namespace ixos
