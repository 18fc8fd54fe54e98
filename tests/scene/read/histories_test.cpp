#include "scene/read/histories.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "scene/simulation.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::expect_contains;
using test::list;
using test::number;
using test::numbers;
using test::word;
using test::world;

/// A plate of 3 by 2 over a wall, run until 10. The history H moves its top (Displacement), a grip of its top (Grip) or
/// the wall (Wall), or loads it (Load).
Teuchos::ParameterList plate(const std::string& use, const std::string& history, const std::string& scheme) {
  const std::string translation = test::texts("Translation", "{-, H}");
  const std::string top = word("Node Set", "top"), driven = word("Components", "y") + word("History", "H");
  return test::scene(
      list("Mesh", word("Type", "Box") + list("Box", numbers("Lengths", {3, 2}) + test::counts("Divisions", {3, 2}))) +
      list("Materials", list("Rubber", "")) + list("Histories", list("H", history)) +
      list("Interactions", list("Wall", word("Side Set", "bottom") + numbers("Point", {0, -0.3}) +
                                            (use == "Wall" ? list("Motion", translation) : ""))) +
      (use == "Grip" ? list("Grips", list("Jaw", top + translation)) : "") +
      list("Boundary Conditions",
           (use == "Displacement" ? list("Move", top + driven) : "") +
               (use == "Load"
                    ? list("Weight", word("Type", "Body Force") + numbers("Vector", {0, 0.001}) + word("History", "H"))
                    : "") +
               (use == "Grip" ? "" : list("Hold", top + word("Components", use == "Displacement" ? "x" : "xy")))) +
      test::time_integrator(scheme, 0.1, 10));
}

std::string refusal(const std::string& use, const std::string& history, const std::string& scheme) {
  return test::refusal([&] { Simulation(plate(use, history, scheme), world()); });
}

std::string ramp(double start, double length, const std::string& shape) {
  return word("Type", "Ramp") +
         list("Ramp", number("Value", 0.01) + number("Start", start) + number("Length", length) + word("Shape", shape));
}

std::string table(const std::string& interpolation) {
  return word("Type", "Table") + list("Table", numbers("Times", {0, 4, 10}) + numbers("Values", {0, 0.01, 0.01}) +
                                                   word("Interpolation", interpolation));
}

TEST(HistoriesTest, WhatJumpsDrivesLoadsAndStaticMotions) {
  const std::vector<std::pair<std::string, std::string>> histories = {
      {ramp(2, 3, "Linear"),
       "Shape Linear cannot drive a motion of a dynamic scheme: its rate jumps at the times 2, 5"},
      {ramp(2, 0, "Quintic"),
       "a ramp of Length 0 cannot drive a motion of a dynamic scheme: its value jumps at the "
       "time 2"},
      {table("Linear"), "Interpolation Linear cannot drive a motion of a dynamic scheme: its rate jumps at the time 4"},
      {table("Step"), "Interpolation Step cannot drive a motion of a dynamic scheme: its value jumps at the time 4"},
      {word("Type", "Expression") +
           list("Expression",
                word("Value", "0.01*abs(t-4)") + word("Velocity", "0.01*sign(t-4)") + word("Acceleration", "0")),
       "the acceleration is not the derivative of the rate"}};
  for (const auto& [history, message] : histories) {
    for (const std::string use : {"Displacement", "Grip", "Wall"}) {
      EXPECT_EQ(refusal(use, history, "Static"), "") << use;
      for (const std::string scheme : {"Average Vector Field", "Central Difference"})
        expect_contains(refusal(use, history, scheme), "Histories/H: " + message);
    }
    EXPECT_EQ(refusal("Load", history, "Average Vector Field"), "");
  }
}

TEST(HistoriesTest, WhatJumpsNotWithinTheRunDrivesAnyMotion) {
  for (const std::string& history :
       {ramp(0, 0, "Quintic"), ramp(-1, 0, "Linear"), ramp(0, 20, "Linear"), table("Monotone"), table("Unlimited")})
    EXPECT_EQ(refusal("Displacement", history, "Newmark"), "") << history;
}

TEST(HistoriesTest, ARampMayOutlastTheRun) {
  for (const std::string shape : {"Linear", "Cosine", "Quintic"}) {
    const std::string scheme = shape == "Linear" ? "Static" : "Newmark";  // its rate jumps at the start
    const Simulation longer(plate("Displacement", ramp(4, 8, shape), scheme), world());
    ASSERT_EQ(longer.notes().size(), 1U) << shape;
    EXPECT_EQ(longer.notes()[0], "Histories/H: the ramp ends at t = 12 T0, after the Final Time 10 of the run");
    EXPECT_TRUE(Simulation(plate("Load", ramp(4, 6, shape), "Newmark"), world()).notes().empty()) << shape;
  }
}

}  // namespace
}  // namespace ixos
