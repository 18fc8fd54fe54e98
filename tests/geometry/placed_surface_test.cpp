// The search for the nearest point of a surface.
#include "geometry/placed_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "geometry/curve_patches.hpp"
#include "support/sphere_patches.hpp"

namespace ixos {
namespace {

constexpr int sides = 40;

/// A closed curve around the origin with a wavy radius; smooth or with straight sides.
struct Ring {
  std::vector<SurfacePatch<2>> patches;
  std::vector<Vec<2>> x;

  explicit Ring(bool smooth) {
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * M_PI * i / sides, radius = 3 + 0.3 * std::sin(5 * angle);
      x.push_back({radius * std::cos(angle), radius * std::sin(angle)});
      const int before = (i + sides - 1) % sides, next = (i + 1) % sides;
      patches.push_back(smooth ? smooth_patch({before, i, next, (i + 2) % sides}, {1, 1, 1}) : straight_patch(i, next));
      patches.back().neighbours = {before, next};
    }
  }
};

TEST(PlacedSurfaceTest, FindsTheNearestOfAllSegmentsAndTheSide) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-5, 5);
  for (const bool smooth : {true, false}) {
    const Ring ring(smooth);
    const PlacedSurface<2> curves(ring.patches, ring.x);
    for (int i = 0; i < 500; ++i) {
      const Vec<2> place{number(random), number(random)};
      const SurfaceProjection<2> projection = curves.nearest(place);
      double least = HUGE_VAL;
      int winding_half_turns = 0;
      for (int k = 0; k < sides; ++k) {
        least = std::min(least, nearest_point(curves.patch(k), ring.patches[k].smooth, place, {0.5}).distance);
        // Crossings of the ray to the right, of each segment's chords.
        for (int part = 0; part < 50; ++part) {
          const auto at = [&](int n) { return curves.patch(k).at({n / 50.0}) - place; };
          const Vec<2> a = at(part), b = at(part + 1);
          if ((a[1] > 0) != (b[1] > 0) && a[0] + (b[0] - a[0]) * a[1] / (a[1] - b[1]) > 0) ++winding_half_turns;
        }
      }
      EXPECT_NEAR(std::abs(projection.gap), least, 1e-14);
      if (least > 1e-2) {
        EXPECT_EQ(projection.gap < 0, winding_half_turns % 2 == 1);
      }
      EXPECT_NEAR(length(projection.normal), 1, 1e-12);
      const SurfaceProjection<2> near = curves.nearest(place, 0.5);
      EXPECT_EQ(near.patch, least < 0.5 ? projection.patch : -1);
    }
  }
}

TEST(PlacedSurfaceTest, BeyondAFreeEndTheDistanceIsPositiveAndAtACornerOnItsOuterSide) {
  std::vector<SurfacePatch<2>> patches{straight_patch(0, 1), straight_patch(1, 2)};
  patches[0].neighbours = {-1, 1};
  patches[1].neighbours = {0, -1};
  const std::vector<Vec<2>> x{{0, 0}, {2, 0}, {2, 2}};  // the body is above and left, x < 2, y > 0
  const PlacedSurface<2> curves(patches, x);
  EXPECT_DOUBLE_EQ(curves.nearest({1, -0.5}).gap, 0.5);
  EXPECT_DOUBLE_EQ(curves.nearest({1, 0.5}).gap, -0.5);
  EXPECT_DOUBLE_EQ(curves.nearest({5, -4}).gap, 5);  // corner
  EXPECT_DOUBLE_EQ(curves.nearest({-3, 0.1}).gap, std::hypot(3, 0.1));
  EXPECT_TRUE(curves.nearest({5, -4}).fixed[0]);
  EXPECT_EQ(curves.nearest({5, -4}).xi[0], 1);
  EXPECT_EQ(curves.nearest({5, -4}).patch, 0);  // of two that are equally near
  const Vec<2> normal = curves.nearest({5, -4}).normal;
  EXPECT_DOUBLE_EQ(normal[0], 0.6);
  EXPECT_DOUBLE_EQ(normal[1], -0.8);
}

