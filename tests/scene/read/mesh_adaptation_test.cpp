// The list "Mesh/Adapt": settings, and scenes that a mesh which changes cannot have.
#include "scene/read/mesh_adaptation.hpp"

#include <gtest/gtest.h>

#include "mesh/generators/shapes.hpp"
#include "scene/simulation.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"
#include "support/simplices.hpp"

namespace ixos {
namespace {

using test::count;
using test::list;
using test::number;
using test::numbers;
using test::word;

std::string block(const std::string& adapt, const std::string& wall, const std::string& material = "",
                  const std::string& mesh = "") {
  return list("Mesh", word("Type", "Box") + list("Adapt", adapt) + mesh) +
         list("Materials", list("Rubber", number("Density", 1) + material)) +
         (wall.empty()
              ? ""
              : list("Interactions", list("Wall", word("Side Set", "bottom") + numbers("Point", {0, -2}) + wall))) +
         test::time_integrator("Newmark", 0.1, 1);
}

std::string refusal(const std::string& scene) {
  return test::refusal([&] { Simulation(test::scene(scene), test::world()); });
}

TEST(MeshAdaptationTest, SettingsAreRead) {
  const Simulation off(test::scene(block("", " ")), test::world());
  EXPECT_FALSE(off.adaptation().on());
  EXPECT_THROW(off.split_mesh(), std::logic_error);
  const Simulation on(test::scene(block(count("Levels", 3) + number("Part", 0.1) + word("Directions", "x"), " ")),
                      test::world());
  EXPECT_EQ(on.adaptation().levels, 3);
  EXPECT_EQ(on.adaptation().part, 0.1);
  EXPECT_EQ(on.adaptation().directions, "x");
  EXPECT_EQ(on.split_mesh().tree().splits().size(), 0U);
}

TEST(MeshAdaptationTest, WhatDoesNotGoOnIsRefused) {
  const std::string on = count("Levels", 2);
  const auto expect = [&](const std::string& scene, const std::string& words) {
    test::expect_contains(refusal(scene), "Mesh/Adapt: ");
    test::expect_contains(refusal(scene), words);
  };
  expect(block(on, ""), "nothing tells where cells are split");
  expect(block(on, word("Contact Element", "Q1CH")), "choose Q1C4");
  EXPECT_NE(refusal(block(count("Levels", 13), " ")), "");
  EXPECT_EQ(refusal(block(on + number("Strain", 0.1), "")), "");
}

/// Two blocks, one above the other.
std::string two_blocks(int dimension, const std::string& pair, const std::string& mesh = "") {
  const auto part = [&](const char* name, double lower) {
    std::vector<double> corner(static_cast<std::size_t>(dimension), 0.0);
    corner.back() = lower;
    const std::vector<double> lengths(corner.size(), 2.0);
    const std::vector<int> divisions(corner.size(), 2);
    return list(name, word("Type", "Box") +
                          list("Box", count("Dimension", dimension) + numbers("Lower", corner) +
                                          numbers("Lengths", lengths) + test::counts("Divisions", divisions)));
  };
  const auto rubber = [](const char* block) { return list(block, word("Block", block) + number("Density", 1)); };
  return list("Mesh", word("Type", "Parts") + list("Parts", part("one", 0) + part("two", 3)) +
                          list("Adapt", count("Levels", 2)) + mesh) +
         list("Materials", rubber("one_body") + rubber("two_body")) + list("Interactions", list("Bond", pair)) +
         test::time_integrator("Newmark", 0.1, 1);
}

TEST(MeshAdaptationTest, PairsInSpaceNeedSurfacesThatClose) {
  const std::string between = word("Side Set", "one_top") + word("Primary Side Set", "two_bottom"),
                    in_space = word("Side Set", "one_top") + word("Primary Side Set", "two_bottom");
  EXPECT_EQ(refusal(two_blocks(2, between)), "");
  test::expect_contains(refusal(two_blocks(3, in_space)), "Interactions/Bond/Smoothing: curved patches do not close");
  EXPECT_EQ(refusal(two_blocks(3, in_space + word("Smoothing", "None"))), "");
  EXPECT_EQ(refusal(two_blocks(3, in_space, count("Cell Order", 2))), "");
  test::expect_contains(refusal(two_blocks(2, between + word("Passes", "Double Integral"))), "choose \"Two\"");
  test::expect_contains(refusal(two_blocks(2, word("Side Set", "one_top") + word("Primary Side Set", "one_top") +
                                                  number("Exclusion", 1) + number("Cutoff", 0.5))),
                        "a surface that interacts with itself");
}

TEST(MeshAdaptationTest, PrismsAloneAreRefused) {
  Mesh prism;
  prism.dimension = 3;
  prism.coordinates = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1};
  prism.blocks = {{"body", CellType::Prism6, {0, 1, 2, 3, 4, 5}}};
  const std::string scene = list("Mesh", list("Adapt", count("Levels", 1) + number("Strain", 0.1))) +
                            list("Materials", list("Rubber", number("Density", 1))) +
                            test::time_integrator("Newmark", 0.1, 1);
  test::expect_contains(test::refusal([&] { Simulation(test::scene(scene), prism, test::world()); }),
                        "prisms and pyramids are not refined");
}

// Points of friction between surfaces of triangles do not move to another mesh yet.
TEST(MeshAdaptationTest, FrictionOfPairsOfTrianglesIsRefused) {
  const auto block = [](double lower) {
    BoxShape shape;
    shape.dimension = 3;
    shape.lower[2] = lower;
    shape.divisions = {1, 1, 1};
    return test::split_cells(box(shape), "tetrahedra");
  };
  const Mesh upper = block(0.3);
  Mesh both = block(-1);
  both.blocks[0].name = "lower";
  for (SideSet& set : both.side_sets) set.name = "lower_" + set.name;
  both.node_sets.clear();
  const int nodes = both.nodes();
  both.coordinates.insert(both.coordinates.end(), upper.coordinates.begin(), upper.coordinates.end());
  both.blocks.push_back(upper.blocks[0]);
  for (int& node : both.blocks.back().nodes) node += nodes;
  for (SideSet set : upper.side_sets) {
    for (Side& side : set.sides) ++side.block;
    both.side_sets.push_back(set);
  }
  const auto scene = [](const std::string& pair) {
    return list("Mesh", list("Adapt", count("Levels", 1))) +
           list("Materials", list("A", word("Block", "lower") + number("Density", 1)) +
                                 list("B", word("Block", "body") + number("Density", 1))) +
           list("Interactions", list("Pair", word("Side Set", "bottom") + word("Primary Side Set", "lower_top") +
                                                 number("Cutoff", 0.8) + word("Smoothing", "None") + pair)) +
           test::time_integrator("Newmark", 0.1, 1);
  };
  const auto refused = [&](const std::string& pair) {
    return test::refusal([&] { Simulation(test::scene(scene(pair)), both, test::world()); });
  };
  EXPECT_EQ(refused(""), "");
  test::expect_contains(refused(list("Friction", word("Type", "Extended Amontons") + number("Coefficient", 0.3))),
                        "Interactions/Pair/Friction: what slides on triangles does not go to another mesh");
}

}  // namespace
}  // namespace ixos
