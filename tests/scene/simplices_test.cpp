// Scenes with triangles and tetrahedra: their order, the nodes that formulations and schemes need, warnings, refusals.
#include <gtest/gtest.h>

#include <algorithm>

#include "fem/cell_info.hpp"
#include "mesh/generators/shapes.hpp"
#include "scene/explain/explanation.hpp"
#include "scene/simulation.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"
#include "support/simplices.hpp"

namespace ixos {
namespace {

using test::count;
using test::expect_contains;
using test::list;
using test::number;
using test::numbers;
using test::word;

Mesh plate() {
  BoxShape shape;
  shape.dimension = 2;
  shape.lengths = {4, 2, 1};
  shape.lower = {0, 0.28, 0};
  shape.divisions = {4, 2, 1};
  return test::split_cells(box(shape), "triangles");
}

Mesh brick() {
  BoxShape shape;
  shape.dimension = 3;
  shape.lengths = {4, 1, 1};
  shape.lower = {-2, 0, 0.28};
  shape.divisions = {4, 1, 1};
  return test::split_cells(box(shape), "hexahedra to tetrahedra");
}

Teuchos::ParameterList scene(int order, const std::string& scheme, const std::string& material = "",
                             const std::string& interaction = "", const std::string& mesh = "") {
  return test::scene(list("Mesh", count("Cell Order", order) + mesh) +
                     list("Materials", list("Rubber", number("Density", 1) + material)) +
                     list("Interactions", list("Wall", word("Side Set", "bottom") + interaction)) +
                     test::time_integrator(scheme, 0.1, 1));
}

/// The names of the types of cells, in alphabetical order.
std::string types(const Simulation& simulation) {
  std::vector<std::string> names;
  for (const LocalBlock& block : simulation.model().mesh().blocks) names.emplace_back(cell_info(block.type).name);
  std::sort(names.begin(), names.end());
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : " ") + name;
  return all;
}

TEST(SimplexSceneTest, TheNumberOfNodesFollowsFromOrderFormulationAndScheme) {
  const std::string dilatation = word("Element Formulation", "Mean Dilatation");
  const auto found = [](const Teuchos::ParameterList& own, const Mesh& mesh) {
    return types(Simulation(own, mesh, test::world()));
  };
  EXPECT_EQ(found(scene(1, "Newmark"), plate()), "Tri3");
  EXPECT_EQ(found(scene(2, "Newmark"), plate()), "Tri6");
  EXPECT_EQ(found(scene(2, "Newmark", dilatation), plate()), "Tri7");
  EXPECT_EQ(found(scene(2, "Central Difference"), plate()), "Tri7");
  EXPECT_EQ(found(scene(1, "Central Difference"), plate()), "Tri3");
  EXPECT_EQ(found(scene(1, "Newmark"), brick()), "Hex8 Pyr5 Tet4");
  EXPECT_EQ(found(scene(2, "Newmark"), brick()), "Hex27 Pyr14 Tet10");
  EXPECT_EQ(found(scene(2, "Newmark", dilatation), brick()), "Hex27 Pyr19 Tet15");
  const Simulation rich(scene(2, "Newmark", dilatation), plate(), test::world());
  expect_contains(explain(rich), "Cells: 16 Tri7 (with nodes in triangles and insides, for Mean Dilatation");
}

TEST(SimplexSceneTest, AllStagesHaveTheCellsThatOneOfThemNeeds) {
  const std::string stages =
      list("Stages", list("Load", "") + list("Release", list("Time Integrator", word("Type", "Central Difference"))));
  const Simulation simulation(
      test::scene(list("Mesh", count("Cell Order", 2)) + list("Materials", list("Rubber", number("Density", 1))) +
                  list("Interactions", list("Wall", word("Side Set", "bottom"))) +
                  test::time_integrator("Newmark", 0.1, 1) + stages),
      plate(), test::world());
  EXPECT_EQ(types(simulation), "Tri7");
}

bool warns(const Simulation& simulation, const std::string& words) {
  const auto& all = simulation.warnings();
  return std::any_of(all.begin(), all.end(),
                     [&](const Warning& warning) { return warning.message.find(words) != std::string::npos; });
}

TEST(SimplexSceneTest, LinearCellsAreWarnedOf) {
  const auto warned = [](int order) {
    return warns(Simulation(scene(order, "Newmark"), plate(), test::world()),
                 "linear Tri3 cells are too stiff in bending");
  };
  EXPECT_TRUE(warned(1));
  EXPECT_FALSE(warned(2));
}

TEST(SimplexSceneTest, StandardQuadraticTetrahedraNearOneHalfAreWarnedOf) {
  const auto warned = [](const Mesh& mesh, double ratio, const std::string& material) {
    return warns(Simulation(scene(2, "Newmark", number("Poisson's Ratio", ratio) + material), mesh, test::world()),
                 "the cells are quadratic tetrahedra of the Element Formulation \"Standard\"");
  };
  EXPECT_TRUE(warned(brick(), 0.49, ""));
  EXPECT_FALSE(warned(brick(), 0.48, ""));
  EXPECT_FALSE(warned(brick(), 0.4999, word("Element Formulation", "Mean Dilatation")));
  EXPECT_FALSE(warned(plate(), 0.4999, ""));
}

TEST(SimplexSceneTest, WhatTheyDoNotHaveIsRefused) {
  const auto refusal = [](const Teuchos::ParameterList& own, const Mesh& mesh) {
    return test::refusal([&] { Simulation(own, mesh, test::world()); });
  };
  expect_contains(refusal(scene(1, "Newmark", "", word("Contact Element", "Q1C2")), plate()),
                  "only quadrilaterals and hexahedra have enriched sides");
  expect_contains(refusal(scene(2, "Newmark", "", word("Contact Element", "Q2C4")), plate()),
                  "only quadrilaterals and hexahedra have enriched sides");
  expect_contains(refusal(scene(1, "Newmark", "", "",
                                list("Refine", list("Low", numbers("Upper", {9, 0.5}) + word("Directions", "x")))),
                          plate()),
                  "Mesh/Refine/Low: triangles and tetrahedra have no axes; leave Directions out");
  expect_contains(
      refusal(scene(1, "Newmark", word("Element Formulation", "Mean Dilatation")), plate()),
      "the strain of Tri3 cells is constant, so that Mean Dilatation does not change them; use Cell Order 2");
  expect_contains(refusal(scene(2, "Newmark", word("Element Formulation", "Enhanced")), plate()),
                  "quadratic cells do not lock in bending");
}

}  // namespace
}  // namespace ixos
