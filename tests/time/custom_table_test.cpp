// Tables that a scene contains: schemes_test.cpp has those of one stage, and what a scene's user reads of a refusal.
#include "time/custom_table.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "parameters/validation.hpp"
#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/comparison.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::list;
using test::number;
using test::numbers;
using test::word;

Table custom(const std::string& parameters) {
  return custom_table(validated(test::scene(parameters), custom_parameters()));
}

/// The trapezoid over the share `end` of a step, here 1/2 or 1.
std::string trapezoid(double end = 1) {
  const double r = 2 / end;
  return numbers("Velocity", {r, -r, -1, 0}) + numbers("Acceleration", {r * r, -r * r, -2 * r, -1});
}

/// Bathe (2007) as published: the trapezoid over half a step, then dt v = u_n - 4 u_h + 3 u, and dt^2 a likewise of v,
/// dt v put in: dt v_n - 4 dt v_h + 3 (u_n - 4 u_h + 3 u).
std::string bathe() {
  return list("Stages", list("Half", number("End", 0.5) + trapezoid(0.5)) +
                            list("Whole", numbers("Velocity", {3, 1, 0, 0, -4, 0, 0}) +
                                              numbers("Acceleration", {9, 3, 1, 0, -12, -4, 0})));
}

TEST(CustomTableTest, TwoStagesWrittenDownAreTheCompositeScheme) {
  const auto end = [](const std::string& scheme, const std::string& parameters) {
    Simulation s(test::scene(test::block_2d(1.0) + test::time_integrator(scheme, 0.05, 1, parameters)), test::world());
    for (int n = 0; n < 10; ++n) EXPECT_TRUE(s.integrator().step(0.05).converged) << scheme;
    return test::gathered(s.model(), s.integrator().state().u);
  };
  const std::vector<double> expected = end("Bathe Composite", number("Spectral Radius", 0) + number("Split", 0.5));
  EXPECT_LT(test::distance(end("Custom", bathe()), expected), 1e-9);
  EXPECT_GT(test::distance(end("Newmark", ""), expected), 1e-6) << "another scheme ends elsewhere";
}

TEST(CustomTableSerialTest, RowsReachTheStatesInTheirOrder) {
  const Table table = custom(bathe());
  EXPECT_NO_THROW(check(table));
  ASSERT_EQ(table.stages.size(), 2U);
  EXPECT_EQ(table.stages[0].end, 0.5);
  EXPECT_EQ(table.stages[1].end, 1);
  const Row& row = table.stages[1].acceleration;
  EXPECT_EQ(row.unknown, 9);
  ASSERT_EQ(row.known.size(), 2U);
  EXPECT_EQ(row.known[0].u, 3);
  EXPECT_EQ(row.known[0].v, 1);
  EXPECT_EQ(row.known[0].a, 0);
  EXPECT_EQ(row.known[1].u, -12);
  EXPECT_EQ(row.known[1].v, -4);
  EXPECT_EQ(row.known[1].a, 0);
}

TEST(CustomTableSerialTest, WhatIsNotGivenFollowsFromTheRest) {
  const Table table = custom(bathe());
  EXPECT_EQ(table.closing, Closing::Kinematic);
  EXPECT_EQ(table.driven_rates, DrivenRates::Exact);
  EXPECT_EQ(table.work.form, WorkSum::Form::Increment);
  EXPECT_EQ(table.error_constant, 0) << "not known";
  for (const Stage& stage : table.stages) {
    EXPECT_EQ(stage.inertia.unknown, stage.acceleration.unknown);
    EXPECT_EQ(stage.inertia.known.size(), stage.acceleration.known.size());
    EXPECT_EQ(stage.damping.unknown, stage.velocity.unknown);
    ASSERT_EQ(stage.load.size(), 1U);
    EXPECT_EQ(stage.load[0].time, stage.end);
    EXPECT_EQ(stage.load[0].weight, 1);
    for (const Rule* rule : {&stage.elastic, &stage.interaction}) {
      EXPECT_EQ(rule->kept_weight, 0);
      ASSERT_EQ(rule->points.size(), 1U);
      EXPECT_EQ(rule->points[0].to, 1);
    }
  }
}

