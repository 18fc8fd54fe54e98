// The patches of two surfaces that are near each other.
#include "geometry/pair_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/two_bodies.hpp"

namespace ixos {
namespace {

/// Two disks of radius 3 whose centres are 7 apart.
struct Disks {
  LocalMesh mesh;
  PairSurfaces<2> surfaces;
  PairPlaces<2> places;

  Disks() {
    const Mesh disks = test::two_disks(3, {7, 0}, 8, 2);
    mesh = localize(disks, partition_nodes(disks, 1), 0, 1, {"a_surface", "b_surface"});
    const auto surface = [&](const char* set) {
      return surface_patches<2>(mesh, mesh.whole_side_sets.at(set), Smoothing::CatmullRom, set);
    };
    surfaces = {surface("a_surface"), surface("b_surface")};
    for (const int node : surfaces.secondary.nodes) places.secondary.push_back(reference_place<2>(mesh, node));
    for (const int node : surfaces.primary.nodes) places.primary.push_back(reference_place<2>(mesh, node));
  }
  PairPlaces<2> moved(const Vec<2>& secondary, const Vec<2>& primary) const {
    PairPlaces<2> result = places;
    for (Vec<2>& x : result.secondary) x = x + secondary;
    for (Vec<2>& x : result.primary) x = x + primary;
    return result;
  }
  /// Returns the gaps of points along the secondary surface, within the range: of closest points among the neighbours,
  /// or among all patches.
  std::vector<double> gaps(const PairPlaces<2>& at, double range, const PairNeighbours* neighbours) const {
    const PlacedSurface<2> secondary(surfaces.secondary.patches, at.secondary),
        primary(surfaces.primary.patches, at.primary);
    std::vector<double> result;
    for (std::size_t s = 0; s < surfaces.secondary.patches.size(); ++s)
      for (const double t : {0.0, 0.2, 0.5, 0.9}) {
        const Vec<2> place = secondary.patch(static_cast<int>(s)).at({t});
        SurfaceProjection<2> projection;
        if (neighbours == nullptr) {
          projection = primary.nearest(place, range);
        } else {
          const auto found = std::lower_bound(neighbours->secondary.begin(), neighbours->secondary.end(), s);
          if (found != neighbours->secondary.end() && *found == s)
            projection = primary.nearest_among(
                neighbours->primary[static_cast<std::size_t>(found - neighbours->secondary.begin())], place, range);
        }
        result.push_back(projection.gap);
      }
    return result;
  }
};

TEST(PairSearchSerialTest, ItsNeighboursHaveAllProjectionsWhereverTheyHold) {
  const Disks disks;
  PairSearch<2> search(disks.surfaces, 0.2);
  const double range = 2;
  const auto first = search.cover({&disks.places}, range);
  EXPECT_LT(first->secondary.size(), disks.surfaces.secondary.patches.size());
  EXPECT_LT(first->together->patches.size(), disks.surfaces.primary.patches.size());
  for (const double x : {0.0, 0.05, 0.1, 0.2, 0.6, -1.5}) {
    const PairPlaces<2> at = disks.moved({x, 0.3 * x}, {-x, 0.1 * x});
    const auto held = search.cover({&at}, range);
    EXPECT_EQ(disks.gaps(at, range, held.get()), disks.gaps(at, range, nullptr));
  }
  EXPECT_GT(search.searches(), 1);
  EXPECT_LT(search.searches(), 6);
}

TEST(PairSearchSerialTest, ACommonMotionAndASmallerRangeNeedNoSearch) {
  const Disks disks;
  PairSearch<2> search(disks.surfaces, 0.2);
  const auto first = search.cover({&disks.places}, 2);
  const PairPlaces<2> away = disks.moved({100, -50}, {100, -50});
  EXPECT_EQ(search.cover({&away}, 2), first);
  EXPECT_EQ(search.cover({&disks.places}, 1), first);
  EXPECT_EQ(search.searches(), 1);
  EXPECT_NE(search.cover({&disks.places}, 3), first);
  EXPECT_EQ(search.searches(), 2);
}

TEST(PairSearchSerialTest, OneSearchCoversFastBodies) {
  const Disks disks;
  PairSearch<2> search(disks.surfaces, 0.2);
  const PairPlaces<2> end = disks.moved({20, 0}, {-20, 0});
  const auto neighbours = search.cover({&disks.places, &end}, 2);
  EXPECT_EQ(search.searches(), 1);
  for (const double t : {0.0, 0.1, 0.5, 1.0}) {
    const PairPlaces<2> at = disks.moved({20 * t, 0}, {-20 * t, 0});
    EXPECT_EQ(disks.gaps(at, 2, neighbours.get()), disks.gaps(at, 2, nullptr));
  }
}

TEST(PairSearchSerialTest, WithoutARangeProjectionsAreAmongFewPatchesWhereverTheyHold) {
  const Disks disks;
  PairSearch<2> search(disks.surfaces, 0.2);
  std::size_t most = 0;
  for (const double x : {0.0, 0.1, 0.3, 0.6, -1.5}) {
    const PairPlaces<2> at = disks.moved({x, 0.3 * x}, {-x, 0.1 * x});
    const auto held = search.cover({&at}, HUGE_VAL);
    EXPECT_EQ(held->secondary.size(), disks.surfaces.secondary.patches.size());
    EXPECT_EQ(disks.gaps(at, HUGE_VAL, held.get()), disks.gaps(at, HUGE_VAL, nullptr));
    for (const std::vector<int>& few : held->primary) most = std::max(most, few.size());
  }
  EXPECT_LT(most, disks.surfaces.primary.patches.size());
  EXPECT_GT(search.searches(), 1);
  EXPECT_LT(search.searches(), 5);
}

/// The disks nearly touch, and nodes move at random as far as the lists hold.
TEST(PairSearchSerialTest, ListsWithoutARangeHaveAllThatAreFartherByTheClearance) {
  const Disks disks;
  const double clearance = 0.2;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  std::size_t missed = 0, listed = 0;
  for (int n = 0; n < 20; ++n) {
    PairSearch<2> search(disks.surfaces, clearance);
    const PairPlaces<2> start = disks.moved({0.95, 0.1 * n}, {0, 0});
    const auto held = search.cover({&start}, HUGE_VAL);
    PairPlaces<2> at = start;
    for (auto* x : {&at.secondary, &at.primary})
      for (Vec<2>& place : *x) place = place + Vec<2>{0.05 * number(random), 0.05 * number(random)};
    ASSERT_EQ(search.cover({&at}, HUGE_VAL), held) << "they hold";
    const PlacedSurface<2> secondary(disks.surfaces.secondary.patches, at.secondary),
        primary(disks.surfaces.primary.patches, at.primary);
    const std::vector<SurfacePatch<2>>& patches = disks.surfaces.primary.patches;
    for (std::size_t s = 0; s < held->secondary.size(); ++s)
      for (const double t : {0.0, 0.3, 0.6, 1.0}) {
        const Vec<2> place = secondary.patch(static_cast<int>(s)).at({t});
        const double least = std::abs(primary.nearest(place).gap);
        for (std::size_t p = 0; p < patches.size(); ++p) {
          const PlacedPatch<2>& patch = primary.patch(static_cast<int>(p));
          const double distance =
              nearest_point(patch, patches[p].smooth, place, PatchBound<2>(patch).start(place)).distance;
          if (distance > least + clearance) continue;
          ++listed;
          const std::vector<int>& own = held->primary[s];
          if (!std::binary_search(own.begin(), own.end(), static_cast<int>(p))) ++missed;
        }
      }
  }
  EXPECT_EQ(missed, 0U);
  EXPECT_GT(listed, 5000U);
}

/// After a step in which the bodies moved far, lists are as short as before.
TEST(PairSearchSerialTest, WideListsEndWithTheStep) {
  const Disks disks;
  for (const double range : {1.0, HUGE_VAL}) {
    PairSearch<2> search(disks.surfaces, 0.2);
    const auto count = [](const PairNeighbours& near) {
      std::size_t sum = 0;
      for (const std::vector<int>& few : near.primary) sum += few.size();
      return sum;
    };
    const std::size_t few = count(*search.cover({&disks.places}, range));
    const PairPlaces<2> away = disks.moved({30, 0}, {-30, 0});
    EXPECT_GT(count(*search.cover({&disks.places, &away}, range)), 2 * few);
    EXPECT_GT(count(*search.cover({&disks.places}, range)), 2 * few);
    search.begin_step();
    EXPECT_EQ(count(*search.cover({&disks.places}, range)), few);
  }
}

TEST(PairSearchSerialTest, PlacesThatAreNoNumbersAreNotSearched) {
  const Disks disks;
  PairSearch<2> search(disks.surfaces, 0.2);
  PairPlaces<2> broken = disks.places;
  broken.primary.back()[1] = std::nan("");
  const auto neighbours = search.cover({&disks.places, &broken}, 2);
  EXPECT_EQ(neighbours->secondary.size(), disks.surfaces.secondary.patches.size());
  for (const std::vector<int>& none : neighbours->primary) EXPECT_TRUE(none.empty());
  EXPECT_EQ(search.searches(), 0);
}

/// Nodes move at random; no gap changes by more than the bound.
TEST(PairSearchSerialTest, TheMotionBoundsTheChangeOfAGap) {
  const Disks disks;
  const PairSearch<2> search(disks.surfaces, 0.2);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-0.2, 0.2);
  const std::vector<double> before = disks.gaps(disks.places, 100, nullptr);
  for (int n = 0; n < 20; ++n) {
    PairPlaces<2> at = disks.moved({5, 5}, {5, 5});
    for (auto* x : {&at.secondary, &at.primary})
      for (Vec<2>& place : *x) place = place + Vec<2>{number(random), number(random)};
    const std::vector<double> after = disks.gaps(at, 100, nullptr);
    double largest = 0;
    for (std::size_t k = 0; k < after.size(); ++k) largest = std::max(largest, std::abs(after[k] - before[k]));
    EXPECT_LE(largest, search.motion(disks.places, at));
    EXPECT_GT(largest, 0.1 * search.motion(disks.places, at));
  }
}

}  // namespace
}  // namespace ixos
