// Settings of the runs of --accuracy: the first ones, their refinement, and schemes that are refused.
#include "study/accuracy/accuracy_settings.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/refusal.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

const std::string control = "Time Integrator/Time Step Control/";

/// Returns the first settings for the ball of diameter 10 L0, which runs to 10 T0.
AccuracySettings first(double accuracy, const std::vector<std::string>& assignments = {}) {
  const Simulation simulation(test::scene_file("ball.xml", assignments), test::self());
  return first_settings(simulation, accuracy);
}

TEST(AccuracySettingsTest, TheFirstRunOfAFixedScene) {
  const AccuracySettings settings = first(0.01);
  EXPECT_NEAR(settings.tolerance, 0.1, 1e-12);
  EXPECT_DOUBLE_EQ(settings.gap_ratio, 2);
  EXPECT_DOUBLE_EQ(settings.longest_step, 0.4);
  EXPECT_DOUBLE_EQ(settings.newton_tolerance, 1e-6);
  EXPECT_DOUBLE_EQ(first(0.2).longest_step, 0.4) << "a larger accuracy begins with the same";
}

TEST(AccuracySettingsTest, AHundredthOfTheAccuracyNeedsATenthOfTheSteps) {
  const AccuracySettings settings = first(1e-4);
  EXPECT_NEAR(settings.tolerance, 1e-4, 1e-12);
  EXPECT_NEAR(settings.gap_ratio, std::pow(2, 0.1), 1e-12);
  EXPECT_NEAR(settings.longest_step, 0.04, 1e-12);
  EXPECT_NEAR(settings.newton_tolerance, 1e-9, 1e-18);
}

TEST(AccuracySettingsTest, ASceneWithStagesIsRefused) {
  const std::string end = "/Time Integrator/Time Step Control/Final Time=1";
  test::expect_contains(test::refusal([&] {
                          first(0.01, {"Stages/Fall" + end, "Stages/Rise" + end});
                        }),
                        "--accuracy: the scene has Stages");
}

TEST(AccuracySettingsTest, LimitsOfTheSceneComeFirst) {
  const std::vector<std::string> own{control + "Type=Adaptive", control + "Adaptive/Tolerance=0.03",
                                     control + "Adaptive/Maximum Gap Ratio=1.3",
                                     control + "Adaptive/Maximum Time Step=0.05"};
  const AccuracySettings settings = first(0.01, own);
  EXPECT_DOUBLE_EQ(settings.tolerance, 0.03);
  EXPECT_DOUBLE_EQ(settings.gap_ratio, 1.3);
  EXPECT_DOUBLE_EQ(settings.longest_step, 0.05);
}

TEST(AccuracySettingsTest, LawsOfEveryGapHaveNoGapRatio) {
  EXPECT_EQ(first(0.01, {"Interactions/Wall/Law=Morse", "Interactions/Wall/Morse/Work of Adhesion=0.1",
                         "Interactions/Wall/Morse/Strength=0.5"})
                .gap_ratio,
            0);
}

TEST(AccuracySettingsTest, NewtonsToleranceStopsAtRounding) {
  AccuracySettings settings;
  settings.newton_tolerance = 1e-10;
  EXPECT_DOUBLE_EQ(refined(settings, 0.1).newton_tolerance, 1e-11);
  EXPECT_EQ(refined(settings, 0.1).gap_ratio, 0) << "no limit stays none";
}

TEST(AccuracySettingsTest, TheSceneTakesThem) {
  std::vector<std::string> changes = assignments(first(0.01));
  const Simulation simulation(test::scene_file("ball.xml", changes), test::self());
  const StepControlOptions& options = simulation.step_control();
  EXPECT_TRUE(options.adaptive.on);
  EXPECT_DOUBLE_EQ(options.adaptive.tolerance, 0.1);
  EXPECT_DOUBLE_EQ(options.adaptive.gap_ratio, 2);
  EXPECT_DOUBLE_EQ(options.maximum_step, 0.4);
  EXPECT_DOUBLE_EQ(simulation.newton().tolerance, 1e-6);
}

TEST(AccuracySettingsTest, SchemesWithoutAnErrorAreRefused) {
  const std::string message = test::refusal([] { first(0.01, {"Time Integrator/Type=Static"}); });
  test::expect_contains(message, "--accuracy: the Time Integrator/Type \"Static\" has load steps");
  const std::vector<std::string> third_order{"Time Integrator/Type=Newmark",
                                             "Time Integrator/Newmark/Beta=0.16666666666666666"};
  test::expect_contains(test::refusal([&] { first(0.01, third_order); }),
                        "--accuracy: the Time Integrator/Type \"Newmark\" has no estimate of its local error");
}

}  // namespace
}  // namespace ixos
