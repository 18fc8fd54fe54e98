// Sides in the plane as curves.
#include "geometry/curve_patches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ixos {
namespace {

/// Returns the curve at places by node.
PlacedPatch<2> placed(const SurfacePatch<2>& patch, const std::array<Vec<2>, 4>& x) {
  SurfacePatch<2>::Points own{};
  for (std::size_t a = 0; a < patch.count; ++a) own[a] = x[static_cast<std::size_t>(patch.nodes[a])];
  return patch.placed(own);
}

TEST(CurvePatchesTest, EqualLengthsGiveCatmullAndRomsWeights) {
  const SurfacePatch<2> patch = smooth_patch({0, 1, 2, 3}, {2, 2, 2});
  for (double t : {0.0, 0.3, 0.8, 1.0}) {
    const std::array<double, 4> expected{(-t + 2 * t * t - t * t * t) / 2, (2 - 5 * t * t + 3 * t * t * t) / 2,
                                         (t + 4 * t * t - 3 * t * t * t) / 2, (-t * t + t * t * t) / 2};
    const auto n = patch.weights({t});
    for (std::size_t a = 0; a < 4; ++a) EXPECT_NEAR(n[a], expected[static_cast<std::size_t>(patch.nodes[a])], 1e-15);
  }
}

TEST(CurvePatchesTest, AFreeEndIsThatOfAnExtrapolatedNode) {
  const SurfacePatch<2> open = smooth_patch({-1, 1, 2, 3}, {0, 2, 2}), whole = smooth_patch({0, 1, 2, 3}, {2, 2, 2});
  const std::array<Vec<2>, 4> x{{{-1.5, -0.5}, {0.25, 0}, {2, 0.5}, {3, 2}}};  // x_0 = 2 x_1 - x_2
  for (double t : {0.0, 0.4, 0.9}) EXPECT_NEAR(length(placed(open, x).at({t}) - placed(whole, x).at({t})), 0, 1e-15);
  EXPECT_FALSE(open.smooth[0]);
  EXPECT_TRUE(open.smooth[1]);
}

/// With uneven sides the curve through points of a parabola in its length is that parabola.
TEST(CurvePatchesTest, UnevenSidesReproduceParabolas) {
  const SurfacePatch<2> patch = smooth_patch({0, 1, 2, 3}, {0.3, 1.0, 2.5});
  const std::array<double, 4> s{0, 0.3, 1.3, 3.8};
  std::array<Vec<2>, 4> x;
  for (std::size_t a = 0; a < 4; ++a) x[a] = {1 + s[a], 2 * s[a] - 0.7 * s[a] * s[a]};
  for (double t : {0.1, 0.5, 0.95}) {
    const double here = s[1] + t;
    const Vec<2> place = placed(patch, x).at({t});
    EXPECT_NEAR(place[0], 1 + here, 1e-14);
    EXPECT_NEAR(place[1], 2 * here - 0.7 * here * here, 1e-14);
  }
}

/// Returns the closed spline's segments through n nodes on the unit circle, at their places.
std::vector<PlacedPatch<2>> spline_circle(int n) {
  std::vector<PlacedPatch<2>> result;
  for (int side = 0; side < n; ++side) {
    const SurfacePatch<2> patch = spline_patch({0, 1, 2, 3, 4, 5});
    SurfacePatch<2>::Points x{};
    for (std::size_t a = 0; a < patch.count; ++a) {
      const double angle = 2 * M_PI * (side + patch.nodes[a] - 2) / n;
      x[a] = {std::cos(angle), std::sin(angle)};
    }
    result.push_back(patch.placed(x));
  }
  return result;
}

/// For nodes at the angles k a, the control points are (8 - 2 cos a)/6 times the nodes, and the spline's ends
/// (4 + 2 cos a)/6 times the control points. The product is 1 - (1 - cos a)^2/9.
TEST(CurvePatchesTest, ASplineFollowsACircleToFourthOrder) {
  double last = 0;
  for (const int n : {12, 24, 48}) {
    const double a = 2 * M_PI / n, ends = 1 - std::pow(1 - std::cos(a), 2) / 9;
    double error = 0;
    for (const PlacedPatch<2>& segment : spline_circle(n)) {
      EXPECT_NEAR(length(segment.at({0})), ends, 1e-15);
      for (const double t : {0.0, 0.25, 0.5}) error = std::max(error, std::abs(length(segment.at({t})) - 1));
    }
    if (last > 0) {
      EXPECT_NEAR(std::log2(last / error), 4, 0.1);
    }
    last = error;
  }
}

TEST(CurvePatchesTest, SegmentsOfASplineHaveOneTangentAndOneCurvatureWhereTheyMeet) {
  const std::array<Vec<2>, 7> x{{{0, 0}, {0.4, 0.3}, {1.5, 0.2}, {2, 0.9}, {2.2, 2}, {1.7, 2.6}, {0.9, 3}}};
  const auto segment = [&](const std::array<int, 6>& nodes) {
    const SurfacePatch<2> patch = spline_patch(nodes);
    return patch.placed(patch.among({x.begin(), x.end()}));
  };
  const auto expect_joined = [](const PlacedPatch<2>& before, const PlacedPatch<2>& after) {
    const auto end = before.frame({1}), start = after.frame({0});
    EXPECT_NEAR(length(end.place - start.place), 0, 1e-15);
    EXPECT_NEAR(length(end.tangents[0] - start.tangents[0]), 0, 1e-14);
    EXPECT_NEAR(length(end.bends[0] - start.bends[0]), 0, 1e-14);
  };
  // From one free end to the other.
  const std::vector<PlacedPatch<2>> all{segment({-1, -1, 0, 1, 2, 3}), segment({-1, 0, 1, 2, 3, 4}),
                                        segment({0, 1, 2, 3, 4, 5}),   segment({1, 2, 3, 4, 5, 6}),
                                        segment({2, 3, 4, 5, 6, -1}),  segment({3, 4, 5, 6, -1, -1})};
  for (std::size_t k = 1; k < all.size(); ++k) expect_joined(all[k - 1], all[k]);
  EXPECT_NEAR(length(all.front().at({0}) - x.front()), 0, 1e-15);
  EXPECT_NEAR(length(all.back().at({1}) - x.back()), 0, 1e-15);
  EXPECT_NEAR(length(all.front().frame({0}).bends[0]), 0, 1e-14);
  const SurfacePatch<2> first = spline_patch({-1, -1, 0, 1, 2, 3}), inner = spline_patch({0, 1, 2, 3, 4, 5});
  EXPECT_EQ(first.smooth, (std::array<bool, 2>{false, true}));
  EXPECT_EQ(inner.smooth, (std::array<bool, 2>{true, true}));
  EXPECT_EQ(inner.nodes[0], 2);  // its own ends come first
  EXPECT_EQ(inner.nodes[1], 3);
}

TEST(CurvePatchesTest, ASplineOfNodesOnALineIsTheLine) {
  const SurfacePatch<2> patch = spline_patch({-1, 0, 1, 2, 3, -1});
  const std::vector<Vec<2>> x{{0, 0}, {0.1, 0.2}, {0.5, 1}, {0.6, 1.2}};
  for (const double t : {0.0, 0.3, 1.0}) {
    const Vec<2> place = patch.placed(patch.among(x)).at({t});
    EXPECT_NEAR(place[1], 2 * place[0], 1e-15);
  }
}

TEST(CurvePatchesTest, AStraightSideIsItsChord) {
  const Vec<2> middle = placed(straight_patch(1, 3), {{{9, 9}, {1, 2}, {9, 9}, {3, -2}}}).at({0.25});
  EXPECT_DOUBLE_EQ(middle[0], 1.5);
  EXPECT_DOUBLE_EQ(middle[1], 1);
}

TEST(CurvePatchesTest, TheSlopeOfAParabolaIsExact) {
  const std::array<double, 3> w = parabola_slope(0.4, 1.1);
  const auto f = [](double s) { return 2 - 3 * s + 0.7 * s * s; };
  EXPECT_NEAR(w[0] * f(-0.4) + w[1] * f(0) + w[2] * f(1.1), -3, 1e-14);
}

}  // namespace
}  // namespace ixos
