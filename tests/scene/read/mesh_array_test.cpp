#include "scene/read/mesh_array.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "mesh/selection.hpp"
#include "scene/read/parameters.hpp"
#include "scene/read/scene_mesh.hpp"
#include "scene/read/scene_units.hpp"
#include "scene/simulation.hpp"
#include "support/refusal.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"

namespace ixos::test {
namespace {

/// A pillar of 1 x 1 x 2, or 1 x 2, whose underside is a little above the wall.
std::string pillar(int dimension, const std::string& more) {
  const bool solid = dimension == 3;
  return list("pillar",
              word("Type", "Box") +
                  list("Box", count("Dimension", dimension) +
                                  numbers("Lower", solid ? std::vector<double>{-0.5, -0.5, 0.3}
                                                         : std::vector<double>{-0.5, 0.3}) +
                                  numbers("Lengths", solid ? std::vector<double>{1, 1, 2} : std::vector<double>{1, 2}) +
                                  counts("Divisions", solid ? std::vector<int>{2, 2, 4} : std::vector<int>{2, 4})) +
                  more);
}

std::string grid(int dimension, const std::vector<int>& many, double spacing = 3) {
  return word("Layout", "Grid") +
         list("Grid", counts("Counts", many) +
                          numbers("Spacing", std::vector<double>(static_cast<std::size_t>(dimension - 1), spacing)));
}

std::string array(int dimension, const std::string& more) {
  return list("Mesh", word("Type", "Array") + list("Array", pillar(dimension, more)));
}

std::string pressed() {
  return list("Materials", list("Rubber", word("Block", "pillar_body") + number("Density", 1.0))) +
         list("Interactions", list("Wall", word("Side Set", "pillar_*bottom"))) +
         list("Boundary Conditions", list("Top", word("Node Set", "pillar_top"))) +
         list("Output", texts("Reactions", "{pillar_*top}")) + time_integrator("Energy-Momentum", 0.05, 0.5);
}

/// Copies that do not feel each other do what one alone does.
TEST(MeshArrayTest, CopiesMoveAsOneDoes) {
  for (const int dimension : {2, 3}) {
    const std::vector<int> many = dimension == 3 ? std::vector<int>{2, 3} : std::vector<int>{6};
    Simulation one(scene(array(dimension, "") + pressed()), world());
    Simulation six(scene(array(dimension, grid(dimension, many)) + pressed()), world());
    EXPECT_EQ(one.output().reactions, std::vector<std::string>{"pillar_top"});
    EXPECT_EQ(six.output().reactions.size(), 7U) << "of all, and of each";
    EXPECT_EQ(six.output().reactions.back(), "pillar_6_top");
    for (int step = 0; step < 10; ++step) {
      ASSERT_TRUE(one.integrator().step(0.05).converged);
      ASSERT_TRUE(six.integrator().step(0.05).converged);
    }
    const StateReport a = report_of(one), b = report_of(six);
    EXPECT_GT(a.elastic_energy(), 1e-6);
    EXPECT_NEAR(b.elastic_energy(), 6 * a.elastic_energy(), 1e-11 * b.elastic_energy());
    EXPECT_NEAR(b.momenta().kinetic_energy, 6 * a.momenta().kinetic_energy, 1e-11);
    EXPECT_NEAR(b.energy(Part::Interaction), 6 * a.energy(Part::Interaction), 1e-11);
  }
}

Mesh mesh_of(const std::string& text) {
  Teuchos::ParameterList lists = complete_scene(scene(text + pressed()));
  return scene_mesh(lists.sublist("Mesh"), ".", false, {});
}

/// The mean of the nodes of a copy.
Vec<3> middle(const Mesh& mesh, int copy) {
  const NodeSet& set = *find_set(mesh.node_sets, "pillar_" + std::to_string(copy) + "_surface");
  Vec<3> sum{};
  for (const int node : set.nodes)
    for (std::size_t i = 0; i < static_cast<std::size_t>(mesh.dimension); ++i)
      sum[i] +=
          mesh.coordinates[static_cast<std::size_t>(node * mesh.dimension) + i] / static_cast<double>(set.nodes.size());
  return sum;
}

TEST(MeshArrayTest, CopiesStandWhereTheLayoutSays) {
  const Mesh staggered =
      mesh_of(array(3, word("Layout", "Grid") + list("Grid", counts("Counts", {3, 2}) + numbers("Spacing", {2, 4}) +
                                                                 number("Stagger", 0.5))));
  for (int k = 0; k < 6; ++k) {
    EXPECT_NEAR(middle(staggered, k + 1)[0], 2 * (k % 3 - 1) + (k < 3 ? 0 : 1), 1e-14);
    EXPECT_NEAR(middle(staggered, k + 1)[1], k < 3 ? -2 : 2, 1e-14);
    EXPECT_NEAR(middle(staggered, k + 1)[2], 1.3, 1e-14);
  }
  const Mesh ring = mesh_of(array(3, word("Layout", "Ring") + list("Ring", count("Count", 5) + number("Radius", 4))));
  for (int k = 0; k < 5; ++k) {
    EXPECT_NEAR(middle(ring, k + 1)[0], 4 * std::cos(2 * M_PI * k / 5), 1e-14);
    EXPECT_NEAR(middle(ring, k + 1)[1], 4 * std::sin(2 * M_PI * k / 5), 1e-14);
  }
  const Mesh table = mesh_of(array(
      2, word("Layout", "Table") +
             list("Table", numbers("Places", {0, 1, 7, 2}) + numbers("Scales", {1, 2}) + numbers("Angles", {0, 90}))));
  EXPECT_NEAR(middle(table, 2)[0], 7 - 2 * 1.3, 1e-14) << "its middle was at (0, 1.3)";
  EXPECT_NEAR(middle(table, 2)[1], 2, 1e-14);
}

/// The disorder of a copy depends on seed and number, not on where it stands or how many there are.
TEST(MeshArrayTest, DisorderBelongsToTheCopy) {
  const auto disorder = [](int seed, const std::string& more = "") {
    return list("Disorder", count("Seed", seed) + numbers("Place", {0.2, 0.1, 0.05}) + number("Inclination", 5) +
                                number("Angle", 10) + number("Scale", 0.1) + more);
  };
  const Mesh few = mesh_of(array(3, grid(3, {2, 2}) + disorder(3))),
             many = mesh_of(array(3, grid(3, {5, 2}) + disorder(3))),
             other = mesh_of(array(3, grid(3, {2, 2}) + disorder(4)));
  std::set<double> heights;
  for (int k = 1; k <= 4; ++k) {
    const double x_few = 3 * ((k - 1) % 2 - 0.5), x_many = 3 * ((k - 1) % 5 - 2.0);
    EXPECT_NEAR(middle(few, k)[0] - x_few, middle(many, k)[0] - x_many, 1e-13);
    EXPECT_NEAR(middle(few, k)[2], middle(many, k)[2], 1e-13);
    EXPECT_GT(std::abs(middle(few, k)[2] - middle(other, k)[2]), 1e-6);
    EXPECT_LT(std::abs(middle(few, k)[2] - 1.3), 0.05 + 0.1 * 1.3 + 0.01);
    heights.insert(middle(few, k)[2]);
  }
  EXPECT_EQ(heights.size(), 4U) << "each is another one";
  // A parameter of the generator: all three lengths of each copy.
  const Mesh sizes =
      mesh_of(array(3, grid(3, {2, 2}) + list("Disorder", list("Parameters", list("Box", number("Lengths", 0.2))))));
  std::set<double> tops;
  for (int k = 1; k <= 4; ++k) tops.insert(middle(sizes, k)[2]);
  EXPECT_EQ(tops.size(), 4U);
}

TEST(MeshArrayTest, WhatCannotBeIsRefusedWithTheNumberOfTheCopy) {
  const auto refused = [](const std::string& more, const std::string& words, int dimension = 3) {
    expect_contains(refusal([&] { mesh_of(array(dimension, more)); }), words);
  };
  refused(grid(3, {2, 2}, 0.9), "Mesh/Array/pillar: the copies 1 and 2 (seed 1) overlap at (");
  refused(grid(3, {2}), "Mesh/Array/pillar/Grid/Counts: it has 1 numbers; a mesh of 3 dimensions takes 2");
  refused(word("Layout", "Table") + list("Table", numbers("Places", {1, 2})), "it has 2 numbers; give 3 for each copy");
  refused(grid(3, {2, 2}) + list("Disorder", list("Parameters", list("Box", number("Length", 0.2)))),
          "Mesh/Array/pillar/Disorder/Parameters/Box/Length: the part has no real number of that name");
  refused(grid(3, {4, 4}) + list("Disorder", count("Seed", 5) + list("Parameters", list("Box", number("Lengths", 4)))),
          "(seed 5) cannot be made: Mesh/Array/pillar/Box");
  refused(grid(2, {2}) + list("Disorder", number("Inclination", 2)), "a part of two dimensions turns about z alone", 2);
  const std::string backing =
      list("Mesh",
           word("Type", "Array") +
               list("Array", pillar(2, grid(2, {2})) +
                                 list("backing", word("Type", "Box") + list("Box", numbers("Lower", {-3, 2.0}) +
                                                                                       numbers("Lengths", {6, 1})))));
  expect_contains(refusal([&] { mesh_of(backing); }), "the parts \"pillar\" and \"backing\" overlap at (");
  refused(list("Disorder", number("Scale", 0.1)), "a part of the Layout Once has no copies that could differ");
  refused(grid(3, {30000, 30000}), "copies of 45 nodes have more than 1e9 nodes together");
  refused(grid(3, {2, 2}) + list("Disorder", list("Parameters", list("Grid", number("Spacing", 0.1)))),
          "copies can differ in the numbers of generators alone");
}

/// Copies that are inclined about their roots hang on a backing of elastic cells.
TEST(MeshArrayTest, InclinedCopiesHangOnABacking) {
  const std::string tied = list(
      "Mesh",
      word("Type", "Array") +
          list("Array", pillar(2, numbers("Point", {0, 2.3}) + grid(2, {3}, 2) + list("Disorder", number("Angle", 2))) +
                            list("backing", word("Type", "Box") +
                                                list("Box", numbers("Lower", {-4, 2.3}) + numbers("Lengths", {8, 1}) +
                                                                counts("Divisions", {16, 2})))) +
          list("Ties", list("Roots", word("Side Set", "pillar_top") + word("Primary Side Set", "backing_bottom"))));
  Simulation s(scene(tied +
                     list("Materials", list("Pillars", word("Block", "pillar_body")) +
                                           list("Backing", word("Block", "backing_body"))) +
                     list("Interactions", list("Wall", word("Side Set", "pillar_bottom"))) +
                     list("Boundary Conditions", list("Top", word("Node Set", "backing_top"))) +
                     time_integrator("Static", 0.1, 0.2)),
               world());
  EXPECT_FALSE(s.model().mesh().ties.empty() && world()->getSize() == 1);
  ASSERT_TRUE(s.integrator().step(0.1).converged);
}

TEST(MeshArrayTest, PatternsChooseWhereCellsAreSplit) {
  const auto cells = [](const std::string& set) {
    return mesh_of(list("Mesh", word("Type", "Array") + list("Array", pillar(2, grid(2, {12}))) +
                                    list("Refine", list("Feet", word("Side Set", set)))))
        .cells();
  };
  const int none = 12 * 8, foot = 2 * 3;  // two cells become eight
  EXPECT_EQ(cells("pillar_bottom"), none + 12 * foot);
  EXPECT_EQ(cells("pillar_*_bottom"), none + 12 * foot);
  EXPECT_EQ(cells("pillar_1*_bottom"), none + 4 * foot) << "1, 10, 11 and 12";
  expect_contains(refusal([&] { cells("pillar_*_sole"); }), "pillar_*_sole");
}

/// An amount does not change the numbers of another one.
TEST(MeshArrayTest, EachParameterHasItsOwnNumbers) {
  const auto heights = [](const std::string& more) {
    const Mesh mesh = mesh_of(
        array(3, grid(3, {2, 2}) + list("Disorder", list("Parameters", list("Box", number("Lengths", 0.1) + more)))));
    return std::vector<double>{middle(mesh, 1)[2], middle(mesh, 2)[2], middle(mesh, 4)[2]};
  };
  const std::vector<double> alone = heights(""), both = heights(number("Lower", 0.0));
  EXPECT_EQ(alone, both);
}

}  // namespace
}  // namespace ixos::test
