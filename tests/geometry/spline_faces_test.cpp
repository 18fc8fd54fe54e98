// Splines over the faces of a grid.
#include "geometry/spline_faces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>
#include <stdexcept>

#include "geometry/placed_surface.hpp"

namespace ixos {
namespace {

/// A grid of n x n faces over [0, n] x [0, n], and its patches.
struct Sheet {
  int n;
  std::vector<Vec<3>> x;
  std::vector<SideGrid::Face> faces;
  std::vector<SurfacePatch<3>> patches;

  Sheet(int size, const std::function<double(double, double)>& height) : n(size) {
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) x.push_back({double(i), double(j), height(i, j)});
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const int first = j * (n + 1) + i;
        faces.push_back({first, first + 1, first + n + 2, first + n + 1});
      }
    std::vector<long long> numbers(x.size());
    std::iota(numbers.begin(), numbers.end(), 1);
    const SideGrid grid(faces, x, "sheet", numbers);
    const SplineFaces splines(grid);
    for (int f = 0; f < n * n; ++f)
      patches.push_back(bezier_patch(faces[static_cast<std::size_t>(f)], splines.controls(f)));
  }
  PlacedPatch<3> placed(int i, int j) const {
    const SurfacePatch<3>& patch = patches[static_cast<std::size_t>(j * n + i)];
    return patch.placed(patch.among(x));
  }
};

TEST(SplineFacesTest, ReproducesCubicsAwayFromTheRim) {
  const auto height = [](double x, double y) {
    return 0.01 * (x * x * x - 2 * x * x * y + x * y * y - 3 * y * y * y) + 0.05 * x * y - 0.1 * x;
  };
  const Sheet sheet(7, height);
  for (const double u : {0.0, 0.3, 1.0})
    for (const double v : {0.0, 0.6, 1.0}) {
      const Vec<3> place = sheet.placed(3, 3).at({u, v});
      EXPECT_NEAR(place[0], 3 + u, 1e-13);
      EXPECT_NEAR(place[1], 3 + v, 1e-13);
      EXPECT_NEAR(place[2], height(3 + u, 3 + v), 1e-13);
    }
  EXPECT_EQ(sheet.patches[3 * 7 + 3].count, 32U);
}

TEST(SplineFacesTest, TangentsAndCurvaturesAreContinuous) {
  const Sheet sheet(7, [](double x, double y) { return 0.06 * std::sin(1.7 * x) * std::cos(1.1 * y + x); });
  for (int j = 0; j < 7; ++j)
    for (int i = 0; i + 1 < 7; ++i)
      for (const double t : {0.0, 0.4, 1.0}) {
        const auto left = sheet.placed(i, j).frame({1, t}), right = sheet.placed(i + 1, j).frame({0, t});
        const auto below = sheet.placed(j, i).frame({t, 1}), above = sheet.placed(j, i + 1).frame({t, 0});
        for (std::size_t k = 0; k < 3; ++k) {
          EXPECT_NEAR(left.place[k], right.place[k], 1e-13);
          EXPECT_NEAR(below.place[k], above.place[k], 1e-13);
          for (std::size_t d = 0; d < 2; ++d) {
            EXPECT_NEAR(left.tangents[d][k], right.tangents[d][k], 1e-13);
            EXPECT_NEAR(below.tangents[d][k], above.tangents[d][k], 1e-13);
          }
          for (std::size_t d = 0; d < 3; ++d) {
            EXPECT_NEAR(left.bends[d][k], right.bends[d][k], 1e-12);
            EXPECT_NEAR(below.bends[d][k], above.bends[d][k], 1e-12);
          }
        }
      }
}

/// A rim is the spline of its nodes, which ends in the corners.
TEST(SplineFacesTest, TheRimFollowsItsNodesAlone) {
  const auto wave = [](double x, double y) { return 0.2 * std::sin(x) + 0.1 * y * y; };
  const Sheet sheet(5, wave), other(5, [&](double x, double y) { return wave(x, y) + (y > 0 ? x : 0); });
  for (int i = 0; i < 5; ++i)
    for (const double t : {0.0, 0.5, 1.0})
      EXPECT_NEAR(sheet.placed(i, 0).at({t, 0})[2], other.placed(i, 0).at({t, 0})[2], 1e-14);
  EXPECT_NEAR(sheet.placed(0, 0).at({0, 0})[2], wave(0, 0), 1e-14);
  EXPECT_NEAR(sheet.placed(4, 4).at({1, 1})[2], wave(5, 5), 1e-14);
}

