// Triangles: the rules of quadrature, and the linear one.
#include "fem/cells/triangles.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "fem/shape_table.hpp"

namespace ixos {
namespace {

double factorial(int n) { return std::tgamma(n + 1.0); }

/// The integral of x^i y^j over the triangle is i! j! / (i + j + 2)!.
TEST(Tri3Test, RulesAreExactToTheirDegree) {
  for (int along = 1; along <= 12; ++along) {
    const QuadratureRule<2> rule = triangle_rule(along);
    constexpr std::array<int, 6> listed{0, 1, 4, 5, 6, 8};
    const int degree = along < 6 ? listed.at(static_cast<std::size_t>(along)) : 2 * along - 1;
    for (double weight : rule.weights) EXPECT_GT(weight, 0);
    for (const auto& point : rule.points) EXPECT_TRUE(is_inside<ReferenceShape::Triangle>(point, 0));
    for (int i = 0; i <= degree; ++i)
      for (int j = 0; i + j <= degree; ++j) {
        double sum = 0;
        for (std::size_t q = 0; q < rule.size(); ++q)
          sum += rule.weights[q] * std::pow(rule.points[q][0], i) * std::pow(rule.points[q][1], j);
        EXPECT_NEAR(sum, factorial(i) * factorial(j) / factorial(i + j + 2), 1e-15) << along << ": " << i << ", " << j;
      }
  }
  EXPECT_THROW(triangle_rule(0), InputError);
  EXPECT_THROW(triangle_rule(65), InputError);
}

TEST(Tri3Test, FunctionsAreOneAtTheirCornersAndSumToOne) {
  const std::array<std::array<double, 2>, 3> corners{{{0, 0}, {1, 0}, {0, 1}}};
  std::array<double, 3> value;
  std::array<std::array<double, 2>, 3> gradient;
  for (std::size_t c = 0; c < 3; ++c) {
    Tri3::evaluate(corners[c], value, gradient);
    for (std::size_t a = 0; a < 3; ++a) EXPECT_EQ(value[a], a == c ? 1 : 0);
  }
  Tri3::evaluate({0.2, 0.3}, value, gradient);
  EXPECT_NEAR(value[0] + value[1] + value[2], 1, 1e-15);
  for (std::size_t d = 0; d < 2; ++d) EXPECT_EQ(gradient[0][d] + gradient[1][d] + gradient[2][d], 0);
}

TEST(Tri3Test, OnePointForStressesAndEnoughForTheMass) {
  EXPECT_EQ(own_rule<Tri3>().size(), 1U);
  EXPECT_EQ(ShapeTable<Tri3>().size(), 1U);
  EXPECT_FALSE(ShapeTable<Tri3>().two_points);
  EXPECT_EQ(element_rule<Tri3>(3).size(), 7U);
  EXPECT_GT(mass_rule<Tri3>().size(), 2U);
}

TEST(Tri3Test, InsideMeansTheTriangle) {
  EXPECT_TRUE((is_inside<ReferenceShape::Triangle, 2>({0.5, 0.5}, 1e-12)));
  EXPECT_FALSE((is_inside<ReferenceShape::Triangle, 2>({0.6, 0.5}, 1e-12)));
  EXPECT_FALSE((is_inside<ReferenceShape::Triangle, 2>({-0.1, 0.5}, 1e-12)));
  EXPECT_FALSE((is_inside<ReferenceShape::Triangle, 2>({std::nan(""), 0.5}, 1e-12)));
  EXPECT_TRUE((is_inside<ReferenceShape::Quadrilateral, 2>({-1, 1}, 1e-12)));
  EXPECT_FALSE((is_inside<ReferenceShape::Hexahedron, 3>({0, 0, 1.1}, 1e-12)));
}

}  // namespace
}  // namespace ixos