TEST(CustomTableSerialTest, EveryEntryReachesTheTable) {
  const Table table = custom(
      word("Closing", "Collocate") + word("Driven Rates", "Own") + word("Work", "Stages") +
      numbers("Work Weights", {0.25, 0.75}) +
      list("Stages", list("One", trapezoid() + numbers("Inertia", {2, -2, -2, 0}) + numbers("Damping", {1, -1, 0, 0}) +
                                     numbers("Elastic Points", {0, 1}) + numbers("Elastic Weights", {0.3, 0.7}) +
                                     numbers("Interaction Points", {0.2, 0.5}) +
                                     numbers("Interaction Weights", {0.4, 0.6}) + word("Path", "Kinematic") +
                                     numbers("Load Times", {0, 0.5}) + numbers("Load Weights", {0.1, 0.9}))));
  EXPECT_NO_THROW(check(table));
  EXPECT_EQ(table.closing, Closing::Collocate);
  EXPECT_EQ(table.driven_rates, DrivenRates::Own);
  EXPECT_EQ(table.work.form, WorkSum::Form::Stages);
  EXPECT_EQ(table.work.weights, (std::vector<double>{0.25, 0.75}));
  const Stage& stage = table.stages.at(0);
  EXPECT_EQ(stage.inertia.unknown, 2);
  EXPECT_EQ(stage.acceleration.unknown, 4);
  EXPECT_EQ(stage.damping.unknown, 1);
  EXPECT_EQ(stage.velocity.unknown, 2);
  EXPECT_EQ(stage.elastic.kept_weight, 0.3) << "the point at the start";
  ASSERT_EQ(stage.elastic.points.size(), 1U);
  EXPECT_EQ(stage.elastic.points[0].weight, 0.7);
  ASSERT_EQ(stage.interaction.points.size(), 2U);
  EXPECT_EQ(stage.interaction.points[1].weight, 0.6);
  EXPECT_DOUBLE_EQ(stage.interaction.points[1].to, 0.25) << "u_s counts with the square of the time";
  EXPECT_DOUBLE_EQ(stage.interaction.points[1].velocity, 0.25);
  ASSERT_EQ(stage.load.size(), 2U);
  EXPECT_EQ(stage.load[1].time, 0.5);
  EXPECT_EQ(stage.load[1].weight, 0.9);
  EXPECT_EQ(custom(word("Work", "End Mean") + list("Stages", list("One", trapezoid()))).work.form,
            WorkSum::Form::EndMean);
}

TEST(CustomTableSerialTest, ARefusalNamesStageAndEntry) {
  const std::string first = list("Half", number("End", 0.5) + trapezoid(0.5));
  const auto refusal = [&](const std::string& second) -> std::string {
    try {
      custom(list("Stages", first + list("Whole", second)));
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  const auto expect = [&](const std::string& second, const std::string& words) {
    test::expect_contains(refusal(second), "Whole\", " + words);
  };
  EXPECT_EQ(refusal(trapezoid()), "accepted");
  const std::string velocity = numbers("Velocity", {2, -2, -1, 0});
  expect(velocity, "Acceleration: it has 0 numbers");
  expect(velocity + numbers("Acceleration", {4, -4}), "Acceleration: it has 2 numbers");
  // It may refer to the start and to the end of the first stage, but not to itself.
  expect(numbers("Velocity", {2, -2, -1, 0, 0, 0, 0, 0, 0, 0}) + numbers("Acceleration", {4, -4, -4, -1}),
         "Velocity: it has 10 numbers; a row has one for the unknown and three for each known state, at most 7");
  expect(trapezoid() + numbers("Load Times", {0, 1}), "Load Weights: there are 0 weights for 2 times");
  expect(trapezoid() + numbers("Interaction Weights", {0.5, 0.5}),
         "Interaction Weights: there are 2 weights for 1 points");
  expect(trapezoid() + numbers("Inertia", {0, 0, 0, 1}), "Inertia: the coefficient of the unknown must be greater");
}

}  // namespace
}  // namespace ixos
