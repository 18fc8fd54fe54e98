// The parts of a surface that see each other.
#include "term/pair/self_visibility.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/snapshot.hpp"
#include "geometry/curve_patches.hpp"

namespace ixos {
namespace {

/// A hairpin of straight sides of length 1 whose body is on the left of its direction: along y = 0 to x = n, one side
/// up to y = 1, and back along y = 1. Its outer side faces away from the space between the arms.
struct Hairpin {
  std::vector<SurfacePatch<2>> patches;
  std::vector<Vec<2>> x;

  Hairpin(int n, bool inner) {
    for (int i = 0; i <= n; ++i) x.push_back({static_cast<double>(i), 0});
    for (int i = n; i >= 0; --i) x.push_back({static_cast<double>(i), 1});
    if (inner) std::reverse(x.begin(), x.end());
    for (int i = 0; i + 1 < static_cast<int>(x.size()); ++i) {
      patches.push_back(straight_patch(i, i + 1));
      patches.back().neighbours = {i - 1, i + 2 < static_cast<int>(x.size()) ? i + 1 : -1};
    }
  }
};

TEST(SelfVisibilityTest, PatchesSeeThoseThatFaceThemBeyondTheExclusion) {
  const int n = 10;
  const Hairpin hairpin(n, true);
  SelfVisibility<2> visibility(hairpin.patches, hairpin.x, 4, 1.5);
  visibility.see(visibility.find(hairpin.x, 0));
  for (int p = 0; p < n; ++p) {
    // The side that lies opposite of p is 2 n - p; along the surface it is 2 (n - p) away (the bend has length 1).
    const std::vector<int>& seen = visibility.seen(static_cast<std::size_t>(p));
    const int opposite = 2 * n - p;
    EXPECT_EQ(std::count(seen.begin(), seen.end(), opposite), p <= n - 3 ? 1 : 0) << p;
    for (const int other : seen) EXPECT_GT(other, n) << "a side does not see its own arm, which lies in its plane";
    EXPECT_TRUE(visibility.is_excluded(static_cast<std::size_t>(p), p + 3));
    if (p < 5) {
      EXPECT_FALSE(visibility.is_excluded(static_cast<std::size_t>(p), p + 5));
    }
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
    for (const int other : seen) {
      const std::vector<int>& back = visibility.seen(static_cast<std::size_t>(other));
      EXPECT_EQ(std::count(back.begin(), back.end(), p), 1);
    }
  }
}

TEST(SelfVisibilityTest, TheBackOfABodyIsNotSeen) {
  const Hairpin hairpin(10, false);  // the body is between the arms
  SelfVisibility<2> visibility(hairpin.patches, hairpin.x, 4, 1.5);
  visibility.see(visibility.find(hairpin.x, 0));
  for (const std::vector<int>& seen : visibility.seen()) EXPECT_TRUE(seen.empty());
}

/// Arms that have gone through each other overlap if they saw each other before; otherwise nobody knows.
TEST(SelfVisibilityTest, ArmsThatOverlapGoOnSeeingEachOther) {
  const Hairpin hairpin(10, true);
  SelfVisibility<2> visibility(hairpin.patches, hairpin.x, 4, 1.5);
  visibility.see(visibility.find(hairpin.x, 0));
  const std::vector<std::vector<int>> before = visibility.seen();
  std::vector<Vec<2>> crossed = hairpin.x;
  for (Vec<2>& x : crossed)
    if (x[1] > 0.5) x[1] = -0.2;
  visibility.see(visibility.find(crossed, 0, &before));
  for (std::size_t p = 0; p < 6; ++p) EXPECT_EQ(visibility.seen(p), before[p]) << p;
  EXPECT_FALSE(visibility.seen(0).empty());
  visibility.see(visibility.find(crossed, 0));
  for (std::size_t p = 0; p < 6; ++p) EXPECT_TRUE(visibility.seen(p).empty()) << p;
}

TEST(SelfVisibilityTest, WhatIsSeenComesBack) {
  const Hairpin hairpin(10, true);
  SelfVisibility<2> visibility(hairpin.patches, hairpin.x, 4, 1.5);
  visibility.see(visibility.find(hairpin.x, 0));
  std::vector<std::vector<int>> seen = visibility.seen();
  Snapshot snapshot([&](Record& record) { SelfVisibility<2>::transfer(record, seen); });
  snapshot.save();
  for (std::vector<int>& own : seen) own = {3};
  snapshot.restore();
  EXPECT_EQ(seen, visibility.seen());
}

}  // namespace
}  // namespace ixos
