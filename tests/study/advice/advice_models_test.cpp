// Runs of other models beside those of the scene's own.
#include "study/advice/advice_models.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "support/advice_case.hpp"

namespace ixos {
namespace {

class AdviceModelsTest : public testing::Test {
 protected:
  /// Adds a good run whose column rises to `middle` at 1, and to 4 at 2, which decides.
  void add(const AdvicePoint& point, double middle) {
    AdviceSample sample;
    sample.point = point;
    sample.good = true;
    sample.values = {4};
    ColumnHistory column{{0, 1, 2}, {0, middle, 4}, 2};
    sample.histories = std::make_shared<const std::vector<ColumnHistory>>(1, std::move(column));
    samples_.push_back(sample);
  }
  std::vector<AdviceComparison> comparisons(std::size_t i) {
    compare_models(directions_, samples_, samples_[i]);
    return samples_[i].comparisons;
  }
  AdviceDirections directions_ = test::directions_of_formula();
  std::vector<AdviceSample> samples_;
};

TEST_F(AdviceModelsTest, AReplacedModelIsComparedWithItsTwin) {
  add({{0, 2}, {0, 0}, {0, 0}}, 2);
  add({{0, 2}, {0, 1}, {0, 0}}, 2.5);
  add({{0, 2}, {0, 0}, {1, 0}}, 3);  // a quarter of 4 away from the first
  const auto found = comparisons(2);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].direction, 2U);
  ASSERT_EQ(found[0].differences.size(), 1U);
  EXPECT_NEAR(found[0].differences[0], 0.25, 1e-15);
  EXPECT_TRUE(comparisons(0).empty()) << "the scene's own model";
}

TEST_F(AdviceModelsTest, WithoutATwinThereIsNoComparison) {
  add({{0, 2}, {0, 1}, {0, 0}}, 2);
  add({{0, 2}, {0, 0}, {1, 0}}, 2);
  EXPECT_TRUE(comparisons(1).empty()) << "another mesh";
  add({{0, 2}, {0, 0}, {0, 0}}, 2);
  samples_.back().good = false;
  EXPECT_TRUE(comparisons(1).empty()) << "a run that failed";
}

TEST_F(AdviceModelsTest, SchemesWithoutInertiaAreComparedWithTheFinestSteps) {
  add({{0, 1}, {0, 0}, {0, 0}}, 3);
  add({{0, 3}, {0, 0}, {0, 0}}, 2);
  add({{1, 1}, {0, 0}, {0, 0}}, 3);
  EXPECT_TRUE(comparisons(2).empty()) << "another scheme has the same limit";
  directions_.all[time_direction].branches[1].same_limit = false;
  const auto found = comparisons(2);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].differences[0], 0.25, 1e-15);
}

}  // namespace
}  // namespace ixos
