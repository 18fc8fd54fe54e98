// Bounds on the distance from a patch.
#include "geometry/patch_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "geometry/curve_patches.hpp"
#include "geometry/face_patches.hpp"
#include "geometry/patch_projection.hpp"

namespace ixos {
namespace {

SurfacePatch<2> patch_of(std::array<Vec<2>, 4>& x, double noise, std::mt19937& random) {
  std::uniform_real_distribution<double> number(-noise, noise);
  for (std::size_t a = 0; a < 4; ++a) x[a] = {static_cast<double>(a) + number(random), number(random)};
  return smooth_patch({0, 1, 2, 3}, {1.0, 1.0, 1.0});
}

SurfacePatch<3> patch_of(std::array<Vec<3>, 4>& x, double noise, std::mt19937& random) {
  std::uniform_real_distribution<double> number(-noise, noise);
  const std::array<Vec<3>, 4> corners{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t i = 0; i < 3; ++i) x[a][i] = corners[a][i] + number(random);
  return bilinear_patch({0, 1, 2, 3});
}

/// Bounds are below the distance, for every point from which the second one looks, and near it for flat patches.
template <std::size_t D>
void expect_bounds(double noise, double slack) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> number(-1, 1);
  double largest = 0;
  for (int n = 0; n < 300; ++n) {
    std::array<Vec<D>, 4> x;
    const SurfacePatch<D> patch = patch_of(x, noise, random);
    typename SurfacePatch<D>::Points nodes{};
    for (std::size_t a = 0; a < patch.count; ++a) nodes[a] = x[static_cast<std::size_t>(patch.nodes[a])];
    const PlacedPatch<D> placed = patch.placed(nodes);
    const PatchBound<D> bound(placed);
    Vec<D> place;
    for (double& component : place) component = 2 * number(random);
    const PatchProjection<D> projection = nearest_point(placed, patch.smooth, place, bound.start(place));
    EXPECT_LE(bound.distance(place), projection.distance);
    PatchParameters<D> any;
    for (double& t : any) t = (1 + number(random)) / 2;
    for (const PatchParameters<D>& xi : {any, bound.start(place), projection.xi})
      EXPECT_LE(bound.distance(place, placed.at(xi)), projection.distance + 1e-15);
    largest = std::max(largest, projection.distance - bound.distance(place));
    largest = std::max(largest, projection.distance - bound.distance(place, projection.frame.place));
  }
  EXPECT_LT(largest, slack);
}

TEST(PatchBoundTest, NoCurveIsNearerThanItsBound) {
  expect_bounds<2>(0, 1e-12);
  expect_bounds<2>(0.1, 0.2);
  expect_bounds<2>(0.4, 1);
}

TEST(PatchBoundTest, NoFaceIsNearerThanItsBound) {
  expect_bounds<3>(0, 1e-12);
  expect_bounds<3>(0.1, 0.3);
  expect_bounds<3>(0.3, 1);
}

TEST(PatchBoundTest, TheStartIsTheClosestPointOfAFlatPatch) {
  const PlacedPatch<3> placed = bilinear_patch({0, 1, 2, 3}).placed({{{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {1, 1, 0}}});
  const PatchBound<3> bound(placed);
  const PatchParameters<3> inside = bound.start(placed.at({0.3, 0.8}) + Vec<3>{0, 0, 5});
  EXPECT_NEAR(inside[0], 0.3, 1e-14);
  EXPECT_NEAR(inside[1], 0.8, 1e-14);
  EXPECT_EQ(bound.start({-50, 0.5, 1})[0], 0);
}

TEST(PatchBoundTest, AFoldedPatchHasABound) {
  PlacedPatch<3> point;  // all its points are one
  point.coefficients[0] = {1, 2, 3};
  const PatchBound<3> bound(point);
  EXPECT_NEAR(bound.distance({1, 2, 5}), 2, 1e-11);
  EXPECT_EQ(bound.start({1, 2, 5}), (PatchParameters<3>{0.5, 0.5}));
}

}  // namespace
}  // namespace ixos
