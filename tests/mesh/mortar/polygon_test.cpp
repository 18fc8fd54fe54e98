#include "mesh/mortar/polygon.hpp"

#include <gtest/gtest.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>
#include <random>

namespace ixos {
namespace {

namespace bg = boost::geometry;
using BoostPolygon = bg::model::polygon<bg::model::d2::point_xy<double>>;

/// A convex quadrilateral around a point.
Polygon around(const Vec<2>& middle, std::mt19937& random) {
  std::uniform_real_distribution<double> radius(0.7, 1.0), angle(-0.2, 0.2);
  Polygon polygon;
  for (int k = 0; k < 4; ++k) {
    const double phi = 1.5707963267948966 * k + angle(random), r = radius(random);
    polygon.push_back(middle + r * Vec<2>{std::cos(phi), std::sin(phi)});
  }
  return polygon;
}

BoostPolygon of_boost(const Polygon& polygon) {
  BoostPolygon result;
  for (const Vec<2>& corner : polygon) bg::append(result, bg::model::d2::point_xy<double>(corner[0], corner[1]));
  bg::correct(result);
  return result;
}

TEST(PolygonTest, CommonPartsHaveTheAreasThatBoostFinds) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-1.5, 1.5);
  int common = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Polygon a = around({0, 0}, random), b = around({place(random), place(random)}, random);
    std::vector<BoostPolygon> parts;
    bg::intersection(of_boost(a), of_boost(b), parts);
    double expected = 0;
    for (const BoostPolygon& part : parts) expected += bg::area(part);
    // Boost 1.74 rounds corners to a grid of 1e-8 of the extent.
    EXPECT_NEAR(area(common_part(a, b)), expected, 1e-6) << trial;
    EXPECT_NEAR(area(common_part(b, a)), area(common_part(a, b)), 1e-14) << trial;
    if (expected > 0) ++common;
  }
  EXPECT_GT(common, 150);
}

TEST(PolygonTest, EdgesThatCoincideCutNothing) {
  const Polygon square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ(area(common_part(square, square)), 1);
  EXPECT_TRUE(common_part(square, {{1, 0}, {2, 0}, {2, 1}, {1, 1}}).empty());
  EXPECT_TRUE(common_part(square, {{-1, 1}, {2, 1}, {2, 2}, {-1, 2}}).empty());
  EXPECT_NEAR(area(common_part(square, {{0, 1e-16}, {1, -1e-16}, {1, 0.5}, {0, 0.5}})), 0.5, 1e-15);
}

TEST(PolygonTest, SegmentsHaveALength) {
  const Polygon part = common_part({{0, 0}, {2, 0}}, {{1.5, 0}, {3, 0}});
  EXPECT_DOUBLE_EQ(area(part), 0.5);
  EXPECT_TRUE(common_part({{0, 0}, {1, 0}}, {{1, 0}, {3, 0}}).empty());
}

TEST(PolygonTest, RulesIntegrateTheirDegree) {
  const Polygon triangle{{0, 0}, {1, 0}, {0, 1}}, segment{{0, 0}, {2, 0}};
  for (const int degree : {1, 2, 4, 5, 8, 12, 18}) {
    double sum = 0, line = 0;
    for (const auto& [x, weight] : points_of(triangle, degree)) sum += weight * std::pow(x[0], degree);
    for (const auto& [x, weight] : points_of(segment, degree)) line += weight * std::pow(x[0], degree);
    EXPECT_NEAR(sum, 1.0 / (degree + 1) / (degree + 2), 1e-14) << degree;
    EXPECT_NEAR(line / std::pow(2, degree + 1), 1.0 / (degree + 1), 1e-14) << degree;
  }
}

}  // namespace
}  // namespace ixos
