#include "base/disjoint_sets.hpp"

#include <gtest/gtest.h>

namespace ixos {
namespace {

TEST(DisjointSetsTest, ASetIsNamedAfterItsLeastNumber) {
  DisjointSets sets(6);
  EXPECT_EQ(sets.of(5), 5);
  sets.join(5, 3);
  sets.join(4, 1);
  EXPECT_EQ(sets.of(5), 3);
  sets.join(5, 4);
  for (int number : {1, 3, 4, 5}) EXPECT_EQ(sets.of(number), 1) << number;
  sets.join(3, 1);  // once more
  EXPECT_EQ(sets.of(0), 0);
  EXPECT_EQ(sets.of(2), 2);
}

}  // namespace
}  // namespace ixos
