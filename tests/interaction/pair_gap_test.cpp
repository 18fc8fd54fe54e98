// Derivatives of the gap between two surfaces.
#include "interaction/pair_gap.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ixos {
namespace {

/// A point with weights of four nodes before one segment; the last eight numbers of x are the segment's nodes.
struct Pair {
  CurveSegment segment;
  CurveSegment::Weights weights{-0.07, 0.55, 0.6, -0.08};
  std::array<double, 16> x{-1, 1.1, 0.1, 1.0, 1, 0.9, 2, 1.2, 0, 0.1, 1.1, 0, -1, -0.2, 2.2, 0.3};

  std::vector<Planar> nodes() const {
    std::vector<Planar> result;
    for (std::size_t a = 4; a < 8; ++a) result.push_back({x[2 * a], x[2 * a + 1]});
    return result;
  }
  Planar place() const {
    Planar p{};
    for (std::size_t a = 0; a < 4; ++a) p = p + weights[a] * Planar{x[2 * a], x[2 * a + 1]};
    return p;
  }
  SurfaceFoot foot() const {
    const std::vector<CurveSegment> all{segment};
    const std::vector<Planar> places = nodes();
    return PlacedCurves(all, places).nearest(place());
  }
  PairGap gap() const {
    const std::vector<CurveSegment> all{segment};
    const std::vector<Planar> places = nodes();
    return {weights, 4, segment, PlacedCurves(all, places).points(0), foot()};
  }
};

std::vector<Pair> pairs() {
  std::vector<Pair> all(5);
  all[0].segment = straight_segment(0, 1);
  all[1].segment = smooth_segment({2, 0, 1, 3}, {1, 1.1, 1.3});
  all[2].segment = smooth_segment({-1, 0, 1, 3}, {0, 1.1, 1.3});
  all[3].segment = straight_segment(0, 1);  // beyond its end
  for (std::size_t a = 0; a < 4; ++a) all[3].x[2 * a] += 1.5;
  all[4] = all[1];  // on the other side, where the curve is hollow
  for (std::size_t a = 0; a < 4; ++a) all[4].x[2 * a + 1] -= 1.6;
  return all;
}

TEST(PairGapTest, GradientAndSecondDerivativesAgreeWithDifferences) {
  for (const Pair& pair : pairs()) {
    const PairGap gap = pair.gap();
    EXPECT_EQ(gap.is_round(), pair.foot().end >= 0);
    const PairGap::Vector gradient = gap.gradient();
    PairGap::Matrix second{};
    gap.add(0, 1, second);
    const double h = 1e-5;
    for (std::size_t r = 0; r < 2 * gap.nodes(); ++r) {
      Pair ahead = pair, behind = pair;
      // The segment's nodes in its own order.
      const std::size_t node = r / 2 < 4 ? r / 2 : 4 + static_cast<std::size_t>(pair.segment.nodes[r / 2 - 4]);
      ahead.x[2 * node + r % 2] += h;
      behind.x[2 * node + r % 2] -= h;
      EXPECT_NEAR((ahead.foot().gap - behind.foot().gap) / (2 * h), gradient[r], 1e-9);
      const PairGap::Vector up = ahead.gap().gradient(), down = behind.gap().gradient();
      for (std::size_t c = 0; c < 2 * gap.nodes(); ++c)
        EXPECT_NEAR((up[c] - down[c]) / (2 * h), second[r][c], 1e-8) << r << " " << c;
    }
  }
}

TEST(PairGapTest, NeitherNetForceNorNetMoment) {
  for (const Pair& pair : pairs()) {
    const PairGap gap = pair.gap();
    const PairGap::Vector g = gap.gradient();
    double force[2] = {0, 0}, moment = 0;
    for (std::size_t a = 0; a < gap.nodes(); ++a) {
      const std::size_t node = a < 4 ? a : 4 + static_cast<std::size_t>(pair.segment.nodes[a - 4]);
      for (std::size_t i = 0; i < 2; ++i) force[i] += g[2 * a + i];
      moment += pair.x[2 * node] * g[2 * a + 1] - pair.x[2 * node + 1] * g[2 * a];
    }
    EXPECT_NEAR(force[0], 0, 1e-15);
    EXPECT_NEAR(force[1], 0, 1e-15);
    EXPECT_NEAR(moment, 0, 1e-14);
  }
}

TEST(PairGapTest, TheGradientsSquareIsThatOfTheWeights) {
  for (const Pair& pair : pairs()) {
    PairGap::Matrix k{};
    pair.gap().add(2, 0, k);
    const PairGap::Vector g = pair.gap().gradient();
    for (std::size_t r = 0; r < g.size(); ++r)
      for (std::size_t c = 0; c < g.size(); ++c) EXPECT_DOUBLE_EQ(k[r][c], 2 * g[r] * g[c]);
  }
}

}  // namespace
}  // namespace ixos
