// Quasi-static bodies under dead loads: beyond the largest one there is no equilibrium, and the step says so.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>
#include <vector>

#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "scene/simulation.hpp"
#include "support/comparison.hpp"
#include "support/obstacle_geometry.hpp"
#include "support/scene_text.hpp"
#include "test_folders.hpp"

namespace ixos {
namespace {

using test::list;
using test::number;
using test::numbers;
using test::word;

constexpr int loads = 20;         ///< load steps
constexpr double overload = 1.3;  ///< the last load over the largest one

enum class Space { Plane, Solid, Revolved };
constexpr const char* space_name(Space space) {
  return space == Space::Plane ? "Plane" : space == Space::Solid ? "Solid" : "Revolved";
}

struct Case {
  std::string law;
  std::string obstacle;  ///< "Pair": another body of the same shape
  Space space;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.law << ", " << c.obstacle << ", " << space_name(c.space); }

std::string obstacle_lists(const std::string& obstacle, std::size_t d) {
  std::vector<double> center(d, 0.0);
  center.back() = -20;
  const std::string name = word("Obstacle", obstacle);
  if (obstacle == "Sphere") return name + list(obstacle, numbers("Center", center) + number("Radius", 20));
  if (obstacle == "Cylinder")
    return name + list(obstacle, numbers("Center", center) + number("Radius", 20) +
                                     (d == 3 ? numbers("Axis", {1, 0, 0}) : std::string()));
  if (obstacle == "Cone") return name + list(obstacle, number("Radius", 20) + number("Half Angle", 80));
  if (obstacle == "Sine Wall")
    return name + list(obstacle, number("Amplitude", 0.02) + number("Period", 4) + word("Gap", "Vertical"));
  if (obstacle == "Height Field")
    return name + list(obstacle, word("File", IXOS_TEST_DIRECTORY "/interaction/hills.txt") +
                                     numbers("Spacing", {0.25, 1.0}) + word("Level", "Top") + word("Gap", "Vertical"));
  return name;
}

/// A block of 2 by 1, or 2 by 2 by 1, whose bottom is at `height`.
std::string box(Space space, double height) {
  const bool solid = space == Space::Solid;
  std::vector<double> lengths{2, 1}, lower{0, height};
  std::vector<int> divisions{2, 1};
  if (solid) {
    lengths = {2, 2, 1};
    lower = {0, 0, height};
    divisions = {2, 2, 1};
  }
  return word("Type", "Box") + list("Box", test::count("Dimension", solid ? 3 : 2) + numbers("Lengths", lengths) +
                                               test::counts("Divisions", divisions) + numbers("Lower", lower));
}

/// Returns the gap without a force at which a body rests: 0 of bonds, of laws that only repel that at which they begin.
double rest_gap(const GapLaw& law) {
  const double peak = -law.traction(law.adhesion_gap())[0], equilibrium = law.equilibrium_gap();
  if (peak <= 0) return law.adhesion_gap();
  return std::abs(law.traction(equilibrium)[0]) < 1e-9 * peak ? equilibrium : 0;
}

/// The block, pulled off the obstacle at y = 0 or z = 0 by a traction that grows in equal steps.
Teuchos::ParameterList pulled(const Case& c, const GapLaw& law, double traction) {
  const double gap = rest_gap(law);
  const std::size_t d = c.space == Space::Solid ? 3 : 2;
  const bool pair = c.obstacle == "Pair";
  const std::string upper = pair ? "upper_" : "";
  const std::string geometry = c.space == Space::Revolved ? word("Geometry", "Axisymmetric") : "";
  std::vector<double> up(d, 0.0);
  up.back() = traction;
  const auto guide = [&](const std::string& side, const std::string& components) {
    return list("Guide of " + side, word("Node Set", side) + word("Components", components));
  };
  std::string supports = pair ? list("Floor", word("Node Set", "lower_bottom")) : "";
  if (c.space != Space::Revolved) supports += guide(upper + "left", "x");
  if (d == 3) supports += guide(upper + "front", "y");
  return test::scene(
      list("Mesh", geometry + (pair ? word("Type", "Parts") + list("Parts", list("lower", box(c.space, 0)) +
                                                                                list("upper", box(c.space, 1 + gap)))
                                    : box(c.space, gap))) +
      list("Materials", pair ? list("Lower", word("Block", "lower_body") + number("Poisson's Ratio", 0.3)) +
                                   list("Upper", word("Block", "upper_body") + number("Poisson's Ratio", 0.3))
                             : list("Rubber", number("Poisson's Ratio", 0.3))) +
      list("Interactions", list("Bond", word("Side Set", upper + "bottom") + word("Law", c.law) +
                                            (pair ? word("Primary Side Set", "lower_top") + word("Smoothing", "None")
                                                  : obstacle_lists(c.obstacle, d)))) +
      list("Histories", list("Load", word("Type", "Ramp") + list("Ramp", number("Value", 1) + number("Length", 1) +
                                                                             word("Shape", "Linear")))) +
      list("Boundary Conditions", supports + list("Pull", word("Type", "Traction") + word("Side Set", upper + "top") +
                                                              numbers("Vector", up) + word("History", "Load"))) +
      test::time_integrator("Static", 1.0 / loads, 1));
}

class DeadLoadTest : public testing::TestWithParam<Case> {};

TEST_P(DeadLoadTest, BeyondTheLargestLoadThereIsNoEquilibrium) {
  const Case& c = GetParam();
  const auto law = make_gap_law(c.law);
  const double peak = std::max(-law->traction(law->adhesion_gap())[0], 0.0);
  const double area = c.space == Space::Plane ? 2 : c.space == Space::Solid ? 4 : 4 * M_PI;
  const double last = peak > 0 ? overload * peak : 0.01;
  Simulation s(pulled(c, *law, last), test::world());
  StepResult result;
  int steps = 0;
  while (steps < loads && (result = s.integrator().step(1.0 / loads)).converged) ++steps;
  ASSERT_FALSE(result.converged) << "the body has left the obstacle, and hangs in no equilibrium";
  EXPECT_LT(result.newton_iterations, 150) << "the body is lost long before its iterations run out";
  const double found = last * area * steps / loads;
  EXPECT_EQ(result.reason.find(fmt::format("no equilibrium found beyond a load of {:.6g} E0 L0{}, reached at t = ",
                                           found, c.space == Space::Plane ? "" : "^2")),
            0U)
      << result.reason;
  EXPECT_NE(result.reason.find("control the displacement, or use a dynamic scheme"), std::string::npos);
  EXPECT_LE(found, peak * area * (1 + 1e-9));
  // All points of a flat obstacle have one gap, so that the body holds until the law's own peak.
  if (c.obstacle == "Half-Space" || c.obstacle == "Pair") {
    EXPECT_GT(found + last * area / loads, peak * area * (1 - 1e-9));
  }
  EXPECT_NEAR(s.integrator().time(), static_cast<double>(steps) / loads, 1e-12) << "the last equilibrium stays";
}

/// Returns a law with its defaults, and some value of what has none.
std::shared_ptr<const GapLaw> law_named(const std::string& name) {
  const Teuchos::ParameterList list = test::complete(laws(), name);
  return laws().make(SceneNode(list, ""));
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const Space space : {Space::Plane, Space::Solid, Space::Revolved}) {
    for (const LawEntry& entry : laws().entries()) {
      const auto law = law_named(entry.name);
      if (!law->repels()) continue;
      all.push_back({entry.name, "Half-Space", space});
      if (!law->has_history()) all.push_back({entry.name, "Pair", space});
    }
    for (const ObstacleEntry& obstacle : obstacles().entries()) {
      // Cylinders across the axis and walls that vary along one direction only are no bodies of revolution.
      if (space == Space::Revolved &&
          (obstacle.name == "Cylinder" || obstacle.name == "Sine Wall" || obstacle.name == "Height Field"))
        continue;
      if (obstacle.name != "Half-Space") all.push_back({"Van der Waals", obstacle.name, space});
    }
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, DeadLoadTest, testing::ValuesIn(cases()), [](const auto& tested) {
  std::string name = tested.param.law + tested.param.obstacle + space_name(tested.param.space);
  name.erase(std::remove_if(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }),
             name.end());
  return name;
});

TEST(DeadLoadsTest, AbodyThatSlidesBeyondItsFrictionHasNoEquilibrium) {
  const double threshold = 0.02;
  const Teuchos::ParameterList scene = test::scene(
      list("Mesh", box(Space::Plane, 0.2547093)) + list("Materials", list("Rubber", "")) +
      list("Interactions",
           list("Foot", word("Side Set", "bottom") +
                            list("Friction", word("Type", "Constant Stress") + number("Stress", threshold)))) +
      list("Histories", list("Load", word("Type", "Ramp") + list("Ramp", number("Value", 1) + number("Length", 1) +
                                                                             word("Shape", "Linear")))) +
      list("Boundary Conditions",
           list("Push", word("Type", "Traction") + word("Side Set", "bottom") +
                            numbers("Vector", {overload * threshold, 0.0}) + word("History", "Load"))) +
      test::time_integrator("Static", 1.0 / loads, 1));
  Simulation s(scene, test::world());
  StepResult result;
  int steps = 0;
  while (steps < loads && (result = s.integrator().step(1.0 / loads)).converged) ++steps;
  ASSERT_FALSE(result.converged);
  EXPECT_EQ(result.reason.find("no equilibrium found beyond a load of "), 0U) << result.reason;
  EXPECT_EQ(steps, static_cast<int>(loads / overload));
}

}  // namespace
}  // namespace ixos
