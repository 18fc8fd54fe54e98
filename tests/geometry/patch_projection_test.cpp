// Nearest points of patches.
#include "geometry/patch_projection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "geometry/curve_patches.hpp"
#include "geometry/face_patches.hpp"
#include "geometry/patch_bound.hpp"

namespace ixos {
namespace {

TEST(PatchProjectionTest, TheNearestPointOfACurveIsTheLeastOfManyPoints) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  const std::vector<SurfacePatch<2>> patches{straight_patch(1, 2), smooth_patch({0, 1, 2, 3}, {1.0, 1.0, 1.0}),
                                             smooth_patch({0, 1, 2, 3}, {0.2, 1.0, 3.0}),
                                             smooth_patch({-1, 1, 2, 3}, {0, 1.0, 0.5})};
  int inside = 0;
  for (int i = 0; i < 400; ++i) {
    const std::array<Vec<2>, 4> nodes{
        {{-1, 0.3 * number(random)}, {0, 0.3 * number(random)}, {1, 0.3 * number(random)}, {2, 0.3 * number(random)}}};
    const Vec<2> place{0.5 + 1.5 * number(random), number(random)};
    for (const SurfacePatch<2>& patch : patches) {
      SurfacePatch<2>::Points x{};
      for (std::size_t a = 0; a < patch.count; ++a) x[a] = nodes[static_cast<std::size_t>(patch.nodes[a])];
      const PlacedPatch<2> placed = patch.placed(x);
      const PatchProjection<2> projection =
          nearest_point(placed, patch.smooth, place, PatchBound<2>(placed).start(place));
      double least = HUGE_VAL;
      for (int k = 0; k <= 400; ++k) least = std::min(least, length(placed.at({k / 400.0}) - place));
      EXPECT_LE(projection.distance, least + 1e-15);
      EXPECT_GT(projection.distance, least - 5e-3);
      const auto frame = placed.frame(projection.xi);
      const double t = projection.xi[0];
      if (t > 0 && t < 1) {
        ++inside;
        EXPECT_NEAR(inner(frame.place - place, frame.tangents[0]), 0, 1e-12);
        EXPECT_FALSE(projection.fixed[0]);
      } else {
        EXPECT_EQ(projection.fixed[0], !patch.smooth[t == 0 ? 0 : 1]);
      }
    }
  }
  EXPECT_GT(inside, 400);
}

/// Wherever the search starts, near a curve that bends little and far away, where the distance has several minima.
TEST(PatchProjectionTest, TheStartOfASearchAlongACurveChangesRoundingOnly) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  const SurfacePatch<2> patch = smooth_patch({0, 1, 2, 3}, {1.0, 1.0, 1.0});
  for (int i = 0; i < 300; ++i) {
    SurfacePatch<2>::Points x{};
    for (std::size_t a = 0; a < 4; ++a) x[a] = {static_cast<double>(patch.nodes[a]), 0.3 * number(random)};
    const PlacedPatch<2> placed = patch.placed(x);
    const Vec<2> place{1.5 + 1.5 * number(random), (i % 2 == 0 ? 0.3 : 4) * number(random)};
    const double distance = nearest_point(placed, patch.smooth, place, {0.5}).distance;
    for (const double start : {0.0, 0.2, 0.999, 1.0})
      EXPECT_NEAR(nearest_point(placed, patch.smooth, place, {start}).distance, distance, 2e-15 * (1 + distance));
  }
}

/// A bicubic patch over a unit square with random heights at the 16 nodes of its grid.
SurfacePatch<3> bicubic() {
  std::array<CornerDerivatives, 4> derivatives;
  const std::array<std::array<int, 2>, 4> places{{{1, 1}, {2, 1}, {2, 2}, {1, 2}}};
  const auto a = parabola_slope(1, 1);
  for (std::size_t c = 0; c < 4; ++c)
    for (int k = 0; k < 3; ++k) {
      const auto [i, j] = places[c];
      const double own = a[static_cast<std::size_t>(k)];
      derivatives[c].first.add(4 * j + i + k - 1, own);
      derivatives[c].second.add(4 * (j + k - 1) + i, own);
      for (int l = 0; l < 3; ++l)
        derivatives[c].mixed.add(4 * (j + l - 1) + i + k - 1, own * a[static_cast<std::size_t>(l)]);
    }
  return bicubic_patch({5, 6, 10, 9}, derivatives, {1, 1});
}

TEST(PatchProjectionTest, TheNearestPointOfAFaceIsTheLeastOfManyPoints) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> number(-1, 1);
  int inside = 0, edges = 0, corners = 0;
  for (int i = 0; i < 150; ++i)
    for (SurfacePatch<3> patch : {bilinear_patch({5, 6, 10, 9}), bicubic()}) {
      patch.smooth = {true, false, false, true};
      SurfacePatch<3>::Points x{};
      for (std::size_t a = 0; a < patch.count; ++a) {
        const int node = patch.nodes[a];
        x[a] = {node % 4 - 1 + 0.1 * number(random), node / 4 - 1 + 0.1 * number(random), 0.15 * number(random)};
      }
      const PlacedPatch<3> placed = patch.placed(x);
      const Vec<3> place{0.5 + number(random), 0.5 + number(random), 0.8 * number(random)};
      const PatchProjection<3> projection =
          nearest_point(placed, patch.smooth, place, PatchBound<3>(placed).start(place));
      double least = HUGE_VAL;
      for (int k = 0; k <= 60; ++k)
        for (int l = 0; l <= 60; ++l) least = std::min(least, length(placed.at({k / 60.0, l / 60.0}) - place));
      EXPECT_LE(projection.distance, least + 1e-14);
      EXPECT_GT(projection.distance, least - 2e-2);
      const auto frame = placed.frame(projection.xi);
      int bounds = 0;
      for (std::size_t k = 0; k < 2; ++k) {
        const double slope = inner(frame.place - place, frame.tangents[k]), t = projection.xi[k];
        if (t > 0 && t < 1) {
          EXPECT_NEAR(slope, 0, 1e-12);
          EXPECT_FALSE(projection.fixed[k]);
        } else {
          ++bounds;
          EXPECT_GE(t == 0 ? slope : -slope, -1e-12);
          EXPECT_EQ(projection.fixed[k], !patch.smooth[2 * k + (t == 0 ? 0 : 1)]);
        }
      }
      ++(bounds == 0 ? inside : bounds == 1 ? edges : corners);
    }
  EXPECT_GT(inside, 30);
  EXPECT_GT(edges, 30);
  EXPECT_GT(corners, 10);
}

}  // namespace
}  // namespace ixos
