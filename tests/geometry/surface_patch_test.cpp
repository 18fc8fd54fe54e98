// Patches: derivatives, hulls, normals.
#include "geometry/surface_patch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "geometry/curve_patches.hpp"
#include "geometry/face_patches.hpp"

namespace ixos {
namespace {

/// Patches of several degrees with random places of their nodes. Weights of degrees 2 and 4 are random.
template <std::size_t D>
std::vector<std::pair<SurfacePatch<D>, typename SurfacePatch<D>::Points>> cases() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<SurfacePatch<D>> patches;
  if constexpr (D == 2) {
    patches = {straight_patch(0, 1), smooth_patch({0, 1, 2, 3}, {0.2, 1.0, 3.0})};
  } else {
    patches = {bilinear_patch({0, 1, 2, 3})};
  }
  for (const int degree : {2, 3, 4}) {
    SurfacePatch<D> patch;
    patch.degree = degree;
    patch.count = 4;
    const std::size_t powers = D == 2 ? degree + 1 : (degree + 1) * (degree + 1);
    for (std::size_t k = 0; k < 4 * powers; ++k) patch.coefficients.push_back(number(random));
    patches.push_back(patch);
  }
  std::vector<std::pair<SurfacePatch<D>, typename SurfacePatch<D>::Points>> result;
  for (const auto& patch : patches) {
    typename SurfacePatch<D>::Points x{};
    for (std::size_t a = 0; a < patch.count; ++a)
      for (double& component : x[a]) component = number(random);
    result.emplace_back(patch, x);
  }
  return result;
}

template <std::size_t D>
void expect_derivatives() {
  const double h = 1e-5;
  for (const auto& [patch, x] : cases<D>()) {
    const PlacedPatch<D> placed = patch.placed(x);
    PatchParameters<D> xi;
    for (std::size_t k = 0; k + 1 < D; ++k) xi[k] = 0.3 + 0.4 * static_cast<double>(k);
    const auto frame = placed.frame(xi);
    const auto shape = patch.shape(xi);
    EXPECT_EQ(shape.value, patch.weights(xi));
    Vec<D> sum{};
    for (std::size_t a = 0; a < patch.count; ++a) sum = sum + shape.value[a] * x[a];
    EXPECT_NEAR(length(sum - placed.at(xi)), 0, 1e-14);
    EXPECT_NEAR(length(frame.place - placed.at(xi)), 0, 1e-14);
    for (std::size_t k = 0; k + 1 < D; ++k) {
      PatchParameters<D> ahead = xi, behind = xi;
      ahead[k] += h;
      behind[k] -= h;
      EXPECT_NEAR(length(0.5 / h * (placed.at(ahead) - placed.at(behind)) - frame.tangents[k]), 0, 1e-8);
      for (std::size_t a = 0; a < patch.count; ++a)
        EXPECT_NEAR((patch.weights(ahead)[a] - patch.weights(behind)[a]) / (2 * h), shape.slopes[k][a], 1e-8);
      const auto up = placed.frame(ahead), down = placed.frame(behind);
      for (std::size_t l = 0; l + 1 < D; ++l)
        EXPECT_NEAR(length(0.5 / h * (up.tangents[l] - down.tangents[l]) - frame.bends[second_derivative(k, l)]), 0,
                    1e-7);
    }
    const Vec<D> n = placed.normal(xi);
    EXPECT_NEAR(length(n), 1, 1e-14);
    for (const Vec<D>& tangent : frame.tangents) EXPECT_NEAR(inner(n, tangent), 0, 1e-13);
    // Inside the hull: in every direction some hull point is farther.
    const auto hull = placed.hull();
    EXPECT_EQ(hull.size(), patch.powers());
    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(-1, 1);
    for (int i = 0; i < 40; ++i) {
      Vec<D> direction;
      for (double& component : direction) component = number(random);
      PatchParameters<D> at;
      for (double& t : at) t = (1 + number(random)) / 2;
      double most = -HUGE_VAL;
      for (const Vec<D>& p : hull) most = std::max(most, inner(p, direction));
      EXPECT_LE(inner(placed.at(at), direction), most + 1e-14);
    }
  }
}

TEST(SurfacePatchTest, FramesAreDerivativesAndHullsContainCurves) { expect_derivatives<2>(); }
TEST(SurfacePatchTest, FramesAreDerivativesAndHullsContainFaces) { expect_derivatives<3>(); }

template <std::size_t D>
void expect_amplification() {
  for (const auto& [patch, x] : cases<D>()) {
    double largest = 0;
    for (int i = 0; i <= 20; ++i)
      for (int j = 0; j <= (D == 3 ? 20 : 0); ++j) {
        PatchParameters<D> xi{i / 20.0};
        if constexpr (D == 3) xi[1] = j / 20.0;
        double sum = 0;
        for (const double weight : patch.weights(xi)) sum += std::abs(weight);
        largest = std::max(largest, sum);
      }
    EXPECT_GE(patch.amplification(), largest - 1e-13);
    EXPECT_LE(patch.amplification(), D == 2 ? 4 * largest : 16 * largest);
  }
}

TEST(SurfacePatchTest, NoPointMovesFartherThanTheAmplificationSays) {
  expect_amplification<2>();
  expect_amplification<3>();
  EXPECT_DOUBLE_EQ(straight_patch(0, 1).amplification(), 1);
  EXPECT_DOUBLE_EQ(bilinear_patch({0, 1, 2, 3}).amplification(), 1);
  // The inner Bernstein points of Catmull and Rom's spline are p1 + (p2 - p0)/6 and p2 - (p3 - p1)/6.
  EXPECT_NEAR(smooth_patch({0, 1, 2, 3}, {1.0, 1.0, 1.0}).amplification(), 4.0 / 3, 1e-14);
}

TEST(SurfacePatchTest, NormalsPointAwayFromTheBody) {
  const Vec<2> n = straight_patch(0, 1).placed({{{0, 0}, {2, 0}}}).normal(PatchParameters<2>{0.5});
  EXPECT_EQ(n, (Vec<2>{0, -1}));  // the body is on the left
  const Vec<3> m = bilinear_patch({0, 1, 2, 3})
                       .placed({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}})
                       .normal(PatchParameters<3>{0.2, 0.3});
  EXPECT_EQ(m, (Vec<3>{0, 0, 1}));  // counter-clockwise seen from outside
}

}  // namespace
}  // namespace ixos