/// Returns the numbers of `count` patches.
std::vector<int> first_patches(std::size_t count) {
  std::vector<int> result(count);
  std::iota(result.begin(), result.end(), 0);
  return result;
}

/// Whatever the nodes and the point do, the distance does not fall below the least one on the free share of the way.
TEST(PlacedSurfaceTest, TheFreeShareIsSafeAndNotShort) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const bool smooth : {true, false}) {
    int limited = 0;
    for (int i = 0; i < 200; ++i) {
      const Ring ring(smooth);
      const double angle = 3 * number(random);
      const Vec<2> place{4 * std::cos(angle), 4 * std::sin(angle)}, way{number(random), number(random)};
      std::vector<Vec<2>> ways(ring.x.size());
      for (Vec<2>& w : ways) w = {way[0] + 0.8 * number(random), way[1] + 0.8 * number(random)};
      const double least = 0.2;
      const PlacedSurface<2> placed(ring.patches, ring.x);
      const double share = placed.free_share(place, way, ways, least, first_patches(sides));
      EXPECT_GT(share, 0.1);  // the relative motion is 1.25 sqrt(2) 0.8 at most, the gap at least 0.7
      if (share < 1) ++limited;
      for (int k = 1; k <= 10; ++k) {
        std::vector<Vec<2>> moved = ring.x;
        for (std::size_t n = 0; n < moved.size(); ++n) moved[n] = moved[n] + share * k / 10 * ways[n];
        EXPECT_GE(std::abs(PlacedSurface<2>(ring.patches, moved).nearest(place + share * k / 10 * way).gap),
                  least - 1e-12);
      }
    }
    EXPECT_GT(limited, 5);
  }
  const Ring ring(true);
  const PlacedSurface<2> placed(ring.patches, ring.x);
  const auto free = [&](const Vec<2>& way, const Vec<2>& of_ring) {
    const std::vector<Vec<2>> ways(sides, of_ring);
    return placed.free_share({4, 0}, way, ways, 0.2, first_patches(sides));
  };
  EXPECT_EQ(free({-9, 3}, {-9, 3}), 1) << "a common translation changes no gap";
  EXPECT_EQ(free({9, 0}, {-9, 0}), 1) << "they move apart";
}

TEST(PlacedSurfaceTest, AGuessChangesNothing) {
  const Ring ring(true);
  const PlacedSurface<2> curves(ring.patches, ring.x);
  for (int i = 0; i < 60; ++i) {
    const double angle = 0.1 * i;
    const Vec<2> place{(3.2 + 0.05 * i) * std::cos(angle), (3.2 + 0.05 * i) * std::sin(angle)};
    const SurfaceProjection<2> plain = curves.nearest(place),
                               guessed = curves.nearest(place, 100, {(7 * i) % sides, {}});
    EXPECT_EQ(plain.patch, guessed.patch);
    EXPECT_EQ(plain.gap, guessed.gap);
    EXPECT_EQ(plain.xi, guessed.xi);
  }
}

/// Before a sphere of patches: distances to the sphere within its sag, and signs.
template <std::size_t D>
void expect_equal(const SurfaceProjection<D>& one, const SurfaceProjection<D>& other) {
  EXPECT_EQ(one.patch, other.patch);
  EXPECT_EQ(one.gap, other.gap);
  EXPECT_EQ(one.xi, other.xi);
}

