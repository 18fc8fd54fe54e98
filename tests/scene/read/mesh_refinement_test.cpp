#include "scene/read/mesh_refinement.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "scene/simulation.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::count;
using test::list;
using test::number;
using test::numbers;
using test::word;

std::string rest() {
  return list("Materials", list("Rubber", number("Density", 1))) +
         list("Time Integrator", list("Time Step Control", number("Time Step", 1) + number("Final Time", 1)));
}

std::string scene(const std::string& refine, const std::string& more = "") {
  return list("Mesh", word("Type", "Box") +
                          list("Box", numbers("Lengths", {4, 2}) + test::counts("Divisions", {4, 2})) +
                          list("Refine", refine) + more) +
         rest();
}

std::unique_ptr<Simulation> made(const std::string& refine, const std::string& more = "") {
  return std::make_unique<Simulation>(test::scene(scene(refine, more)), test::world());
}

TEST(MeshRefinementTest, ListsNameRegionsThatAreSplitTogether) {
  const std::string corner = list("Corner", numbers("Upper", {0.5, 0.5}));
  EXPECT_EQ(made(corner)->model().mesh().global_cells, 8 + 3);
  EXPECT_EQ(made(list("Row", word("Side Set", "top") + word("Directions", "x")))->model().mesh().global_cells, 8 + 4);
  EXPECT_EQ(made(corner + list("Ball", number("Sphere Radius", 0.1) + numbers("Sphere Center", {3.5, 1.5})))
                ->model()
                .mesh()
                .global_cells,
            8 + 3 + 3);
}

TEST(MeshRefinementTest, TheMapMovesTheRefinedMesh) {
  const auto mapped = made(list("All", numbers("Lower", {0, 0})), list("Map", word("Y", "y + 0.1*x^2")));
  const auto fine = std::make_unique<Simulation>(
      test::scene(list("Mesh", word("Type", "Box") +
                                   list("Box", numbers("Lengths", {4, 2}) + test::counts("Divisions", {8, 4})) +
                                   list("Map", word("Y", "y + 0.1*x^2"))) +
                  rest()),
      test::world());
  EXPECT_EQ(mapped->model().mesh().global_nodes, fine->model().mesh().global_nodes);
  EXPECT_NEAR(*std::max_element(mapped->model().mesh().coordinates.begin(), mapped->model().mesh().coordinates.end()),
              *std::max_element(fine->model().mesh().coordinates.begin(), fine->model().mesh().coordinates.end()),
              1e-12);
}

TEST(MeshRefinementTest, WhatCannotBeIsRefusedWithTheListAndTheValue) {
  const auto refusal = [](const std::string& refine) { return test::refusal([&] { made(refine); }); };
  test::expect_contains(refusal(list("Foot", count("Levels", 1))), "Mesh/Refine/Foot: nothing tells where");
  test::expect_contains(refusal(list("Foot", word("Side Set", "botom"))), "Mesh/Refine/Foot: ");
  test::expect_contains(refusal(list("Foot", numbers("Lower", {90, 90}))), "no cell of the mesh meets the region");
  test::expect_contains(refusal(list("Foot", count("Levels", 31) + numbers("Lower", {0, 0}))), "Mesh/Refine/Foot");
  test::expect_contains(refusal(list("Foot", word("Directions", "z") + numbers("Lower", {0, 0}))), "is no axis");
}

}  // namespace
}  // namespace ixos
