// Costs of settings, from runs with known costs.
#include "study/advice_costs.hpp"

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

TEST(AdviceCostsTest, NothingIsKnownWithoutRuns) {
  const AdviceDirections directions = test::directions_of_formula();
  EXPECT_EQ(AdviceCosts(directions, {}).seconds(scene_point(directions)), 0);
}

}  // namespace
}  // namespace ixos
