// Candidates by cost and error.
#include "study/advice/advice_plan.hpp"

#include <gtest/gtest.h>

#include "support/advice_case.hpp"

namespace ixos {
namespace {

double smooth(double dt, double h, const AdvicePoint&) { return 1 + 0.1 * dt * dt - 0.2 * h * h; }

class AdvicePlanTest : public testing::Test {
 protected:
  std::vector<AdviceCandidate> all(std::size_t beyond) const {
    return candidates(directions_, AdviceErrors(directions_, base_, samples_, {false}, {0.0}),
                      AdviceCosts(directions_, samples_), beyond);
  }
  const AdviceDirections directions_ = test::directions_of_formula();
  const AdvicePoint base_{{0, 2}, {0, 0}, {0, 0}};
  const std::vector<AdviceSample> samples_ = test::cross(directions_, base_, 3, 2, smooth);
};

TEST_F(AdvicePlanTest, CombinesWhatWasTested) {
  EXPECT_EQ(all(0).size(), 4U * 3U) << "steps times meshes";
  EXPECT_EQ(all(1).size(), 5U * 4U);
  EXPECT_EQ(all(9).size(), 5U * 4U) << "there are no more levels";
  const std::vector<AdviceCandidate> sorted = all(1);
  for (std::size_t i = 1; i < sorted.size(); ++i) EXPECT_LE(sorted[i - 1].seconds, sorted[i].seconds);
}

TEST_F(AdvicePlanTest, TheCheapestWithinATolerance) {
  const std::vector<AdviceCandidate> sorted = all(0);
  const AdviceCandidate* found = cheapest_within(sorted, 0.07);
  ASSERT_NE(found, nullptr);
  for (const AdviceCandidate& each : sorted) {
    if (each.seconds >= found->seconds) break;
    EXPECT_GT(each.error, 0.07) << description_of(directions_, each.point);
  }
  EXPECT_EQ(found->point, (AdvicePoint{{0, 1}, {0, 2}, {0, 0}})) << "0.025 and three times 0.0125";
  EXPECT_EQ(cheapest_within(sorted, 1e-6), nullptr);
  EXPECT_EQ(most_accurate(sorted)->point, (AdvicePoint{{0, 3}, {0, 2}, {0, 0}}));
  EXPECT_EQ(most_accurate({}), nullptr);
}

TEST_F(AdvicePlanTest, TradesImprove) {
  const std::vector<AdviceCandidate> best = best_trades(all(0));
  ASSERT_GT(best.size(), 2U);
  for (std::size_t i = 1; i < best.size(); ++i) {
    EXPECT_LT(best[i].error, best[i - 1].error);
    EXPECT_GE(best[i].seconds, best[i - 1].seconds);
  }
}

}  // namespace
}  // namespace ixos
