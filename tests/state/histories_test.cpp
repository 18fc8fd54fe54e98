// Histories of all terms are a value.
#include "state/histories.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <utility>

#include "state/history.hpp"

namespace ixos {
namespace {

TermHistory seen(std::vector<int> patches) {
  TermHistory history;
  history.lists = {std::move(patches)};
  return history;
}

TEST(TermHistoriesTest, ACopyIsAnotherValue) {
  TermHistories all({seen({1, 2}), seen({3})});
  const TermHistories copy = all;
  EXPECT_TRUE(copy == all);
  all.of(0).lists[0].push_back(7);
  EXPECT_TRUE(copy != all);
  EXPECT_EQ(copy.of(0).lists[0], (std::vector<int>{1, 2}));
  TermHistories moved = std::move(all);
  EXPECT_EQ(moved.of(0).lists[0].back(), 7);
  moved = copy;
  EXPECT_TRUE(moved == copy);
}

TEST(TermHistoriesTest, NumbersOfTheLastStepDoNotCount) {
  TermHistories all({seen({1})}), other = all;
  other.of(0).last_step = {0.5};
  EXPECT_TRUE(all == other);
}

TEST(TermHistoriesTest, FurtherSlotsAreAdded) {
  TermHistories all({seen({1})});
  all.extend(TermHistories({seen({5}), seen({6})}));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all.of(0).lists[0], std::vector<int>{1}) << "what there was stays";
  EXPECT_EQ(all.of(1).lists[0], std::vector<int>{6});
  all.extend(TermHistories());
  EXPECT_EQ(all.size(), 2U);
}

TEST(TermHistoriesTest, ASlotWithoutAHistoryIsAMistakeOfTheProgram) {
  const TermHistories none;
  EXPECT_THROW(none.of(0), std::logic_error);
}

}  // namespace
}  // namespace ixos
