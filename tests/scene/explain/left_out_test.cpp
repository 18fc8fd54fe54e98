// Scenes and what they leave out, as --explain says it.
#include "scene/explain/left_out.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "support/bodies.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::list;
using test::numbers;
using test::word;

/// Returns the names before the colons, in their order.
std::vector<std::string> absent(const std::string& scene) {
  std::istringstream text(left_out(Simulation(test::scene(scene), test::world())));
  std::vector<std::string> names;
  std::string line;
  std::getline(text, line);
  EXPECT_EQ(line, "Left out, at no cost:");
  while (std::getline(text, line)) {
    EXPECT_EQ(line.rfind("  ", 0), 0U) << line;
    names.push_back(line.substr(2, line.find(": ") - 2));
    EXPECT_LT(line.find(": ") + 10, line.size()) << "no meaning: " << line;
  }
  return names;
}

TEST(LeftOutTest, AFreeBodyLacksAlmostEverything) {
  EXPECT_EQ(absent(test::block_2d(0.1) + test::time_integrator("Midpoint", 0.1, 1)),
            (std::vector<std::string>{"interaction", "damping", "viscosity", "prescribed motion", "loads",
                                      "a second body", "fields.e"}));
}

TEST(LeftOutTest, ASceneOfOneBodyHasNoSecondOne) {
  const auto all = [](const std::string& friction) {
    return list("Mesh", word("Type", "Box")) +
           list("Materials", list("Rubber", test::number("Mass Damping", 0.1) + test::number("Viscosity", 0.1))) +
           list("Interactions", list("Wall", word("Side Set", "bottom") + numbers("Point", {0, -0.5}) + friction)) +
           list("Boundary Conditions",
                list("Grip", word("Node Set", "left")) +
                    list("Pull", word("Type", "Traction") + word("Side Set", "right") + numbers("Vector", {0.01, 0}))) +
           list("Output", test::count("Fields Interval", 1)) + test::time_integrator("Newmark", 0.1, 1);
  };
  EXPECT_EQ(absent(all("")), (std::vector<std::string>{"friction", "a second body"}));
  const std::string rough = list("Friction", word("Type", "Constant Stress") + test::number("Stress", 0.1));
  EXPECT_EQ(absent(all(rough)), (std::vector<std::string>{"a second body"}));
}

TEST(LeftOutTest, TwoBodiesThatInteractLackNoSecondBody) {
  const std::string parts = list("left", "") + list("right", list("Disk", numbers("Center", {11, 0})));
  const auto names =
      absent(list("Mesh", word("Type", "Parts") + list("Parts", parts)) +
             list("Materials", list("Left", word("Block", "left_body")) + list("Right", word("Block", "right_body"))) +
             list("Interactions",
                  list("Contact", word("Side Set", "left_surface") + word("Primary Side Set", "right_surface"))) +
             test::time_integrator("Newmark", 0.1, 1));
  EXPECT_EQ(std::count(names.begin(), names.end(), "a second body"), 0);
  EXPECT_EQ(std::count(names.begin(), names.end(), "friction"), 1);
}

TEST(LeftOutTest, StaticsHasNoInertiaAndNothingThatDependsOnRates) {
  const std::string held = list("Boundary Conditions", list("Grip", word("Node Set", "left")));
  EXPECT_EQ(absent(list("Mesh", word("Type", "Box")) + list("Materials", list("Rubber", "")) + held +
                   test::time_integrator("Static", 0.1, 1)),
            (std::vector<std::string>{"interaction", "inertia", "loads", "a second body", "fields.e"}));
}

}  // namespace
}  // namespace ixos
