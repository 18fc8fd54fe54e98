// The order in which other choices are tried.
#include "study/advice/advice_exploration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/advice_case.hpp"

namespace ixos {
namespace {

/// The other scheme is better, the other element much worse.
double formula(double dt, double h, const AdvicePoint& point) {
  return 1 + (point[0].branch == 1 ? 0.01 : 0.1) * dt * dt - (point[1].branch == 1 ? 2 : 0.2) * h * h;
}

class AdviceExplorationTest : public testing::Test {
 protected:
  std::vector<AdviceTrial> trials(double tolerance) const {
    const AdviceErrors errors(directions_, base_, samples_, {false}, {0.0});
    return explorations(directions_, base_, plan_, samples_, errors, tolerance);
  }
  /// Runs all trials, round after round, and returns the levels of a direction in their order.
  std::vector<std::size_t> levels(std::size_t d, double tolerance) {
    std::vector<std::size_t> found;
    for (int round = 0; round < 10; ++round)
      for (const AdviceTrial& trial : trials(tolerance)) {
        if (trial.direction == d) found.push_back(trial.point[d].level);
        samples_.push_back(test::sample_of(directions_, trial.point, formula));
      }
    return found;
  }
  const AdviceDirections directions_ = test::directions_of_formula();
  const AdvicePoint base_{{0, 2}, {0, 1}, {0, 0}}, plan_{{0, 3}, {0, 2}, {0, 0}};
  std::vector<AdviceSample> samples_ = test::cross(directions_, base_, 3, 2, formula);
};

TEST_F(AdviceExplorationTest, EachChoiceIsTriedBesideTheBase) {
  const std::vector<AdviceTrial> found = trials(0.05);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].point, (AdvicePoint{{1, 1}, {0, 1}, {0, 0}})) << "the scheme, two levels coarser than the plan";
  EXPECT_EQ(found[1].point, (AdvicePoint{{0, 2}, {1, 0}, {0, 0}})) << "the element";
  EXPECT_EQ(found[2].point, (AdvicePoint{{0, 2}, {0, 1}, {1, 0}})) << "the tolerance";
  EXPECT_GT(found[1].saving, found[0].saving) << "a mesh of half the cells saves more than half the steps";
}

TEST_F(AdviceExplorationTest, ALawThatDoesNotHoldIsNotTried) {
  AdviceDirections directions = directions_;
  directions.all[2].branches[1].law = "Linear Elastic";
  const auto tries_law = [&](const MeasuredStrains& strains) {
    samples_.front().strains = strains;
    const AdviceErrors errors(directions, base_, samples_, {false}, {0.0});
    const std::vector<AdviceTrial> found = explorations(directions, base_, plan_, samples_, errors, 0.05);
    return std::any_of(found.begin(), found.end(), [](const AdviceTrial& trial) { return trial.direction == 2; });
  };
  EXPECT_TRUE(tries_law({0.1, -0.01, 0.01}));
  EXPECT_FALSE(tries_law({std::atan(1.0), -0.01, 0.01})) << "45 degrees";
  EXPECT_FALSE(tries_law({0, -0.06, 0})) << "compressed by more than the tolerance";
}

TEST_F(AdviceExplorationTest, WhatIsWithinTheToleranceIsTriedCoarser) {
  // An error of 0.01 dt^2 at a step of 1/2, and the uncertainty of the limit.
  EXPECT_EQ(levels(time_direction, 0.05), (std::vector<std::size_t>{1, 0}));
}

TEST_F(AdviceExplorationTest, WhatIsWorseThanTheScenesOwnIsTriedOnce) {
  EXPECT_EQ(levels(mesh_direction, 0.01), std::vector<std::size_t>{0});
}

TEST_F(AdviceExplorationTest, WhatIsBetterButNotGoodEnoughIsTriedFiner) {
  const std::vector<std::size_t> found = levels(time_direction, 1e-5);
  ASSERT_GE(found.size(), 3U);
  EXPECT_EQ(found[0], 1U);
  EXPECT_EQ(found[1], 2U);
  EXPECT_LE(*std::max_element(found.begin(), found.end()), 3U) << "finer than the plan";
}

TEST_F(AdviceExplorationTest, FailedRunsAreNotRepeated) {
  for (const AdviceTrial& trial : trials(0.05)) samples_.push_back(test::failed_sample(trial.point));
  EXPECT_TRUE(trials(0.05).empty());
}

TEST_F(AdviceExplorationTest, ABetterChoicePromisesMore) {
  for (const AdviceTrial& trial : trials(1e-4)) samples_.push_back(test::sample_of(directions_, trial.point, formula));
  const std::vector<AdviceTrial> next = trials(1e-4);
  ASSERT_EQ(next.size(), 1U);
  EXPECT_EQ(next[0].direction, time_direction);
  EXPECT_GT(next[0].promise, 1);
}

// One quantity has an uncertain limit, which says nothing of the other quantity.
TEST_F(AdviceExplorationTest, EachQuantityIsComparedWithItself) {
  const auto both = [&](const AdvicePoint& point) {
    AdviceSample sample = test::sample_of(directions_, point, formula);
    sample.values.push_back(point[0].level % 2 == 0 ? 1.2 : 0.8);
    return sample;
  };
  std::vector<AdviceSample> samples;
  for (const AdviceSample& sample : samples_) samples.push_back(both(sample.point));
  samples.push_back(both({{1, 1}, {0, 1}, {0, 0}}));
  const AdviceErrors errors(directions_, base_, samples, {false, false}, {0.0, 0.0});
  double promise = 0;
  for (const AdviceTrial& trial : explorations(directions_, base_, plan_, samples, errors, 1e-3))
    if (trial.direction == time_direction) promise = trial.promise;
  EXPECT_GT(promise, 3) << "ten times as accurate";
}

}  // namespace
}  // namespace ixos
