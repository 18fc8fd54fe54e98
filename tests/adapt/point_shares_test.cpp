// Shares of the points of a cell in others.
#include "adapt/point_shares.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/simplex_rules.hpp"

namespace ixos {
namespace {

double linear(const RootPlace& x) { return 0.3 + 0.5 * x[0] - 0.2 * x[1] + 0.7 * x[2]; }

double mean(const std::vector<RootPlace>& points, const std::vector<ShareOfPoint>& shares) {
  double sum = 0, weights = 0;
  for (const ShareOfPoint& share : shares) {
    EXPECT_GE(share.weight, 0);
    sum += share.weight * linear(points[share.point]);
    weights += share.weight;
  }
  EXPECT_NEAR(weights, 1, 1e-14);
  return sum;
}

TEST(PointSharesTest, LinearNumbersStaySoAmongThePoints) {
  const std::vector<std::vector<RootPlace>> plane{places_of(three_point_rule()), places_of(triangle_rule(2)),
                                                  places_of(triangle_rule(5))},
      space{places_of(four_point_rule()), places_of(tetrahedron_rule(2)), places_of(tetrahedron_rule(3)),
            places_of(tetrahedron_rule(4))};  // 64 points: those near a place
  for (const int dimension : {2, 3})
    for (const std::vector<RootPlace>& points : dimension == 2 ? plane : space) {
      RootPlace middle{};
      for (const RootPlace& point : points)
        for (std::size_t i = 0; i < 3; ++i) middle[i] += point[i] / static_cast<double>(points.size());
      for (std::size_t q = 0; q < points.size(); ++q)
        for (const double share : {0.0, 0.3, 0.8, 1.0}) {
          if (points.size() > 16 && share == 0.8) continue;  // between some of the outermost points
          RootPlace place{};
          for (std::size_t i = 0; i < 3; ++i) place[i] = middle[i] + share * (points[q][i] - middle[i]);
          EXPECT_NEAR(mean(points, shares_in_simplex(points, dimension, dimension, place)), linear(place), 1e-13);
        }
      const auto at_point = shares_in_simplex(points, dimension, dimension, points[1]);
      ASSERT_EQ(at_point.size(), 1U);
      EXPECT_EQ(at_point[0].point, 1U);
      EXPECT_EQ(at_point[0].weight, 1);
    }
}

// Beyond three points the next point of their triangle counts, whatever corner comes first.
TEST(PointSharesTest, BeyondThePointsNumbersAreThoseOfTheNextPlace) {
  const std::vector<RootPlace> points = places_of(three_point_rule());  // by the corners 0, 1 and 2
  const auto corner = shares_in_simplex(points, 2, 2, {0, 0, 0});
  ASSERT_EQ(corner.size(), 1U);
  EXPECT_EQ(corner[0].point, 0U);
  const auto edge = shares_in_simplex(points, 2, 2, {0.5, 0, 0});
  ASSERT_EQ(edge.size(), 2U);
  EXPECT_NEAR(edge[0].weight, 0.5, 1e-14);
  EXPECT_NEAR(edge[1].weight, 0.5, 1e-14);
  const auto slope = shares_in_simplex(points, 2, 2, {0.5, 0.5, 0});
  ASSERT_EQ(slope.size(), 2U);
  EXPECT_NEAR(slope[0].weight, 0.5, 1e-14);
}

TEST(PointSharesTest, PointsOnAFaceShareItsPlaces) {
  std::vector<RootPlace> line, face;
  for (const double x : {0.1, 0.5, 0.9}) line.push_back({x, 1 - x, 0});  // the side across corner 0
  for (const auto& [x, y] : {std::pair(0.2, 0.2), std::pair(0.6, 0.2), std::pair(0.2, 0.6)}) face.push_back({x, y, 0});
  EXPECT_NEAR(mean(line, shares_in_simplex(line, 2, 1, {0.3, 0.7, 0})), linear({0.3, 0.7, 0}), 1e-14);
  EXPECT_NEAR(mean(line, shares_in_simplex(line, 2, 1, {0, 1, 0})), linear({0.1, 0.9, 0}), 1e-14);
  EXPECT_NEAR(mean(face, shares_in_simplex(face, 3, 2, {0.3, 0.3, 0})), linear({0.3, 0.3, 0}), 1e-14);
}

TEST(PointSharesTest, SmallestSimplicesCountAlikeIfTheyAreEqual) {
  const std::vector<RootPlace> square{{0.1, 0.1, 0}, {0.3, 0.1, 0}, {0.1, 0.3, 0}, {0.3, 0.3, 0}};
  const auto shares = shares_in_grid(square, {0.2, 0.2, 0});
  ASSERT_EQ(shares.size(), 4U);
  for (const ShareOfPoint& share : shares) EXPECT_NEAR(share.weight, 0.25, 1e-14);
  EXPECT_EQ(shares_in_grid(square, {0, 0, 0}).size(), 1U);
}

}  // namespace
}  // namespace ixos
