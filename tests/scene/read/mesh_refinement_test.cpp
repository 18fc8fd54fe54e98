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
  test::expect_contains(refusal(list("Foot", numbers("Lower", {90, 90}))),
                        "no cell of the mesh meets the region; the mesh spans (0, 0) to (4, 2)");
  test::expect_contains(refusal(list("Foot", numbers("Lower", {2, 0}) + numbers("Upper", {1, 1}))),
                        "Mesh/Refine/Foot: Lower 2 is above Upper 1 along x");
  test::expect_contains(refusal(list("Foot", count("Levels", 31) + numbers("Lower", {0, 0}))), "Mesh/Refine/Foot");
  test::expect_contains(refusal(list("Foot", word("Directions", "z") + numbers("Lower", {0, 0}))), "is no axis");
}

TEST(MeshRefinementTest, TiesNameTheirListInRefusals) {
  const auto refusal = [](const std::string& ties) {
    return test::refusal([&] { made(list("Corner", numbers("Upper", {0.5, 0.5})), ties); });
  };
  const auto periodic = [](const std::string& name, const std::string& side, const std::string& other) {
    return list(name, word("Side Set", side) + word("Primary Side Set", other));
  };
  test::expect_contains(refusal(list("Periodic", list("P", word("Side Set", "left")))),
                        "Mesh/Periodic/P/Primary Side Set is missing");
  test::expect_contains(refusal(list("Ties", list("T", word("Primary Side Set", "left")))),
                        "Mesh/Ties/T/Side Set is missing");
  const std::string loop = list("Periodic", periodic("There", "left", "right") + periodic("Back", "right", "left"));
  test::expect_contains(test::refusal([&] {
                          made(list("All", numbers("Lower", {0, 0})), loop);
                        }),
                        "Mesh/Periodic/Back: node ");
}

TEST(MeshRefinementTest, HermiteSidesNeedNoCoarseMeshElsewhere) {
  const auto with = [](const std::string& refine) {
    return std::make_unique<Simulation>(
        test::scene(scene(refine, list("Map", word("Y", "y + 1"))) +
                    list("Interactions", list("Wall", word("Side Set", "bottom") + word("Contact Element", "Q1CH")))),
        test::world());
  };
  EXPECT_NO_THROW(with(list("Top", numbers("Lower", {3.5, 1.9}))));
  test::expect_contains(test::refusal([&] {
                          with(list("Foot", numbers("Upper", {0.5, 0.1})));
                        }),
                        "which hanging nodes interrupt");
}

}  // namespace
}  // namespace ixos
