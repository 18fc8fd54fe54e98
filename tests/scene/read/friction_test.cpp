#include "scene/read/friction.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "interaction/gap_law.hpp"
#include "model/traits.hpp"
#include "scene/examine/symmetry.hpp"
#include "scene/explain/explanation.hpp"
#include "scene/output/output_fields.hpp"
#include "support/bodies.hpp"
#include "support/refusal.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::list;
using test::number;
using test::word;

std::string friction(const std::string& type, const std::string& more) {
  return list("Friction", word("Type", type) + more);
}
const std::string constant = friction("Constant Stress", number("Stress", 0.02));
const std::string current = friction("Extended Amontons", number("Coefficient", 0.5) + word("Threshold", "Current"));

std::string block(const std::string& wall, const std::string& scheme = "Newmark",
                  const std::string& law = "Van der Waals", const std::string& more = "") {
  return test::adhesive_block(2, {law, "Half-Space", "Neo-Hooke"}, wall) + test::time_integrator(scheme, 0.1, 1) + more;
}

std::string refusal(const std::string& scene) {
  return test::refusal([&] { const Simulation s(test::scene(scene), test::self()); });
}

TEST(FrictionOptionsTest, ReachTheModel) {
  const Simulation s(test::scene(block(current)), test::self());
  const Friction& own = s.interactions().front().friction;
  EXPECT_EQ(own.type, FrictionType::ExtendedAmontons);
  EXPECT_EQ(own.coefficient, 0.5);
  EXPECT_EQ(own.cutoff_share, 1);
  EXPECT_EQ(own.stiffness, 0) << "FrictionLaw chooses it";
  EXPECT_TRUE(own.current);
  EXPECT_TRUE(has_friction(s.model(), "Wall"));
  EXPECT_FALSE(has_friction(Simulation(test::scene(block("")), test::self()).model(), "Wall"));
}

TEST(FrictionOptionsTest, BadInputIsRefused) {
  const struct {
    std::string scene, words;
  } cases[] = {
      {block(friction("Constant Stress", "")), "Interactions/Wall/Friction/Stress"},
      {block(friction("Constant Stress", number("Stress", -1))), "Interactions/Wall/Friction/Stress"},
      {block(friction("Constant Stress", number("Stress", 1) + number("Coefficient", 1))),
       "Interactions/Wall/Friction: \"Coefficient\" belongs to Type \"Extended Amontons\" or \"Smoothed\""},
      {block(friction("Extended Amontons", number("Coefficient", 1) + number("Cutoff Share", 2))),
       "Interactions/Wall/Friction/Cutoff Share"},
      {block(friction("Smoothed", number("Coefficient", 1))), "Interactions/Wall/Friction/Slip Speed"},
      {block(friction("Smoothed", number("Coefficient", 1) + number("Slip Speed", 0.1)), "Central Difference"),
       "Interactions/Wall/Friction/Type: \"Smoothed\" has no longest stable step"},
      {block(friction("Smoothed", number("Coefficient", 1) + number("Slip Speed", 0.1)), "Generalized-Alpha"),
       "Interactions/Wall/Friction/Type: \"Smoothed\" has no force at a step's start"},
      {block(friction("Constant Stress", number("Stress", 1) + word("Threshold", "Current"))),
       "Interactions/Wall/Friction/Threshold: \"Current\" with the Type \"Constant Stress\" and the Sharpness 0"},
      {block(current, "Newmark", "Bilinear Damage"),
       "Interactions/Wall/Friction/Type: the threshold of the friction follows the traction of a law with a history"}};
  for (const auto& [scene, words] : cases) test::expect_contains(refusal(scene), words);
  EXPECT_EQ(refusal(block(friction("Constant Stress",
                                   number("Stress", 1) + number("Sharpness", 20) + word("Threshold", "Current")))),
            "");
}

TEST(FrictionOptionsTest, ACurrentThresholdNeedsASolverForUnsymmetricMatrices) {
  const std::string cause = "Interactions/Wall/Friction/Threshold \"Current\"";
  const Simulation s(test::scene(block(current)), test::self());
  const SceneNode scene(s.parameters(), "");
  EXPECT_EQ(asymmetry(scene, s.materials(), s.model(), s.integrator().table()), cause);
  EXPECT_EQ(matrix_only(scene, s.materials(), s.model().mesh()), cause);
  const Simulation lagged(test::scene(block(constant)), test::self());
  EXPECT_EQ(
      asymmetry(SceneNode(lagged.parameters(), ""), lagged.materials(), lagged.model(), lagged.integrator().table()),
      "");
  EXPECT_EQ(matrix_only(SceneNode(lagged.parameters(), ""), lagged.materials(), lagged.model().mesh()), "");
  test::expect_contains(
      refusal(block(current, "Newmark", "Van der Waals", list("Linear Solver", word("Operator", "Matrix-Free")))),
      cause);
}

TEST(FrictionOptionsTest, AreExplained) {
  const auto line = [](const std::string& wall) {
    const std::string text = explain(Simulation(test::scene(block(wall)), test::self()));
    const auto begin = text.find("  Friction: ");
    return begin == std::string::npos ? "" : text.substr(begin, text.find('\n', begin) - begin);
  };
  EXPECT_EQ(line(""), "");
  EXPECT_EQ(
      line(constant),
      "  Friction: Constant Stress, threshold 0.02 E0, below a gap of 0.30589 L0; elastic slip up to 0.000816 L0; "
      "what it stores is part of contact_energy, what it dissipates of dissipated_energy");
  test::expect_contains(line(current),
                        "Extended Amontons, coefficient 0.5, threshold 0.0312214 E0 at the equilibrium gap");
}

// Before a sphere of radius R the law is psi a with a = (1 + g/2R)/(1 + g/R) in plane strain, T a - psi a'.
TEST(FrictionOptionsTest, AreExplainedWithTheLawThatActs) {
  auto scene = test::scene(test::adhesive_block(2, {"Van der Waals", "Sphere", "Neo-Hooke"}, current) +
                           test::time_integrator("Newmark", 0.1, 1));
  scene.sublist("Interactions").sublist("Wall").sublist("Sphere").set("Area Factor", true);
  const Simulation s(scene, test::self());
  const GapLaw& law = *s.interactions().front().law;
  const auto traction = [&](double gap) {
    const double x = 1 + gap / 3, a = (1 + gap / 6) / x, slope = -1 / (6 * x * x);
    return law.traction(gap)[0] * a - law.energy(gap)[0] * slope;
  };
  const double threshold = 0.5 * (traction(law.equilibrium_gap()) - traction(law.adhesion_gap()));
  test::expect_contains(explain(s), fmt::format("threshold {:.6g} E0 at the equilibrium gap", threshold));
  EXPECT_GT(std::abs(threshold - 0.0312214), 1e-4) << "the factor shows";
}

TEST(FrictionOptionsTest, FieldsNeedFriction) {
  const std::string output =
      list("Output", test::texts("Fields", "{slip_Wall, sliding_Wall, dissipated_Wall, friction_Wall}"));
  test::expect_contains(refusal(block("", "Newmark", "Van der Waals", output)),
                        "Output/Fields: \"friction_Wall\" needs friction of this interaction");
  EXPECT_EQ(refusal(block(constant, "Newmark", "Van der Waals", output)), "");
}

}  // namespace
}  // namespace ixos
