// The search for the nearest point of a surface.
#include "interaction/placed_curves.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace ixos {
namespace {

constexpr int sides = 40;

/// A closed curve around the origin with a wavy radius; smooth or with straight sides.
struct Ring {
  std::vector<CurveSegment> segments;
  std::vector<Planar> x;

  explicit Ring(bool smooth) {
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * M_PI * i / sides, radius = 3 + 0.3 * std::sin(5 * angle);
      x.push_back({radius * std::cos(angle), radius * std::sin(angle)});
      const int before = (i + sides - 1) % sides, next = (i + 1) % sides;
      segments.push_back(smooth ? smooth_segment({before, i, next, (i + 2) % sides}, {1, 1, 1})
                                : straight_segment(i, next));
      segments.back().neighbours = {before, next};
    }
  }
};

TEST(PlacedCurvesTest, FindsTheNearestOfAllSegmentsAndTheSide) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-5, 5);
  for (const bool smooth : {true, false}) {
    const Ring ring(smooth);
    const PlacedCurves curves(ring.segments, ring.x);
    for (int i = 0; i < 500; ++i) {
      const Planar place{number(random), number(random)};
      const SurfaceFoot foot = curves.nearest(place);
      double least = HUGE_VAL;
      int winding_half_turns = 0;
      for (int k = 0; k < sides; ++k) {
        least = std::min(least, nearest_point(ring.segments[k], curves.points(k), place).distance);
        // Crossings of the ray to the right, of each segment's chords.
        for (int part = 0; part < 50; ++part) {
          const auto at = [&](int n) {
            return ring.segments[k].sum(ring.segments[k].weights(n / 50.0), curves.points(k)) - place;
          };
          const Planar a = at(part), b = at(part + 1);
          if ((a[1] > 0) != (b[1] > 0) && a[0] + (b[0] - a[0]) * a[1] / (a[1] - b[1]) > 0) ++winding_half_turns;
        }
      }
      EXPECT_DOUBLE_EQ(std::abs(foot.gap), least);
      if (least > 1e-2) {
        EXPECT_EQ(foot.gap < 0, winding_half_turns % 2 == 1);
      }
      EXPECT_NEAR(length(foot.normal), 1, 1e-12);
      const SurfaceFoot near = curves.nearest(place, 0.5);
      EXPECT_EQ(near.segment, least < 0.5 ? foot.segment : -1);
    }
  }
}

TEST(PlacedCurvesTest, BeyondAFreeEndTheDistanceIsPositiveAndAtACornerOnItsOuterSide) {
  std::vector<CurveSegment> segments{straight_segment(0, 1), straight_segment(1, 2)};
  segments[0].neighbours = {-1, 1};
  segments[1].neighbours = {0, -1};
  const std::vector<Planar> x{{0, 0}, {2, 0}, {2, 2}};  // the body is above and left, x < 2, y > 0
  const PlacedCurves curves(segments, x);
  EXPECT_DOUBLE_EQ(curves.nearest({1, -0.5}).gap, 0.5);
  EXPECT_DOUBLE_EQ(curves.nearest({1, 0.5}).gap, -0.5);
  EXPECT_DOUBLE_EQ(curves.nearest({5, -4}).gap, 5);  // corner
  EXPECT_DOUBLE_EQ(curves.nearest({-3, 0.1}).gap, std::hypot(3, 0.1));
  EXPECT_EQ(curves.nearest({5, -4}).end, 1);
  EXPECT_EQ(curves.nearest({5, -4}).segment, 0);  // of two that are equally near
  const Planar normal = curves.nearest({5, -4}).normal;
  EXPECT_DOUBLE_EQ(normal[0], 0.6);
  EXPECT_DOUBLE_EQ(normal[1], -0.8);
}

/// Whatever the nodes and the point do, the distance does not fall below the least one on the free share of the way.
TEST(PlacedCurvesTest, TheFreeShareIsSafeAndNotShort) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const bool smooth : {true, false}) {
    int limited = 0;
    for (int i = 0; i < 200; ++i) {
      const Ring ring(smooth);
      const double angle = 3 * number(random);
      const Planar place{4 * std::cos(angle), 4 * std::sin(angle)}, way{number(random), number(random)};
      std::vector<Planar> ways(ring.x.size());
      for (Planar& w : ways) w = {way[0] + 0.8 * number(random), way[1] + 0.8 * number(random)};
      const double least = 0.2;
      const double share = PlacedCurves(ring.segments, ring.x).free_share(place, way, ways, least);
      EXPECT_GT(share, 0.1);  // the relative motion is 1.25 sqrt(2) 0.8 at most, the gap at least 0.7
      if (share < 1) ++limited;
      for (int k = 1; k <= 10; ++k) {
        std::vector<Planar> moved = ring.x;
        for (std::size_t n = 0; n < moved.size(); ++n) moved[n] = moved[n] + share * k / 10 * ways[n];
        EXPECT_GE(std::abs(PlacedCurves(ring.segments, moved).nearest(place + share * k / 10 * way).gap),
                  least - 1e-12);
      }
    }
    EXPECT_GT(limited, 5);
  }
  const Ring ring(true);
  EXPECT_EQ(PlacedCurves(ring.segments, ring.x).free_share({4, 0}, {-9, 3}, std::vector<Planar>(sides, {-9, 3}), 0.2),
            1)
      << "a common translation changes no gap";
  EXPECT_EQ(PlacedCurves(ring.segments, ring.x).free_share({4, 0}, {9, 0}, std::vector<Planar>(sides, {-9, 0}), 0.2), 1)
      << "they move apart";
}

}  // namespace
}  // namespace ixos
