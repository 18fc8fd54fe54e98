// Costs of settings, from runs with known costs.
#include "study/advice/advice_costs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/advice_case.hpp"

namespace ixos {
namespace {

double nothing(double, double, const AdvicePoint&) { return 0; }

TEST(AdviceCostsTest, RunsAndWhatTheyTell) {
  const AdviceDirections directions = test::directions_of_formula();
  const AdvicePoint base{{0, 2}, {0, 0}, {0, 0}};
  std::vector<AdviceSample> samples = test::cross(directions, base, 3, 2, nothing);
  samples.front().seconds *= 1.01;
  const AdviceCosts costs(directions, samples);
  EXPECT_EQ(costs.seconds(samples.front().point), samples.front().seconds) << "measured";
  // One level finer in both: 16 steps, and a mesh of 1/8.
  EXPECT_NEAR(costs.seconds({{0, 4}, {0, 3}, {0, 0}}) / (1e-3 * 16 * std::pow(8, 2.4)), 1, 0.15);
}

TEST(AdviceCostsTest, BranchesHaveFactors) {
  const AdviceDirections directions = test::directions_of_formula();
  const AdvicePoint base{{0, 2}, {0, 0}, {0, 0}}, other{{1, 2}, {0, 0}, {0, 0}};
  std::vector<AdviceSample> samples = test::cross(directions, base, 3, 2, nothing);
  samples.push_back(test::sample_of(directions, other, nothing));
  samples.back().seconds *= 3;
  const AdviceCosts costs(directions, samples);
  EXPECT_NEAR(costs.seconds({{1, 3}, {0, 1}, {0, 0}}) / costs.seconds({{0, 3}, {0, 1}, {0, 0}}), 3, 0.3);
}

TEST(AdviceCostsTest, AStartIsNotExtrapolated) {
  const AdviceDirections directions = test::directions_of_formula();
  const AdvicePoint base{{0, 2}, {0, 0}, {0, 0}};
  constexpr double start = 0.14;
  std::vector<AdviceSample> samples = test::cross(directions, base, 3, 2, nothing);
  for (AdviceSample& sample : samples) {
    sample.seconds_per_step = sample.seconds / sample.steps;
    sample.seconds += start;
  }
  // One level finer in both. Without the start, the small runs would hide how costs grow.
  EXPECT_NEAR(
      AdviceCosts(directions, samples).seconds({{0, 4}, {0, 3}, {0, 0}}) / (start + 1e-3 * 16 * std::pow(8, 2.4)), 1,
      0.2);
}

TEST(AdviceCostsTest, CellsOfAHigherOrderHaveMoreUnknowns) {
  AdviceDirections directions = test::directions_of_formula();
  directions.all[mesh_direction].branches[1].higher_order = true;
  const AdvicePoint base{{0, 2}, {0, 0}, {0, 0}};
  std::vector<AdviceSample> samples = test::cross(directions, base, 3, 2, nothing);
  const auto ratio = [&](std::size_t level) {
    const AdviceCosts costs(directions, samples);
    return costs.seconds({{0, 2}, {1, level}, {0, 0}}) / costs.seconds({{0, 2}, {0, level}, {0, 0}});
  };
  EXPECT_NEAR(ratio(1), std::pow(4, 1.2), 0.5) << "four times as many, before any was run";
  // A run with four times the unknowns tells of finer meshes.
  samples.push_back(test::sample_of(directions, {{0, 2}, {1, 0}, {0, 0}}, nothing));
  samples.back().dofs *= 4;
  samples.back().seconds *= std::pow(4, 1.2);
  EXPECT_NEAR(ratio(2), std::pow(4, 1.2), 0.5);
}

TEST(AdviceCostsTest, NothingIsKnownWithoutRuns) {
  const AdviceDirections directions = test::directions_of_formula();
  EXPECT_EQ(AdviceCosts(directions, {}).seconds(scene_point(directions)), 0);
}

}  // namespace
}  // namespace ixos
