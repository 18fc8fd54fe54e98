#include "scene/read/time_integrator_options.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "parameters/validation.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

using Teuchos::ParameterList;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A list with all that must be given.
ParameterList least() {
  ParameterList user;
  user.sublist("Time Step Control").set("Final Time", 3.0);
  user.sublist("Time Step Control").set("Time Step", 0.5);
  return user;
}

TimeIntegratorOptions read(const ParameterList& user, const OutputOptions& output = {}) {
  ParameterList valid;
  declare_time_integrator(valid);
  const ParameterList complete = validated(user, valid);
  return read_time_integrator(SceneNode(complete, "Time Integrator"), output);
}

TEST(TimeIntegratorOptionsTest, TheDefaultsAreThoseOfTheStructs) {
  const TimeIntegratorOptions options = read(least());
  const StepControlOptions &control = options.step_control, fresh;
  EXPECT_EQ(options.scheme, default_scheme());
  EXPECT_FALSE(options.predictor);
  EXPECT_EQ(control.initial_time, fresh.initial_time);
  EXPECT_EQ(control.final_time, 3);
  EXPECT_EQ(control.time_step, 0.5);
  EXPECT_EQ(control.maximum_cuts, fresh.maximum_cuts);
  EXPECT_EQ(control.minimum_step, fresh.minimum_step);
  EXPECT_EQ(control.maximum_step, infinity);
  EXPECT_FALSE(control.adaptive.on);
  EXPECT_TRUE(control.output_intervals.empty());
}

TEST(TimeIntegratorOptionsTest, FixedStepsReachTheirMembers) {
  ParameterList user = least();
  user.set("Type", "Newmark");
  user.set("Predictor", "Extrapolation");
  ParameterList& control = user.sublist("Time Step Control");
  control.set("Initial Time", -1.0);
  control.set("Maximum Cuts", 4);
  control.set("Minimum Time Step", 0.125);
  const TimeIntegratorOptions options = read(user);
  EXPECT_EQ(options.scheme, "Newmark");
  EXPECT_EQ(options.predictor, Predictor::Extrapolation);
  EXPECT_EQ(options.step_control.initial_time, -1);
  EXPECT_EQ(options.step_control.maximum_cuts, 4);
  EXPECT_EQ(options.step_control.minimum_step, 0.125);
}

TEST(TimeIntegratorOptionsTest, LimitsCountForAdaptiveStepsOnly) {
  ParameterList user = least();
  ParameterList& limits = user.sublist("Time Step Control").sublist("Adaptive");
  limits.set("Tolerance", 1e-3);
  limits.set("Maximum Gap Ratio", 1.5);
  limits.set("Choose Time Points", true);
  limits.set("Safety", 0.75);
  limits.set("Largest Growth", 4.0);
  limits.set("Maximum Time Step", 0.7);
  const StepControlOptions fixed = read(user).step_control;
  EXPECT_FALSE(fixed.adaptive.on);
  EXPECT_EQ(fixed.adaptive.tolerance, 0);
  EXPECT_EQ(fixed.maximum_step, infinity);
  user.sublist("Time Step Control").set("Type", "Adaptive");
  const StepControlOptions adaptive = read(user).step_control;
  EXPECT_TRUE(adaptive.adaptive.on);
  EXPECT_EQ(adaptive.adaptive.tolerance, 1e-3);
  EXPECT_EQ(adaptive.adaptive.gap_ratio, 1.5);
  EXPECT_TRUE(adaptive.adaptive.time_points);
  EXPECT_EQ(adaptive.adaptive.safety, 0.75);
  EXPECT_EQ(adaptive.adaptive.growth, 4);
  EXPECT_EQ(adaptive.maximum_step, 0.7);
}

TEST(TimeIntegratorOptionsTest, ALongestStepOfZeroIsNoLimit) {
  ParameterList user = least();
  user.sublist("Time Step Control").set("Type", "Adaptive");
  const StepControlOptions control = read(user).step_control;
  EXPECT_TRUE(control.adaptive.on);
  EXPECT_EQ(control.maximum_step, infinity);
}

TEST(TimeIntegratorOptionsTest, StepsEndAtTheIntervalsOfOutput) {
  OutputOptions output;
  output.fields_time_interval = 0.1;
  EXPECT_EQ(read(least(), output).step_control.output_intervals, (std::vector<double>{0.1}));
}

TEST(TimeIntegratorOptionsTest, OnlyTheChosenSchemeIsCompleted) {
  ParameterList valid, user = least();
  declare_time_integrator(valid);
  user.set("Type", "Newmark");
  const ParameterList complete = validated(user, valid);
  EXPECT_TRUE(complete.isSublist("Newmark"));
  EXPECT_FALSE(complete.isSublist("Midpoint"));
  EXPECT_TRUE(valid.isSublist("Midpoint"));
}

TEST(TimeIntegratorOptionsTest, TimesMustBeGiven) {
  test::expect_contains(test::refusal([] { read({}); }), "Time Step Control/Final Time is missing");
}

}  // namespace
}  // namespace ixos
