#include "scene/examine/compatibility.hpp"

#include <gtest/gtest.h>

#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/refusal.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::list;
using test::number;
using test::word;

const test::Adhesion wall{}, morse{"Morse", "Half-Space", "Neo-Hooke"}, sphere{"Van der Waals", "Sphere", "Neo-Hooke"};
const std::string choose_points = R"(<Parameter name="Choose Time Points" type="bool" value="true"/>)";

std::string refusal(const std::string& scene) {
  return test::refusal([&] { const Simulation s(test::scene(scene), test::self()); });
}

/// Average Vector Field with adaptive steps.
std::string adaptive(const std::string& limits) {
  return list("Time Integrator", word("Type", "Average Vector Field") +
                                     list("Time Step Control", word("Type", "Adaptive") + number("Time Step", 0.01) +
                                                                   number("Final Time", 1) + list("Adaptive", limits)));
}

std::string exact_mean() {
  return test::time_integrator("Average Vector Field", 0.02, 1, test::count("Interaction Points", 0));
}

TEST(CompatibilityTest, LimitsOfTheGapRatioNeedALawOfPositiveGaps) {
  const std::string place = "Time Integrator/Time Step Control/Adaptive/",
                    why = "Interactions/Wall/Law \"Morse\" is defined at every gap, so it needs no such limit";
  const std::string ratio = number("Maximum Gap Ratio", 1.4), error = number("Tolerance", 0.01);
  EXPECT_EQ(refusal(test::adhesive_block(2, morse) + adaptive(ratio)),
            place + "Maximum Gap Ratio: 1.4 has no effect: " + why + "; use 0, and Tolerance");
  EXPECT_EQ(refusal(test::adhesive_block(2, morse) + adaptive(error + choose_points)),
            place + "Choose Time Points: true has no effect: " + why + "; use false");
  EXPECT_EQ(refusal(test::adhesive_block(2, morse) + adaptive(error)), "");
  for (const test::Adhesion& adhesion : {wall, sphere})
    EXPECT_EQ(refusal(test::adhesive_block(2, adhesion) + adaptive(ratio + choose_points)), "") << adhesion.obstacle;
}

TEST(CompatibilityTest, OneLawOfPositiveGapsIsEnough) {
  std::string scene = test::adhesive_block(2, morse);
  const std::string interactions = "<ParameterList name=\"Interactions\">";
  scene.insert(
      scene.find(interactions) + interactions.size(),
      list("Lid", word("Side Set", "top") + test::numbers("Point", {0, 2}) + test::numbers("Normal", {0, -1})));
  EXPECT_EQ(refusal(scene + adaptive(number("Maximum Gap Ratio", 1.4) + choose_points)), "");
}

TEST(CompatibilityTest, LimitsOfTheGapRatioNeedAnInteraction) {
  const std::string place = "Time Integrator/Time Step Control/Adaptive/";
  EXPECT_EQ(refusal(test::block_2d(0) + adaptive(number("Maximum Gap Ratio", 1.4))),
            place + "Maximum Gap Ratio: 1.4 has no effect: the scene has no interaction; use 0, and Tolerance");
  EXPECT_EQ(refusal(test::block_2d(0) + adaptive(number("Tolerance", 0.01) + choose_points)),
            place + "Choose Time Points: true has no effect: the scene has no interaction; use false");
}

TEST(CompatibilityTest, TheExactMeanAllowsACutoff) {
  for (const char* law : {"Van der Waals", "Morse", "Mie", "Xu-Needleman"})
    for (const char* obstacle : {"Half-Space", "Sphere"}) {
      SCOPED_TRACE(std::string(law) + ", " + obstacle);
      Simulation s(
          test::scene(test::adhesive_block(2, {law, obstacle, "Neo-Hooke"}, number("Cutoff", 0.6)) + exact_mean()),
          test::self());
      const auto energy = [&s] {
        const State& state = s.integrator().state();
        return StateReport(s.model(), state).momenta().kinetic_energy +
               StateReport(s.model(), state).energy(Part::Elastic) +
               StateReport(s.model(), state).energy(Part::Interaction);
      };
      const double before = energy();
      for (int step = 0; step < 50; ++step) ASSERT_TRUE(s.integrator().step(0.02).converged);
      EXPECT_NEAR(energy(), before, 1e-11);
    }
}

}  // namespace
}  // namespace ixos
