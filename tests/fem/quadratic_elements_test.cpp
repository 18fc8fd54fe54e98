#include "fem/with_element.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

#include "fem/quadratic_elements.hpp"
#include "fem/shape_table.hpp"

namespace ixos {
namespace {

template <std::size_t D>
using Point = std::array<double, D>;

/// The nodes of the Exodus standard's QUAD9 and HEX27, from its figures: corners, middles of edges, then the inside and
/// the faces.
std::vector<Point<2>> standard_nodes(Quad9*) {
  return {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}};
}
std::vector<Point<3>> standard_nodes(Hex27*) {
  return {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1},  {1, 1, 1},
          {-1, 1, 1},   {0, -1, -1}, {1, 0, -1}, {0, 1, -1},  {-1, 0, -1}, {-1, -1, 0}, {1, -1, 0},
          {1, 1, 0},    {-1, 1, 0},  {0, -1, 1}, {1, 0, 1},   {0, 1, 1},   {-1, 0, 1},  {0, 0, 0},
          {0, 0, -1},   {0, 0, 1},   {-1, 0, 0}, {1, 0, 0},   {0, -1, 0},  {0, 1, 0}};
}

template <class Element>
struct Shapes {
  using Here = Point<Element::dimension>;
  static constexpr std::size_t N = Element::nodes;
  static constexpr std::size_t D = Element::dimension;

  explicit Shapes(const Here& xi) { Element::evaluate(xi, value, gradient); }
  static std::vector<Here> nodes() { return standard_nodes(static_cast<Element*>(nullptr)); }
  /// Points inside, on the boundary and outside of the reference domain.
  static std::vector<Here> samples() {
    std::vector<Here> points;
    double phase = 0.4;
    for (int i = 0; i < 6; ++i) {
      points.emplace_back();
      for (double& x : points.back()) x = 1.1 * std::sin(phase += 1.7);
    }
    points.emplace_back();
    points.back().fill(1.0);
    return points;
  }

  std::array<double, N> value;
  std::array<Here, N> gradient;
};

template <class S>
class QuadraticElementsTest : public testing::Test {};
using Elements = testing::Types<Shapes<Quad9>, Shapes<Hex27>>;
TYPED_TEST_SUITE(QuadraticElementsTest, Elements);

TYPED_TEST(QuadraticElementsTest, AreOneAtTheirNodeOfTheStandardAndZeroAtTheOthers) {
  const auto nodes = TypeParam::nodes();
  for (std::size_t b = 0; b < TypeParam::N; ++b) {
    const TypeParam shapes(nodes[b]);
    for (std::size_t a = 0; a < TypeParam::N; ++a) EXPECT_EQ(shapes.value[a], a == b ? 1.0 : 0.0) << a << ' ' << b;
  }
}

TYPED_TEST(QuadraticElementsTest, ReproduceProductsOfSquares) {
  const auto nodes = TypeParam::nodes();
  for (const auto& xi : TypeParam::samples()) {
    const TypeParam shapes(xi);
    double one = 0, product = 0, exact = 1;
    for (std::size_t a = 0; a < TypeParam::N; ++a) {
      double at_node = 1;
      for (double x : nodes[a]) at_node *= 0.3 + x - 0.7 * x * x;
      one += shapes.value[a];
      product += shapes.value[a] * at_node;
    }
    for (double x : xi) exact *= 0.3 + x - 0.7 * x * x;
    EXPECT_NEAR(one, 1, 1e-14);
    EXPECT_NEAR(product, exact, 1e-14);
  }
}

TYPED_TEST(QuadraticElementsTest, GradientsAreDifferenceQuotients) {
  // The functions are of second degree in each coordinate: the central difference is exact for any step.
  const double h = 0.25;
  for (const auto& xi : TypeParam::samples())
    for (std::size_t d = 0; d < TypeParam::D; ++d) {
      auto ahead = xi, behind = xi;
      ahead[d] += h;
      behind[d] -= h;
      const TypeParam shapes(xi), after(ahead), before(behind);
      for (std::size_t a = 0; a < TypeParam::N; ++a)
        EXPECT_NEAR(shapes.gradient[a][d], (after.value[a] - before.value[a]) / (2 * h), 1e-14);
    }
}

TYPED_TEST(QuadraticElementsTest, TheTableIntegratesTheFifthDegree) {
  using Element = std::conditional_t<TypeParam::D == 2, Quad9, Hex27>;
  const ShapeTable<Element> table;
  for (int degree = 0; degree <= 5; ++degree) {
    double sum = 0;
    for (std::size_t q = 0; q < table.size(); ++q) {
      double value = table.weight[q];
      for (double x : table.point[q]) value *= std::pow(x, degree);
      sum += value;
    }
    const double edge = degree % 2 == 0 ? 2.0 / (degree + 1) : 0.0;
    const double expected = std::pow(edge, TypeParam::D);
    EXPECT_NEAR(sum, expected, 1e-14 * std::max(1.0, expected)) << degree;
  }
}

/// The reference coordinates of the nodes of the sides' elements.
std::vector<Point<1>> standard_nodes(LagrangeEdge<2>*) { return {{-1}, {1}, {0}}; }

/// Expects that the nodes of each side stand where the side's element has them between the corners of a linear cell's.
template <class Element, class Side>
void expect_sides_in_order(CellType type) {
  constexpr std::size_t D = Element::dimension;
  using Corners = Multilinear<Side::dimension>;
  const auto nodes = standard_nodes(static_cast<Element*>(nullptr));
  const auto on_side = standard_nodes(static_cast<Side*>(nullptr));
  EXPECT_EQ(nodes_per_cell(type), static_cast<int>(nodes.size()));
  for (int side = 0; side < sides_per_cell(type); ++side) {
    with_side_element(type, side,
                      [&](auto tag) { EXPECT_TRUE((std::is_same_v<typename decltype(tag)::type, Side>)) << side; });
    const std::vector<int>&own = side_nodes(type, side), &corners = side_nodes(corner_type(type), side);
    ASSERT_EQ(own.size(), on_side.size());
    for (std::size_t a = 0; a < own.size(); ++a) {
      std::array<double, Corners::nodes> value;
      std::array<Point<D - 1>, Corners::nodes> slope;
      Corners::evaluate(on_side[a], value, slope);
      for (std::size_t d = 0; d < D; ++d) {
        double place = 0;
        for (std::size_t c = 0; c < corners.size(); ++c)
          place += value[c] * nodes[static_cast<std::size_t>(corners[c])][d];
        EXPECT_EQ(nodes[static_cast<std::size_t>(own[a])][d], place) << "side " << side << ", node " << a;
      }
    }
  }
}

TEST(QuadraticSidesTest, AreInTheOrderOfTheirElementsAndHaveTheCornersOfLinearCells) {
  expect_sides_in_order<Quad9, LagrangeEdge<2>>(CellType::Quad9);
  expect_sides_in_order<Hex27, LagrangeFace<2>>(CellType::Hex27);
}

TEST(QuadraticSidesTest, TypesAreOfOneFamily) {
  for (const auto& [type, corners] :
       {std::pair{CellType::Quad9, CellType::Quad4}, std::pair{CellType::Hex27, CellType::Hex8}}) {
    EXPECT_EQ(corner_type(type), corners);
    EXPECT_TRUE(is_quadratic(type));
    EXPECT_FALSE(is_quadratic(corners));
    EXPECT_FALSE(is_enriched(type));
    EXPECT_EQ(contact_side(type), -1);
    EXPECT_EQ(sides_per_cell(type), sides_per_cell(corners));
  }
}

}  // namespace
}  // namespace ixos
