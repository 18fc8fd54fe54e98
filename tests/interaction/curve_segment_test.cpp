// Sides as curves, and their nearest points.
#include "interaction/curve_segment.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace ixos {
namespace {

const std::array<CurveSegment, 4> segments() {
  return {straight_segment(0, 1), smooth_segment({0, 1, 2, 3}, {1.0, 1.0, 1.0}),
          smooth_segment({0, 1, 2, 3}, {0.2, 1.0, 3.0}), smooth_segment({-1, 1, 2, 3}, {0, 1.0, 0.5})};
}

/// Returns the places of a segment's nodes, of places by node.
CurveSegment::Points of_nodes(const CurveSegment& segment, const std::array<Planar, 4>& x) {
  CurveSegment::Points result{};
  for (std::size_t a = 0; a < segment.count; ++a) result[a] = x[static_cast<std::size_t>(segment.nodes[a])];
  return result;
}

TEST(CurveSegmentTest, EqualLengthsGiveCatmullAndRomsWeights) {
  const CurveSegment segment = smooth_segment({0, 1, 2, 3}, {2, 2, 2});
  for (double t : {0.0, 0.3, 0.8, 1.0}) {
    const std::array<double, 4> expected{(-t + 2 * t * t - t * t * t) / 2, (2 - 5 * t * t + 3 * t * t * t) / 2,
                                         (t + 4 * t * t - 3 * t * t * t) / 2, (-t * t + t * t * t) / 2};
    const auto n = segment.weights(t);
    for (std::size_t a = 0; a < 4; ++a) EXPECT_NEAR(n[a], expected[static_cast<std::size_t>(segment.nodes[a])], 1e-15);
  }
}

TEST(CurveSegmentTest, AFreeEndIsThatOfAnExtrapolatedNode) {
  const CurveSegment open = smooth_segment({-1, 1, 2, 3}, {0, 2, 2}), whole = smooth_segment({0, 1, 2, 3}, {2, 2, 2});
  const std::array<Planar, 4> x{{{-1.5, -0.5}, {0.25, 0}, {2, 0.5}, {3, 2}}};  // x_0 = 2 x_1 - x_2
  for (double t : {0.0, 0.4, 0.9}) {
    const Planar a = open.sum(open.weights(t), of_nodes(open, x)), b = whole.sum(whole.weights(t), of_nodes(whole, x));
    EXPECT_NEAR(length(a - b), 0, 1e-15);
  }
  EXPECT_FALSE(open.smooth[0]);
  EXPECT_TRUE(open.smooth[1]);
}

/// With uneven sides the curve through points of a parabola in its length is that parabola.
TEST(CurveSegmentTest, UnevenSidesReproduceParabolas) {
  const std::array<double, 3> lengths{0.3, 1.0, 2.5};
  const CurveSegment segment = smooth_segment({0, 1, 2, 3}, lengths);
  const std::array<double, 4> s{0, 0.3, 1.3, 3.8};
  std::array<Planar, 4> x;
  for (std::size_t a = 0; a < 4; ++a) x[a] = {1 + s[a], 2 * s[a] - 0.7 * s[a] * s[a]};
  for (double t : {0.1, 0.5, 0.95}) {
    const double here = s[1] + t;
    const Planar place = segment.sum(segment.weights(t), of_nodes(segment, x));
    EXPECT_NEAR(place[0], 1 + here, 1e-14);
    EXPECT_NEAR(place[1], 2 * here - 0.7 * here * here, 1e-14);
  }
}

TEST(CurveSegmentTest, SlopesAndCurvaturesAreDerivativesAndTheHullContainsTheCurve) {
  const std::array<Planar, 4> nodes{{{0, 0}, {1, 0.3}, {2, -0.2}, {2.5, 1}}};
  for (const CurveSegment& segment : segments()) {
    const auto x = of_nodes(segment, nodes), hull = segment.hull(x);
    const double h = 1e-5;
    for (double t : {0.2, 0.7}) {
      const Planar ahead = segment.sum(segment.weights(t + h), x), behind = segment.sum(segment.weights(t - h), x);
      EXPECT_NEAR(length(0.5 / h * (ahead - behind) - segment.sum(segment.slopes(t), x)), 0, 1e-9);
      const Planar up = segment.sum(segment.slopes(t + h), x), down = segment.sum(segment.slopes(t - h), x);
      EXPECT_NEAR(length(0.5 / h * (up - down) - segment.sum(segment.curvatures(t), x)), 0, 1e-9);
      double sum = 0;
      for (double n : segment.weights(t)) sum += n;
      EXPECT_NEAR(sum, 1, 1e-15);
      // Inside the hull: in every direction some hull point is farther.
      for (int k = 0; k < 32; ++k) {
        const Planar direction{std::cos(0.2 * k), std::sin(0.2 * k)};
        double most = -HUGE_VAL;
        for (const Planar& p : hull) most = std::max(most, dot(p, direction));
        EXPECT_LE(dot(segment.sum(segment.weights(t), x), direction), most + 1e-15);
      }
    }
  }
}

TEST(CurveSegmentTest, TheNearestPointIsTheLeastOfManyPoints) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  int inside = 0;
  for (int i = 0; i < 400; ++i) {
    const std::array<Planar, 4> nodes{
        {{-1, 0.3 * number(random)}, {0, 0.3 * number(random)}, {1, 0.3 * number(random)}, {2, 0.3 * number(random)}}};
    const Planar place{0.5 + 1.5 * number(random), number(random)};
    for (const CurveSegment& segment : segments()) {
      const auto x = of_nodes(segment, nodes);
      const CurveFoot foot = nearest_point(segment, x, place);
      double least = HUGE_VAL;
      for (int k = 0; k <= 400; ++k)
        least = std::min(least, length(segment.sum(segment.weights(k / 400.0), x) - place));
      EXPECT_LE(foot.distance, least + 1e-15);
      EXPECT_GT(foot.distance, least - 5e-3);
      const Planar r = segment.sum(segment.weights(foot.t), x) - place;
      const double slope = dot(r, segment.sum(segment.slopes(foot.t), x));
      if (foot.t > 0 && foot.t < 1) {
        ++inside;
        EXPECT_NEAR(slope, 0, 1e-12);
        EXPECT_EQ(foot.end, -1);
      } else {
        EXPECT_EQ(foot.end, segment.smooth[foot.t == 0 ? 0 : 1] ? -1 : foot.t == 0 ? 0 : 1);
      }
    }
  }
  EXPECT_GT(inside, 400);
}

}  // namespace
}  // namespace ixos