/// Among patches near a ball, of a surface of these alone, a place in the ball has the same closest point as of all
/// patches.
TEST(PlacedSurfaceTest, FewPatchesGiveTheProjectionsOfAll) {
  const test::SpherePatches sphere(1, 6, Smoothing::CatmullRom);
  const PlacedSurface<3> all(sphere.patches(), sphere.x);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> number(-1, 1);
  std::size_t before = 0, after = 0;
  for (int n = 0; n < 60; ++n) {
    Vec<3> center{number(random), number(random), number(random)};
    center = 1.3 / length(center) * center;
    const double range = 0.5, radius = 0.05;
    std::vector<int> near = all.near(std::vector<Vec<3>>{center}, range + radius);
    auto subset = std::make_shared<PatchSubset>();
    subset->patches = near;
    subset->slots.assign(sphere.patches().size(), -1);
    for (std::size_t k = 0; k < near.size(); ++k)
      subset->slots[static_cast<std::size_t>(near[k])] = static_cast<int>(k);
    const PlacedSurface<3> some(sphere.patches(), sphere.x, subset);
    std::vector<int> reduced;
    some.reduce(near, center, radius, range, 0, reduced);
    before += near.size();
    after += reduced.size();
    for (int k = 0; k < 20; ++k) {
      const Vec<3> way{number(random), number(random), number(random)};
      const Vec<3> place = center + radius / std::max(1.0, length(way)) * way;
      const SurfaceProjection<3> projection = all.nearest(place, range);
      expect_equal(some.nearest_among(near, place, range), projection);
      expect_equal(some.nearest_among(reduced, place, range, {reduced.empty() ? -1 : reduced.back(), {}}), projection);
      const SurfaceProjection<3> beside = all.nearest(place + Vec<3>{1e-3, -2e-3, 1e-3}, range);
      const SurfaceProjection<3> started = some.nearest_among(reduced, place, range, {beside.patch, beside.xi});
      EXPECT_EQ(started.patch < 0, projection.patch < 0);
      if (projection.patch >= 0) {
        EXPECT_NEAR(started.gap, projection.gap, 1e-14);
      }
    }
  }
  EXPECT_LT(2 * after, before);
}

/// All other patches are farther than the closest point by its clearance, and without a closest point all are out of
/// range by it.
TEST(PlacedSurfaceTest, OtherPatchesAreFartherByTheClearance) {
  const test::SpherePatches sphere(1, 6, Smoothing::CatmullRom);
  const PlacedSurface<3> all(sphere.patches(), sphere.x);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  const double range = 0.4, slack = 0.1;
  int clearances = 0, out = 0;
  for (int n = 0; n < 300; ++n) {
    Vec<3> place{number(random), number(random), number(random)};
    place = (1.25 + 0.4 * number(random)) / length(place) * place;
    const std::vector<int> near = all.near(std::vector<Vec<3>>{place}, range + slack);
    std::vector<int> few;
    all.reduce(near, place, 0, range, slack, few);
    const std::vector<int> fewer = all.reduced(place, 0, range, slack);
    for (const SurfaceProjection<3>& projection :
         {all.nearest_among(few, place, range, {}, slack),
          all.nearest_among(fewer, place, range, {few.empty() ? -1 : few.back(), {}}, slack)}) {
      EXPECT_GE(projection.clearance, 0);
      EXPECT_LE(projection.clearance, slack);
      clearances += projection.clearance > 0.01 ? 1 : 0;
      out += projection.patch < 0 ? 1 : 0;
      for (std::size_t p = 0; p < sphere.patches().size(); ++p) {
        const int patch = static_cast<int>(p);
        if (patch == projection.patch) continue;
        const PlacedPatch<3>& placed = all.patch(patch);
        const double distance =
            nearest_point(placed, sphere.patches()[p].smooth, place, PatchBound<3>(placed).start(place)).distance;
        EXPECT_GE(distance, (projection.patch < 0 ? range : std::abs(projection.gap)) + projection.clearance - 1e-12);
      }
      if (projection.patch >= 0) {
        EXPECT_NEAR(all.nearest_on({projection.patch, PatchParameters<3>{0.5, 0.5}}, place, range).gap, projection.gap,
                    1e-14);
      }
    }
  }
  EXPECT_GT(clearances, 200);
  EXPECT_GT(out, 100);
}