TEST(SplineFacesTest, CreasesKeepACube) {
  std::vector<Vec<3>> x;
  for (int k = 0; k < 8; ++k) x.push_back({k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 4 ? 1.0 : -1.0});
  const std::vector<SideGrid::Face> faces{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                          {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  const SideGrid grid(faces, x, "cube", {1, 2, 3, 4, 5, 6, 7, 8});
  const SplineFaces splines(grid);
  for (int f = 0; f < 6; ++f) {
    const SurfacePatch<3> patch = bezier_patch(faces[static_cast<std::size_t>(f)], splines.controls(f));
    const auto weights = patch.weights({0.3, 0.8});
    EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1, 1e-14);
    const Vec<3> middle = patch.placed(patch.among(x)).at({0.5, 0.5});
    double largest = 0;
    for (const double component : middle) largest = std::max(largest, std::abs(component));
    EXPECT_NEAR(largest, 1, 1e-13);
    EXPECT_NEAR(length(middle), 1, 1e-13);
  }
}

/// A fan of n faces around a node, with another ring of faces around it, in the plane z = x/2: the patches keep the
/// plane.
TEST(SplineFacesTest, NodesWhereOtherThanFourFacesMeet) {
  for (const int n : {3, 5, 6}) {
    std::vector<Vec<3>> x{{0, 0, 0}};
    const auto add = [&](double radius, double turn) {
      const double angle = 2 * M_PI * turn / n;
      x.push_back({radius * std::cos(angle), radius * std::sin(angle), radius * std::cos(angle) / 2});
      return static_cast<int>(x.size()) - 1;
    };
    // On each of n rays two nodes; in each sector the nodes of a grid of 2 x 2 faces that no ray has.
    std::vector<std::array<int, 2>> ray;
    for (int k = 0; k < n; ++k) ray.push_back({add(1, k), add(2, k)});
    std::vector<SideGrid::Face> faces;
    for (int k = 0; k < n; ++k) {
      const auto &a = ray[static_cast<std::size_t>(k)], &b = ray[static_cast<std::size_t>((k + 1) % n)];
      const int inner = add(1.4, k + 0.5), first = add(2.3, k + 0.3), second = add(2.3, k + 0.7),
                outer = add(2.8, k + 0.5);
      faces.push_back({0, a[0], inner, b[0]});
      faces.push_back({a[0], a[1], first, inner});
      faces.push_back({b[0], inner, second, b[1]});
      faces.push_back({inner, first, outer, second});
    }
    std::vector<long long> numbers(x.size());
    std::iota(numbers.begin(), numbers.end(), 1);
    const SideGrid grid(faces, x, "fan", numbers);
    const SplineFaces splines(grid);
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const SurfacePatch<3> patch = bezier_patch(faces[f], splines.controls(static_cast<int>(f)));
      const auto weights = patch.weights({0.3, 0.8});
      EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1, 1e-14);
      const Vec<3> place = patch.placed(patch.among(x)).at({0.3, 0.8});
      EXPECT_NEAR(place[2], place[0] / 2, 1e-14);
    }
    // The node in the middle stays there by symmetry.
    const SurfacePatch<3> patch = bezier_patch(faces[0], splines.controls(0));
    EXPECT_NEAR(length(patch.placed(patch.among(x)).at({0, 0})), 0, 1e-14) << n;
  }
}

TEST(SplineFacesTest, TooManyNodesAreRefused) {
  std::array<NodeWeights, 16> controls;
  for (int k = 0; k < 48; ++k) controls[static_cast<std::size_t>(k % 16)].add(k, 1);
  EXPECT_THROW(bezier_patch({0, 1, 2, 3}, controls), std::length_error);
}

}  // namespace
}  // namespace ixos
