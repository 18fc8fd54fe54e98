#include "io/global_order.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <utility>

#include "base/gather.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::world;

constexpr int largest = 23;

/// Every fourth id is missing.
bool exists(int id) { return id % 4 != 0; }

std::vector<int> existing_ids() {
  std::vector<int> ids;
  for (int id = 1; id <= largest; ++id)
    if (exists(id)) ids.push_back(id);
  return ids;
}

std::vector<double> field_of(const std::vector<int>& ids, int field) {
  std::vector<double> values;
  values.reserve(ids.size());
  for (int id : ids) values.push_back(100.0 * field + id);
  return values;
}

/// Returns the existing ids, the largest first, that this rank holds.
std::vector<int> ids_held(const std::function<bool(int id)>& held) {
  std::vector<int> ids;
  for (int id = largest; id >= 1; --id)
    if (exists(id) && held(id)) ids.push_back(id);
  return ids;
}

/// Expects that the slabs of all ranks, one after the other, are the fields in the order of the ids.
void expect_order(const GlobalOrder& order, const std::vector<int>& mine) {
  const std::vector<int> all = existing_ids();
  const Slab& slab = order.slab();
  EXPECT_EQ(slab.total, all.size());
  const auto fields = order.ordered({field_of(mine, 0), field_of(mine, 1)});
  ASSERT_EQ(fields.size(), 2U);
  for (int f = 0; f < 2; ++f) {
    const std::vector<double> expected = field_of(all, f);
    const std::vector<double>& here = fields[static_cast<std::size_t>(f)];
    ASSERT_EQ(here.size(), slab.count);
    for (std::size_t k = 0; k < here.size(); ++k) EXPECT_EQ(here[k], expected.at(slab.offset + k)) << f;
    const std::vector<double> together = gather(here, world());
    if (world()->getRank() == 0) {
      EXPECT_EQ(together, expected) << f;
    }
  }
}

TEST(GlobalOrderTest, SortsWhateverTheRanksHold) {
  const int rank = world()->getRank(), ranks = world()->getSize();
  const std::vector<std::function<bool(int)>> ways{
      [=](int id) { return id % ranks == rank; },                 // in turns
      [=](int id) { return id % ranks == rank || id % 3 == 0; },  // several ranks hold every third
      [=](int) { return rank + 1 == ranks; }};                    // the last rank holds all
  for (const auto& held : ways) {
    const std::vector<int> mine = ids_held(held);
    expect_order(GlobalOrder(world(), mine, largest), mine);
  }
}

TEST(GlobalOrderTest, CanBeMoved) {
  const int rank = world()->getRank(), ranks = world()->getSize();
  const std::vector<int> mine = ids_held([=](int id) { return id % ranks == rank; });
  GlobalOrder first(world(), mine, largest);
  const GlobalOrder second(std::move(first));
  expect_order(second, mine);
}

TEST(GlobalOrderTest, NothingHasAnOrderToo) {
  const GlobalOrder order(world(), {}, 0);
  EXPECT_EQ(order.slab().count, 0U);
  EXPECT_EQ(order.slab().total, 0U);
  const std::vector<std::vector<double>> one_empty_field(1);
  EXPECT_EQ(order.ordered(one_empty_field), one_empty_field);
}

}  // namespace
}  // namespace ixos
