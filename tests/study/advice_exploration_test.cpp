// The order in which other choices are tried.
#include "study/advice_exploration.hpp"

#include <gtest/gtest.h>

#include "support/advice_case.hpp"

namespace ixos {
namespace {

/// The other scheme is better, the other element much worse.
double formula(double dt, double h, const AdvicePoint& point) {
  return 1 + (point[0].branch == 1 ? 0.01 : 0.1) * dt * dt - (point[1].branch == 1 ? 2 : 0.2) * h * h;
}

TEST(AdviceExplorationTest, SingleRunsThenLines) {
  const AdviceDirections directions = test::directions_of_formula();
  const AdvicePoint base{{0, 3}, {0, 2}, {0, 0}};
  std::vector<AdviceSample> samples = test::cross(directions, base, 3, 2, formula);
  std::vector<AdvicePoint> asked;
  for (int i = 0; i < 10; ++i) {
    const AdviceErrors errors(directions, base, samples, {false}, {0.0});
    const AdvicePoint next = next_exploration(directions, base, samples, errors, 0.05);
    if (next.empty()) break;
    asked.push_back(next);
    samples.push_back(test::sample_of(directions, next, formula));
  }
  // The tolerance; the element, which is worse than the scene's own, once; the scheme twice.
  const std::vector<AdvicePoint> expected{
      {{0, 1}, {0, 2}, {1, 0}}, {{0, 3}, {1, 1}, {0, 0}}, {{1, 2}, {0, 2}, {0, 0}}, {{1, 1}, {0, 2}, {0, 0}}};
  EXPECT_EQ(asked, expected);
}

TEST(AdviceExplorationTest, FailedRunsAreNotRepeated) {
  const AdviceDirections directions = test::directions_of_formula();
  const AdvicePoint base{{0, 3}, {0, 2}, {0, 0}};
  std::vector<AdviceSample> samples = test::cross(directions, base, 3, 2, formula);
  for (const AdvicePoint& point :
       {AdvicePoint{{0, 1}, {0, 2}, {1, 0}}, AdvicePoint{{0, 3}, {1, 1}, {0, 0}}, AdvicePoint{{1, 2}, {0, 2}, {0, 0}}})
    samples.push_back(test::failed_sample(point));
  const AdviceErrors errors(directions, base, samples, {false}, {0.0});
  EXPECT_TRUE(next_exploration(directions, base, samples, errors, 0.05).empty());
}

}  // namespace
}  // namespace ixos
