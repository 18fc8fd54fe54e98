// Sides in the plane as curves.
#include "interaction/curve_patches.hpp"

#include <gtest/gtest.h>

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
