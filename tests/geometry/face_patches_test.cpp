// Patches over faces in space.
#include "geometry/face_patches.hpp"

#include <gtest/gtest.h>

#include "geometry/curve_patches.hpp"

namespace ixos {
namespace {

TEST(FacePatchesTest, ABilinearPatchInterpolatesItsCorners) {
  const SurfacePatch<3> patch = bilinear_patch({3, 5, 8, 2});
  EXPECT_EQ(patch.count, 4U);
  const SurfacePatch<3>::Points x{{{0, 0, 0}, {2, 0, 1}, {3, 2, 0}, {0, 1, 0}}};
  const PlacedPatch<3> placed = patch.placed(x);
  const std::array<PatchParameters<3>, 4> corners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(length(placed.at(corners[c]) - x[c]), 0, 1e-15);
  const Vec<3> middle = placed.at({0.5, 0.5});
  EXPECT_DOUBLE_EQ(middle[0], 1.25);
  EXPECT_DOUBLE_EQ(middle[1], 0.75);
  EXPECT_DOUBLE_EQ(middle[2], 0.25);
}

/// The derivatives of nodes on a grid of 4 by 4 with these distances, by parabolas along its lines.
struct Grid {
  std::array<double, 3> across, along;

  static int node(std::size_t i, std::size_t j) { return static_cast<int>(4 * j + i); }
  SurfacePatch<3> middle() const {
    std::array<CornerDerivatives, 4> derivatives;
    const std::array<std::array<std::size_t, 2>, 4> places{{{1, 1}, {2, 1}, {2, 2}, {1, 2}}};
    for (std::size_t c = 0; c < 4; ++c) {
      const auto [i, j] = places[c];
      const auto a = parabola_slope(across[i - 1], across[i]), b = parabola_slope(along[j - 1], along[j]);
      for (std::size_t k = 0; k < 3; ++k) {
        derivatives[c].first.add(node(i + k - 1, j), a[k]);
        derivatives[c].second.add(node(i, j + k - 1), b[k]);
        for (std::size_t l = 0; l < 3; ++l) derivatives[c].mixed.add(node(i + k - 1, j + l - 1), a[k] * b[l]);
      }
    }
    return bicubic_patch({node(1, 1), node(2, 1), node(2, 2), node(1, 2)}, derivatives, {across[1], along[1]});
  }
};

/// On a product grid with uneven distances the patch reproduces products of parabolas.
TEST(FacePatchesTest, ABicubicPatchReproducesProductsOfParabolas) {
  const Grid grid{{0.5, 1, 1.7}, {2, 0.8, 0.3}};
  const SurfacePatch<3> patch = grid.middle();
  EXPECT_EQ(patch.count, 16U);
  EXPECT_EQ(patch.nodes[0], Grid::node(1, 1));
  EXPECT_EQ(patch.nodes[3], Grid::node(1, 2));
  const auto surface = [](double a, double b) { return Vec<3>{a, b, (1 - a + 0.3 * a * a) * (2 + 0.5 * b - b * b)}; };
  const std::array<double, 4> a{-0.5, 0, 1, 2.7}, b{-2, 0, 0.8, 1.1};
  SurfacePatch<3>::Points x{};
  for (std::size_t k = 0; k < patch.count; ++k) {
    const auto node = static_cast<std::size_t>(patch.nodes[k]);
    x[k] = surface(a[node % 4], b[node / 4]);
  }
  const PlacedPatch<3> placed = patch.placed(x);
  for (double s : {0.0, 0.3, 0.9})
    for (double t : {0.2, 1.0}) EXPECT_NEAR(length(placed.at({s, t}) - surface(s, 0.8 * t)), 0, 1e-14);
}

TEST(FacePatchesTest, WeightsOfOneNodeAddUp) {
  NodeWeights weights;
  weights.add(4, 0.5);
  weights.add(7, 1);
  weights.add(4, 0.25);
  EXPECT_EQ(weights.nodes, (std::vector<int>{4, 7}));
  EXPECT_EQ(weights.weights, (std::vector<double>{0.75, 1}));
}

}  // namespace
}  // namespace ixos
