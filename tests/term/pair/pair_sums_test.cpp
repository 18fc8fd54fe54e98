// Sums of the second derivatives of gaps.
#include "term/pair/pair_sums.hpp"

#include <gtest/gtest.h>

#include "geometry/curve_patches.hpp"
#include "geometry/face_patches.hpp"

namespace ixos {
namespace {

/// Two points of one patch, at two times each; the sum of their matrices is that of PairGap's.
template <std::size_t D>
void expect_sum(const SurfacePatch<D>& patch, const std::vector<Vec<D>>& x) {
  const std::vector<SurfacePatch<D>> all{patch};
  const std::size_t own = 3, size = D * (own + patch.count);
  PairSums<D> sums;
  std::vector<double> sum{7, 7};
  for (int round = 0; round < 2; ++round) {  // the second one takes the memory of the first
    sums.begin(own, patch.count);
    std::vector<double> direct(size * size, 0.0);
    for (const double point : {0.3, 0.6}) {
      const typename SurfacePatch<D>::Weights weights{0.5 - point, 0.5 + 0.6 * point, 0.4 * point};
      for (const double time : {0.1, 0.2}) {
        std::vector<Vec<D>> moved = x;
        for (Vec<D>& place : moved) place[0] += 0.1 * time * place[1];
        const PlacedSurface<D> placed(all, moved);
        Vec<D> place{};
        place.fill(0.4 + 0.3 * point);
        place[D - 1] = 1 + time;
        const PairGap<D> gap(weights, own, patch, placed.nearest(place));
        sums.add(gap, 2 + time, -time);
        gap.add(2 + time, -time, direct.data());
      }
      sums.end_point(weights);
    }
    sums.end_point({});  // a point without a closest point adds nothing
    sums.write(sum);
    ASSERT_EQ(sum.size(), size * size);
    for (std::size_t k = 0; k < sum.size(); ++k) EXPECT_NEAR(sum[k], direct[k], 1e-13);
  }
}

TEST(PairSumsTest, TheyAreTheSumsOfTheMatricesOfAllPointsAndTimes) {
  SurfacePatch<2> curve = smooth_patch({0, 1, 2, 3}, {1.0, 1.0, 1.0});
  curve.neighbours.fill(-1);
  expect_sum<2>(curve, {{-1, 0.1}, {0, 0}, {1, 0.1}, {2, -0.1}});
  SurfacePatch<3> face = bilinear_patch({0, 1, 2, 3});
  face.neighbours.fill(-1);
  expect_sum<3>(face, {{0, 0, 0.1}, {1.1, 0, 0}, {1, 1.2, 0.1}, {0, 1, 0}});
  SurfacePatch<3> wide;  // as many nodes as fit no pack
  wide.degree = 4;
  wide.count = 25;
  std::vector<Vec<3>> x;
  for (std::size_t a = 0; a < 25; ++a) {
    wide.nodes[a] = static_cast<int>(a);
    for (std::size_t k = 0; k < 25; ++k) wide.coefficients.push_back(a == k ? 1 : 0);
    x.push_back({a == 1 ? 1.0 : 0, a == 5 ? 1.0 : 0, a == 6 || a == 12 ? 0.1 : 0});
  }
  wide.neighbours.fill(-1);
  expect_sum<3>(wide, x);
}

}  // namespace
}  // namespace ixos