TEST(PlacedSurfaceTest, BeforeASphereGapsAreThoseOfTheSphere) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const Smoothing smoothing : {Smoothing::None, Smoothing::CatmullRom}) {
    const test::SpherePatches sphere(5, 8, smoothing);
    const PlacedSurface<3> placed(sphere.patches(), sphere.x);
    double worst = 0;
    for (int i = 0; i < 300; ++i) {
      Vec<3> place{number(random), number(random), number(random)};
      place = (5 + 0.6 * number(random)) / length(place) * place;
      const SurfaceProjection<3> projection = placed.nearest(place);
      worst = std::max(worst, std::abs(projection.gap - (length(place) - 5)));
      EXPECT_NEAR(length(projection.normal), 1, 1e-12);
      EXPECT_GT(inner(projection.normal, place), 0.97 * length(place));
      double least = HUGE_VAL;
      for (int k = 0; k < static_cast<int>(sphere.patches().size()); ++k)
        least = std::min(least, nearest_point(placed.patch(k), sphere.patches()[static_cast<std::size_t>(k)].smooth,
                                              place, PatchBound<3>(placed.patch(k)).start(place))
                                    .distance);
      EXPECT_NEAR(std::abs(projection.gap), least, 1e-14);
    }
    // Sides of about 1: bilinear patches sag by h^2/(4 R). Smooth ones are of third order at the cube's corners.
    EXPECT_LT(worst, smoothing == Smoothing::None ? 0.06 : 0.01);
  }
}

/// The gradient of the distance of a cube is that of its faces, edges and corners; inside it is negative.
TEST(PlacedSurfaceTest, EdgesAndCornersOfACube) {
  const test::CubePatches cube;  // of side 2 about the origin
  const PlacedSurface<3> placed(cube.surface.patches, cube.x);
  const auto expect = [&](const Vec<3>& place, double gap, const Vec<3>& normal, int fixed) {
    const SurfaceProjection<3> projection = placed.nearest(place);
    EXPECT_NEAR(projection.gap, gap, 1e-14);
    EXPECT_NEAR(length(projection.normal - (1 / length(normal)) * normal), 0, 1e-14);
    EXPECT_EQ(projection.fixed[0] + projection.fixed[1], fixed);
  };
  expect({0.3, 0.2, 1.5}, 0.5, {0, 0, 1}, 0);
  expect({0.3, 1.3, 1.4}, 0.5, {0, 3, 4}, 1);
  expect({-1.2, 1.3, -1.6}, 0.7, {-2, 3, -6}, 2);
  expect({0.3, 0.2, -0.9}, -0.1, {0, 0, -1}, 0);
  EXPECT_EQ(placed.nearest({0, 0, 3}, 1.9).patch, -1);
}

TEST(PlacedSurfaceTest, NearPatchesAreThoseOfNearBoxes) {
  const test::SpherePatches sphere(5, 4, Smoothing::None);
  const PlacedSurface<3> placed(sphere.patches(), sphere.x);
  const std::vector<Vec<3>> point{{0, 0, 6}};
  const std::vector<int> near = placed.near(point, 1.3);
  EXPECT_GE(near.size(), 4U);
  EXPECT_LT(near.size(), 24U);
  EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
  EXPECT_TRUE(placed.near(point, 0.5).empty());
}

/// Whatever the nodes and the point do, the distance to the sphere does not fall below the least one on the free share.
TEST(PlacedSurfaceTest, TheFreeShareIsSafeInSpace) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  const test::SpherePatches sphere(5, 4, Smoothing::CatmullRom);
  const PlacedSurface<3> placed(sphere.patches(), sphere.x);
  int limited = 0;
  for (int i = 0; i < 100; ++i) {
    Vec<3> place{number(random), number(random), number(random)}, way{number(random), number(random), number(random)};
    place = 5.8 / length(place) * place;
    std::vector<Vec<3>> ways(sphere.x.size());
    for (Vec<3>& w : ways) w = {0.8 * number(random), 0.8 * number(random), 0.8 * number(random)};
    const double least = 0.2,
                 share = placed.free_share(place, way, ways, least, first_patches(sphere.patches().size()));
    EXPECT_GT(share, 0.05);
    if (share < 1) ++limited;
    for (int k = 1; k <= 5; ++k) {
      std::vector<Vec<3>> moved = sphere.x;
      for (std::size_t n = 0; n < moved.size(); ++n) moved[n] = moved[n] + share * k / 5 * ways[n];
      EXPECT_GE(std::abs(PlacedSurface<3>(sphere.patches(), moved).nearest(place + share * k / 5 * way).gap),
                least - 1e-12);
    }
  }
  EXPECT_GT(limited, 5);
}

}  // namespace
}  // namespace ixos
