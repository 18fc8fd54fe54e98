#include "scene/read/maxwell_branches.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "scene/explain/explanation.hpp"
#include "scene/scene_file.hpp"
#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"
#include "support/temporary_folder.hpp"
#include "test_folders.hpp"

namespace ixos {
namespace {

using test::list;
using test::number;
using test::numbers;
using test::word;

std::string body(const std::string& branches, const std::string& more = "") {
  std::string text = test::block_2d(1.0);
  return text.insert(text.find(number("Density", 1)), list("Maxwell Branches", branches) + more);
}

std::string two() { return numbers("Relaxation Times", {0.1, 3}) + numbers("Moduli", {0.5, 0.25}); }

std::string refusal(const std::string& lists, const std::string& scheme = "Average Vector Field",
                    const std::string& parameters = "") {
  return test::refusal(
      [&] { Simulation(test::scene(lists + test::time_integrator(scheme, 0.1, 1, parameters)), test::world()); });
}

TEST(MaxwellBranchesTest, AMaterialHasTheBranchesOfItsList) {
  const Simulation s(test::scene(body(two() + word("History Update", "Second Order")) +
                                 test::time_integrator("Average Vector Field", 0.1, 1)),
                     test::world());
  const Material& material = s.materials()[0];
  ASSERT_EQ(material.branches.size(), 2U);
  EXPECT_EQ(material.branches[1].time, 3);
  EXPECT_EQ(material.branches[1].modulus, 0.25);
  EXPECT_EQ(material.history_update, HistoryUpdate::SecondOrder);
  EXPECT_EQ(s.model().dissipation_names(), std::vector<std::string>{"viscoelasticity of body"});
  const Simulation plain(test::scene(test::block_2d(1.0) + test::time_integrator("Average Vector Field", 0.1, 1)),
                         test::world());
  EXPECT_TRUE(plain.materials()[0].branches.empty());
  EXPECT_FALSE(has_histories(plain.model()));
}

TEST(MaxwellBranchesTest, AFileStandsForBoth) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() + "/prony.txt") << "# tau mu\n0.1 0.5\n3 0.25\n";
  const auto scene =
      test::scene(body(word("File", "prony.txt")) + test::time_integrator("Average Vector Field", 0.1, 1));
  const Simulation s(scene, test::world(), folder.path());
  ASSERT_EQ(s.materials()[0].branches.size(), 2U);
  EXPECT_EQ(s.materials()[0].branches[0].time, 0.1);
  EXPECT_EQ(s.materials()[0].branches[1].modulus, 0.25);
  const SceneNode node(s.parameters(), "");
  const SceneNode own = node.sublist("Materials").sublists()[0].sublist("Maxwell Branches");
  EXPECT_EQ(own.text("File"), "") << "effective.xml has the numbers";
  EXPECT_EQ(own.numbers("Moduli"), (std::vector<double>{0.5, 0.25}));
}

TEST(MaxwellBranchesTest, TheSceneOfTheGuideCreeps) {
  Simulation s(read_scene_file(std::string(IXOS_TEST_DIRECTORY) + "/guide/viscoelastic.xml"), test::world());
  EXPECT_EQ(s.materials()[0].branches.size(), 2U);
  for (int step = 0; step < 10; ++step) ASSERT_TRUE(s.integrator().step(0.05).converged);
  EXPECT_GT(s.integrator().dissipated_energy(), 1e-4);
}

TEST(MaxwellBranchesTest, WhatDoesNotFitIsRefused) {
  const std::string path = "Materials/Rubber/Maxwell Branches";
  EXPECT_EQ(refusal(body(numbers("Relaxation Times", {1, 2}) + numbers("Moduli", {1}))),
            path + "/Moduli: has 1 values, and Relaxation Times has 2; each branch needs one of both");
  test::expect_contains(refusal(body(numbers("Relaxation Times", {0}) + numbers("Moduli", {1}))), "greater than 0");
  EXPECT_EQ(refusal(body(two() + word("File", "prony.txt"))),
            path + "/File: \"prony.txt\" stands beside Relaxation Times or Moduli; give one or the other");
  test::expect_contains(refusal(body(word("File", "none.txt"))), "none.txt: cannot be read");
  const std::string another = "; use another scheme, such as \"Average Vector Field\"";
  for (const char* formulation : {"Standard", "Mean Dilatation"})
    EXPECT_EQ(
        refusal(body(two(), word("Element Formulation", formulation)), "Energy-Momentum"),
        path + ": the scheme \"Energy-Momentum\" needs a discrete gradient, which branches do not have" + another);
  EXPECT_EQ(
      refusal(body(two()), "Central Difference"),
      path + ": the scheme \"Central Difference\" is explicit: its forces know no history within a step" + another);
  test::expect_contains(refusal(body(two() + word("History Update", "Second Order")), "Newmark"),
                        "takes the elastic force at the end of a stage");
  EXPECT_EQ(refusal(body(two(), word("Element Formulation", "Enhanced"))),
            path +
                ": are not there for Enhanced elements, which solve for their modes with the elastic law alone; use "
                "Standard or Mean Dilatation "
                "elements");
  const std::string ahead =
      list("Stages", list("One", numbers("Velocity", {2, -2, -1, 0}) + numbers("Acceleration", {4, -4, -4, -1}) +
                                     numbers("Elastic Points", {0.2, 1}) + numbers("Elastic Weights", {1.5, -0.5})));
  EXPECT_EQ(refusal(body(two()), "Custom", ahead),
            path +
                ": the scheme \"Custom\" takes the elastic force of stage 1 at a mean time of -0.2 times the stage; "
                "branches need one above 0 and of at most 1" +
                another);
  EXPECT_EQ(refusal(body(two(), word("Element Formulation", "Mean Dilatation"))), "");
}

}  // namespace
}  // namespace ixos
