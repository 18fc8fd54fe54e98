#include "mesh/fitted_normal.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/vector3.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

/// Places of a plane, far from the origin.
std::vector<Vec<3>> plane_of(const Vec<3>& u, const Vec<3>& v) {
  std::vector<Vec<3>> places;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j) places.push_back(Vec<3>{50, -30, 20} + 1.0 * i * u + 1.0 * j * v);
  return places;
}

TEST(FittedNormalTest, IsAcrossThePlane) {
  const Vec<3> u{1, 2, 0.5}, v{-0.5, 0.25, 1};
  const Vec<3> normal = fitted_normal(3, plane_of(u, v));
  EXPECT_NEAR(length(normal), 1, 1e-14);
  EXPECT_NEAR(std::abs(dot(normal, 1 / length(cross(u, v)) * cross(u, v))), 1, 1e-13);
}

TEST(FittedNormalTest, IsAcrossALineOfThePlane) {
  const Vec<3> normal = fitted_normal(2, {{0, 0, 0}, {3, 4, 0}, {6, 8, 0}});
  EXPECT_NEAR(std::abs(normal[0] * 4 - normal[1] * 3), 5, 1e-14);
  EXPECT_EQ(normal[2], 0);
}

TEST(FittedNormalTest, AddsRanksUp) {
  const std::vector<Vec<3>> all = plane_of({1, 0, 0}, {0, 1, 1});
  const std::vector<Vec<3>> mine(all.begin(), all.begin() + 5);
  const auto twice = [](double* values, int count) {  // the other rank has the same places
    for (int i = 0; i < count; ++i) values[i] *= 2;
  };
  EXPECT_NEAR(std::abs(inner(fitted_normal(3, mine, twice), fitted_normal(3, all))), 1, 1e-13);
}

TEST(FittedNormalTest, RefusesWhatHasNoPlane) {
  const auto expect = [](int dimension, const std::vector<Vec<3>>& places, const char* words) {
    test::expect_contains(test::refusal([&] { fitted_normal(dimension, places); }), words);
  };
  expect(3, {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, "on one line");
  expect(2, {{1, 1, 0}, {1, 1, 0}}, "at one point");
  expect(3, {}, "on one line");
  expect(2, {{0, 0, 0}, {1, 0, 0}, {2, 0.01, 0}}, "not in one plane");
  std::vector<Vec<3>> bent = plane_of({1, 0, 0}, {0, 1, 0});
  bent[3][2] += 0.1;
  expect(3, bent, "not in one plane");
}

}  // namespace
}  // namespace ixos
