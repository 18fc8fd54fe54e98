#include "run/remedies.hpp"

#include <gtest/gtest.h>

#include "support/bodies.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::count;
using test::list;
using test::number;
using test::word;

std::vector<std::string> remedies_of(const std::string& type, const std::string& control = "",
                                     const std::string& more = "") {
  const std::string steps = number("Time Step", 0.1) + number("Final Time", 1) + control;
  const Simulation simulation(
      test::scene(test::block_2d(0) + list("Time Integrator", word("Type", type) + list("Time Step Control", steps)) +
                  more),
      test::world());
  std::vector<std::string> all;
  for (const Remedy& remedy : remedies(simulation, true)) all.push_back(remedy.assignment);
  return all;
}

using Assignments = std::vector<std::string>;
const std::string control = "Time Integrator/Time Step Control/";
const std::string dynamic = "Time Integrator/Type=Generalized-Alpha";

TEST(RemediesTest, StepsAreCutFirstAndShorterThen) {
  EXPECT_EQ(remedies_of("Newmark"), Assignments{control + "Maximum Cuts=10"});
  EXPECT_EQ(remedies_of("Newmark", count("Maximum Cuts", 3)), Assignments{control + "Time Step=0.01"});
  EXPECT_EQ(remedies_of("Central Difference"), Assignments{"Time Integrator/Central Difference/Safety=0.2"});
}

TEST(RemediesTest, AnAdaptiveRunMayBeLessAccurate) {
  EXPECT_EQ(remedies_of("Newmark", word("Type", "Adaptive") + list("Adaptive", number("Tolerance", 1e-3))),
            Assignments{control + "Adaptive/Tolerance=0.01"});
}

TEST(RemediesTest, AQuasiStaticBodyMayTakeMoreIterationsOrMove) {
  EXPECT_EQ(remedies_of("Static"), (Assignments{control + "Maximum Cuts=10", dynamic}));
  EXPECT_EQ(remedies_of("Static", "", list("Nonlinear Solver", count("Snap Iterations", 0))),
            (Assignments{"Nonlinear Solver/Snap Iterations=1000", control + "Maximum Cuts=10", dynamic}));
}

TEST(RemediesTest, AQuasiStaticBodyWhoseLoadGrowsMovesFirst) {
  const std::string conditions =
      list("Boundary Conditions", list("Push", word("Type", "Traction") + word("Side Set", "top") +
                                                   word("History", "Grow") + test::numbers("Vector", {0, -1})));
  const std::string ramp = number("Value", 1) + number("Length", 1) + word("Shape", "Linear");
  const std::string grow = list("Histories", list("Grow", word("Type", "Ramp") + list("Ramp", ramp)));
  EXPECT_EQ(remedies_of("Static", "", conditions + grow), (Assignments{dynamic, control + "Maximum Cuts=10"}));
}

}  // namespace
}  // namespace ixos
