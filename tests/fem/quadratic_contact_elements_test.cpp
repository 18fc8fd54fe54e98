// Quadratic cells with a contact side of fourth order: their functions, sides and ties.
#include "fem/with_element.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

#include "fem/enriched_cell.hpp"
#include "fem/quadratic_contact_elements.hpp"

namespace ixos {
namespace {

template <class Element>
class QuadraticContactElementsTest : public testing::Test {
 public:
  static constexpr std::size_t N = Element::nodes, D = Element::dimension;
  using Point = std::array<double, D>;
  struct Shapes {
    explicit Shapes(const Point& xi, unsigned tied = 0) { evaluate_tied<Element>(tied, xi, value, gradient); }
    std::array<double, N> value;
    std::array<Point, N> gradient;
  };
  /// Points inside, on the boundary and outside of the reference domain.
  static std::vector<Point> samples() {
    std::vector<Point> points(8);
    double phase = 0.4;
    for (Point& point : points)
      for (double& x : point) x = 1.1 * std::sin(phase += 1.7);
    points.back().fill(1.0);
    points[0][D - 1] = points[1][D - 1] = -1;  // on the contact side
    return points;
  }
  /// The interpolation of a function of the place.
  template <class Function>
  static double interpolated(const Point& xi, const Function& function, unsigned tied = 0) {
    const Shapes shapes(xi, tied);
    double sum = 0;
    for (std::size_t a = 0; a < N; ++a) sum += shapes.value[a] * function(Element::place(a));
    return sum;
  }
};

using Elements = testing::Types<Quad9C4, Hex27C4>;
TYPED_TEST_SUITE(QuadraticContactElementsTest, Elements);

TYPED_TEST(QuadraticContactElementsTest, AreOneAtTheirNodeAndZeroAtTheOthers) {
  for (std::size_t b = 0; b < this->N; ++b) {
    const typename TestFixture::Shapes shapes(TypeParam::place(b));
    for (std::size_t a = 0; a < this->N; ++a) EXPECT_EQ(shapes.value[a], a == b ? 1.0 : 0.0) << a << ' ' << b;
  }
}

TYPED_TEST(QuadraticContactElementsTest, BeginWithTheNodesOfTheQuadraticElement) {
  using Plain = std::conditional_t<TypeParam::dimension == 2, Quad9, Hex27>;
  for (std::size_t a = 0; a < Plain::nodes; ++a)
    for (std::size_t d = 0; d < this->D; ++d)
      EXPECT_EQ(TypeParam::place(a)[d], Plain::Edge::node(Plain::factors(a)[d])) << a;
}

// Complete of degree 2 in each direction inside, of degree 4 along the contact side.
TYPED_TEST(QuadraticContactElementsTest, ReproduceSquaresInsideAndFourthPowersOnTheSide) {
  using Place = typename TestFixture::Point;
  const auto squares = [](const Place& x) {
    double product = 1;
    for (double c : x) product *= 0.3 + c - 0.7 * c * c;
    return product;
  };
  const auto fourth = [](const Place& x) {
    double product = 1;
    for (std::size_t d = 0; d + 1 < x.size(); ++d) product *= 0.2 - x[d] + 0.4 * std::pow(x[d], 3) + std::pow(x[d], 4);
    return product;
  };
  for (Place xi : this->samples()) {
    EXPECT_NEAR(this->interpolated(xi, squares), squares(xi), 1e-13);
    for (unsigned tied = 1; tied < 16; tied *= 2)
      EXPECT_NEAR(this->interpolated(xi, squares, tied), squares(xi), 1e-13) << "tied " << tied;
    xi.back() = -1;
    EXPECT_NEAR(this->interpolated(xi, fourth), fourth(xi), 1e-13);
  }
}

TYPED_TEST(QuadraticContactElementsTest, GradientsAreDerivatives) {
  const double h = 1e-5;
  for (const auto& xi : this->samples())
    for (unsigned tied : {0U, 1U})
      for (std::size_t d = 0; d < this->D; ++d) {
        auto left = xi, right = xi;
        left[d] -= h;
        right[d] += h;
        using Here = typename TestFixture::Shapes;
        const Here at(xi, tied), before(left, tied), after(right, tied);
        for (std::size_t a = 0; a < this->N; ++a)
          EXPECT_NEAR(at.gradient[a][d], (after.value[a] - before.value[a]) / (2 * h), 1e-8) << a;
      }
}

// A tied edge has the field of a quadratic neighbour: that of its ends and its middle.
TYPED_TEST(QuadraticContactElementsTest, ATiedEdgeIsQuadratic) {
  for (const InnerNode& inner : TypeParam::inner_nodes()) {
    const typename TestFixture::Shapes shapes(TypeParam::place(inner.node), 1U << inner.edge);
    EXPECT_EQ(shapes.value[inner.node], 0.0);
    EXPECT_DOUBLE_EQ(shapes.value[inner.first], inner.first_share);
    EXPECT_DOUBLE_EQ(shapes.value[inner.second], inner.second_share);
    EXPECT_DOUBLE_EQ(shapes.value[inner.middle], 0.75);
    EXPECT_EQ(inner.first_share + inner.second_share + inner.middle_share, 1.0);
  }
}

// The element of each side is the trace of the cell, with an edge that is tied and without one.
TEST(QuadraticContactSidesTest, AreTracesOfTheHexahedron) {
  using Cell = QuadraticContactElementsTest<Hex27C4>;
  struct {
    CellType type = CellType::Hex27C4;
    unsigned tied = 0;
  } block;
  for (block.tied = 0; block.tied < 16; ++block.tied)
    for (int side = 0; side < 6; ++side)
      with_side_element(block.type, side, [&](auto tag) {
        using Side = typename decltype(tag)::type;
        const std::vector<int>& nodes = side_nodes(block.type, side);
        ASSERT_EQ(nodes.size(), static_cast<std::size_t>(Side::nodes));
        if constexpr (Side::dimension == 2)
          for (const std::array<double, 2>& xi :
               {std::array{0.3, -0.7}, std::array{-0.9, 0.2}, std::array{0.1, -1.0}}) {
            std::array<double, Side::nodes> value;
            std::array<std::array<double, 2>, Side::nodes> gradient;
            evaluate_tied<Side>(side_ties(block, side), xi, value, gradient);
            std::array<double, 4> corner;
            std::array<std::array<double, 2>, 4> unused;
            Quad4::evaluate(xi, corner, unused);
            Cell::Point place{};
            for (std::size_t c = 0; c < 4; ++c)
              for (std::size_t d = 0; d < 3; ++d)
                place[d] += corner[c] * Hex27C4::place(static_cast<std::size_t>(nodes[c]))[d];
            const Cell::Shapes cell(place, block.tied);
            for (std::size_t a = 0; a < value.size(); ++a)
              EXPECT_NEAR(value[a], cell.value[static_cast<std::size_t>(nodes[a])], 1e-14) << side << ' ' << block.tied;
          }
      });
}

TEST(QuadraticElementTest, ElementsAreQuadraticIfTheirCellTypesAre) {
  for (const CellType type : {CellType::Quad4, CellType::Hex8, CellType::Quad4C2, CellType::Quad4C3, CellType::Quad4C4,
                              CellType::Quad4CH, CellType::Hex8C2, CellType::Hex8C3, CellType::Hex8C4, CellType::Hex8CH,
                              CellType::Quad9, CellType::Hex27, CellType::Quad9C4, CellType::Hex27C4})
    with_element(type, [&](auto tag) {
      EXPECT_EQ(is_quadratic_element<typename decltype(tag)::type>, is_quadratic(type)) << static_cast<int>(type);
    });
}

TEST(QuadraticContactSidesTest, AreTracesOfTheQuadrilateral) {
  EXPECT_EQ(side_nodes(CellType::Quad9C4, 0), (std::vector<int>{0, 1, 9, 4, 10}));
  for (std::size_t a = 0; a < 5; ++a) EXPECT_EQ(Quad9C4::place(Quad9C4::edge_node(a))[0], LagrangeEdge<4>::node(a));
}

}  // namespace
}  // namespace ixos
