// Runs whose mesh of triangles or tetrahedra follows the front.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "fem/cell_info.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/generators/shapes.hpp"
#include "run/mesh_follower.hpp"
#include "run/peeled_strip.hpp"
#include "run/restart_fixture.hpp"
#include "support/refusal.hpp"
#include "support/simplices.hpp"

namespace ixos::test {
namespace {

class MeshFollowerSimplicesTest : public RestartTest {
 protected:
  HistoryTable table(const std::string& name) const { return HistoryTable(folder(name) + "/history.csv"); }

  void use(const std::string& cells, const std::vector<double>& lengths, const std::vector<int>& divisions) {
    BoxShape shape;
    shape.dimension = static_cast<int>(lengths.size());
    std::copy(lengths.begin(), lengths.end(), shape.lengths.begin());
    std::copy(divisions.begin(), divisions.end(), shape.divisions.begin());
    shape.lower[0] = -lengths[0] / 2;  // kinds change at x = 0
    mesh_ = split_cells(box(shape), cells);
    for (std::size_t k = 0; k < mesh_->coordinates.size(); k += lengths.size()) mesh_->coordinates[k] += lengths[0] / 2;
  }
  void use_strip(const std::string& cells) { use(cells, {12, 0.5}, {12, 1}); }
};

const std::string quadratic = count("Cell Order", 2);

TEST_F(MeshFollowerSimplicesTest, TheBalanceStaysClosedAndRestartsGoOnBitForBit) {
  for (const std::string& cells : {std::string("triangles"), std::string("quads and triangles")})
    for (const std::string& order : {std::string(), quadratic}) {
      SCOPED_TRACE(cells + (order.empty() ? "" : ", quadratic"));
      use_strip(cells);
      const std::string output = checkpoints(7, 100) + count("Fields Interval", 5);
      const RunResult whole = expect_goes_on(strip("Average Vector Field", order + adapt(2), 0.05, 3, output), {7, 28});
      EXPECT_GT(whole.mesh_changes.count, 3);
      EXPECT_GT(whole.mesh_changes.count, whole.mesh_changes.repeated);
      world()->barrier();
      expect_closed(table("whole"), whole.largest_energy);
    }
}

TEST_F(MeshFollowerSimplicesTest, AllSchemesGoOn) {
  use_strip("triangles");
  for (const char* scheme :
       {"Newmark", "Bathe Composite", "Gautam-Sauer Composite", "Energy-Momentum", "Generalized-Alpha", "Static"}) {
    SCOPED_TRACE(scheme);
    const RunResult whole = expect_goes_on(strip(scheme, quadratic + adapt(2), 0.05, 1, checkpoints(7, 100)), {7, 14});
    EXPECT_GT(whole.mesh_changes.count, 1);
  }
}

// Cells with bubbles: for Mean Dilatation, and for the lumped mass of Central Difference.
TEST_F(MeshFollowerSimplicesTest, CellsWithBubblesFollow) {
  use_strip("triangles");
  const std::string soft = word("Element Formulation", "Mean Dilatation") + number("Poisson's Ratio", 0.49);
  const RunResult whole = expect_goes_on(
      strip("Average Vector Field", quadratic + adapt(2), 0.05, 1, checkpoints(7, 100), "Q1C1", soft), {14});
  EXPECT_GT(whole.mesh_changes.count, 1);
  world()->barrier();
  expect_closed(table("whole"), whole.largest_energy);
  const RunResult explicit_run = run_scene(strip("Central Difference", quadratic + adapt(1), 2e-4, 0.6), "explicit");
  EXPECT_EQ(explicit_run.status, RunStatus::Completed) << explicit_run.reason;
  EXPECT_GT(explicit_run.mesh_changes.count, 0);
}

TEST_F(MeshFollowerSimplicesTest, WhatPointsKeepGoesAlong) {
  use_strip("triangles");
  const std::string output = checkpoints(7, 100) + count("Fields Interval", 5);
  const RunResult whole = expect_goes_on(
      strip("Average Vector Field", quadratic + adapt(2), 0.05, 3, output, "Q1C1", branches, friction), {7, 28});
  EXPECT_GT(whole.mesh_changes.count, 3);
  world()->barrier();
  const HistoryTable rows = table("whole");
  EXPECT_GT(rows.column("dissipated_energy").back(), 1e-6 * whole.largest_energy);
  expect_closed(rows, whole.largest_energy);
}

// The adaptive run has the force of the mesh that is fine everywhere, with a part of its unknowns.
TEST_F(MeshFollowerSimplicesTest, TheForceIsThatOfTheFineMesh) {
  use_strip("triangles");
  const std::string everywhere = list("Refine", list("All", count("Levels", 2) + numbers("Upper", {100, 100})));
  const RunResult fine = run_scene(strip("Newmark", quadratic + everywhere, 0.05, 3), "fine"),
                  coarse = run_scene(strip("Newmark", quadratic, 0.05, 3), "coarse"),
                  follows =
                      run_scene(strip("Newmark", quadratic + adapt(2, number("Part", 0.125)), 0.05, 3), "follows");
  world()->barrier();
  expect_force_of_fine_mesh(table("fine"), table("coarse"), table("follows"), 4);
  EXPECT_LT(follows.mesh_changes.unknowns, 0.6 * 1746 * static_cast<double>(follows.steps));
}

// Nodes turned within cells, other numbers of nodes, and the mirror image: the mesh changes alike.
TEST_F(MeshFollowerSimplicesTest, NumbersAndMirrorsPlayNoPart) {
  const std::string scene = strip("Average Vector Field", quadratic + adapt(2), 0.05, 1.5);
  const auto force = [&](const std::string& name) {
    const RunResult result = run_scene(scene, name);
    EXPECT_GT(result.mesh_changes.count, 2);
    world()->barrier();
    return table(name).column("reaction_right_y");
  };
  use_strip("triangles");
  const Mesh plain = *mesh_;
  const std::vector<double> expected = force("plain");
  const auto expect_same_force = [&](const std::string& name) {
    const double size = squared_distance(expected, std::vector<double>(expected.size(), 0.0));
    EXPECT_LT(std::sqrt(squared_distance(force(name), expected) / size), 1e-11) << name;
  };
  std::vector<int>& nodes = mesh_->blocks[0].nodes;
  for (std::size_t cell = 0; cell + 2 < nodes.size(); cell += 6)  // every other cell
    std::rotate(&nodes[cell], &nodes[cell + 1], &nodes[cell] + 3);
  mesh_->side_sets.clear();
  for (const SideSet& set : plain.side_sets) {
    mesh_->side_sets.push_back(set);
    for (Side& side : mesh_->side_sets.back().sides)
      if (side.cell % 2 == 0) side.side = (side.side + 2) % 3;
  }
  expect_same_force("turned");
  *mesh_ = plain;
  const int last = plain.nodes() - 1;
  for (int node = 0; node <= last; ++node)
    std::copy_n(&plain.coordinates[static_cast<std::size_t>(2 * node)], 2,
                &mesh_->coordinates[static_cast<std::size_t>(2 * (last - node))]);
  for (int& node : mesh_->blocks[0].nodes) node = last - node;
  for (NodeSet& set : mesh_->node_sets)
    for (int& node : set.nodes) node = last - node;
  expect_same_force("renumbered");
  *mesh_ = plain;
  for (std::size_t k = 0; k < plain.coordinates.size(); k += 2) mesh_->coordinates[k] = 12 - plain.coordinates[k];
  for (std::size_t cell = 0; cell < nodes.size(); cell += 3) std::swap(nodes[cell + 1], nodes[cell + 2]);
  for (SideSet& set : mesh_->side_sets)
    for (Side& side : set.sides) side.side = 2 - side.side;
  expect_same_force("mirrored");
}

// Tetrahedra, alone and beside hexahedra and pyramids.
TEST_F(MeshFollowerSimplicesTest, BodiesInSpaceFollow) {
  for (const std::string& cells : {std::string("tetrahedra"), std::string("hexahedra to tetrahedra")})
    for (const std::string& order : {std::string(), quadratic}) {
      SCOPED_TRACE(cells + (order.empty() ? "" : ", quadratic"));
      use(cells, {4, 2, 0.6}, {cells == "tetrahedra" ? 4 : 8, 2, 1});
      const std::string scene =
          list("Mesh", order + adapt(1, number("Part", 0.02))) +
          list("Materials", list("Rubber", number("Density", 0.1))) +
          list("Interactions", list("Wall", word("Side Set", "bottom") + numbers("Point", {0, 0, -0.6368}) +
                                                number("Gamma L", 1) + number("Gamma W", 10))) +
          list("Histories",
               list("Up", word("Type", "Ramp") + list("Ramp", number("Value", 0.6) + number("Length", 1)))) +
          list("Boundary Conditions",
               list("Pull", word("Node Set", "top") + word("Components", "z") + word("History", "Up")) +
                   list("Clamp", word("Node Set", "top") + word("Components", "xy"))) +
          list("Output", checkpoints(4, 100)) +
          list("Time Integrator", word("Type", "Average Vector Field") + steps(0.05, 0.6));
      const RunResult whole = expect_goes_on(scene, {8});
      EXPECT_GT(whole.mesh_changes.count, 0);
      world()->barrier();
      expect_closed(table("whole"), whole.largest_energy);
    }
}

TEST_F(MeshFollowerSimplicesTest, DirectionsAreRefused) {
  use_strip("triangles");
  EXPECT_EQ(test::refusal([&] { run_scene(strip("Newmark", adapt(2, word("Directions", "x")), 0.05, 1), "refused"); }),
            "Mesh/Adapt/Directions: triangles and tetrahedra have no axes; choose \"all\"");
}

}  // namespace
}  // namespace ixos::test
