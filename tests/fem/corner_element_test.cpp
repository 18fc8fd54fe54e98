#include "fem/corner_element.hpp"

#include <gtest/gtest.h>

#include "fem/shape_table.hpp"

namespace ixos {
namespace {

template <class Element>
class CornerElementTest : public testing::Test {};
using Elements = testing::Types<LagrangeEdge<2>, Quad9, Hex27>;
TYPED_TEST_SUITE(CornerElementTest, Elements);

TYPED_TEST(CornerElementTest, LinearFunctionsAreSumsOfQuadraticOnes) {
  using Corners = typename CornerElement<TypeParam>::type;
  const auto shares = corner_shares<TypeParam>();
  const ShapeTable<TypeParam> table;
  const ShapeTable<Corners> corners(table);
  ASSERT_EQ(corners.size(), table.size());
  for (std::size_t q = 0; q < table.size(); ++q) {
    EXPECT_EQ(corners.weight[q], table.weight[q]);
    for (std::size_t c = 0; c < Corners::nodes; ++c) {
      double value = 0;
      std::array<double, TypeParam::dimension> gradient{};
      for (std::size_t a = 0; a < TypeParam::nodes; ++a) {
        value += shares[a][c] * table.value[q][a];
        for (std::size_t d = 0; d < gradient.size(); ++d) gradient[d] += shares[a][c] * table.gradient[q][a][d];
      }
      EXPECT_NEAR(corners.value[q][c], value, 1e-15);
      for (std::size_t d = 0; d < gradient.size(); ++d) EXPECT_NEAR(corners.gradient[q][c][d], gradient[d], 1e-15);
    }
  }
}

TYPED_TEST(CornerElementTest, ANodeTakesTheMeanOfItsCorners) {
  const auto shares = corner_shares<TypeParam>();
  for (std::size_t a = 0; a < shares.size(); ++a) {
    double sum = 0, square = 0;
    for (const double share : shares[a]) {
      sum += share;
      square += share * share;
    }
    EXPECT_EQ(sum, 1);
    double count = 0;
    for (const double share : shares[a]) count += share != 0 ? 1 : 0;
    EXPECT_EQ(square, 1 / count);  // only equal shares have this sum of squares
    EXPECT_EQ(count == 1, a < (1U << TypeParam::dimension));
  }
}

TEST(CornerElementSerialTest, OtherElementsHaveNone) {
  EXPECT_TRUE(std::is_void_v<CornerElement<Hex8>::type>);
  EXPECT_TRUE(std::is_void_v<CornerElement<LagrangeFace<3>>::type>);
}

// A corner has itself, the middle of an edge 2 corners, that of a face 4, that of a hexahedron 8.
TEST(CornerElementTest, ANodeHasTheCornersAroundIt) {
  for (int dimension : {2, 3}) {
    std::vector<std::size_t> count(9, 0);
    for (const auto& corners : corners_of_nodes(dimension)) ++count.at(corners.size());
    EXPECT_EQ(count, dimension == 2 ? (std::vector<std::size_t>{0, 4, 4, 0, 1, 0, 0, 0, 0})
                                    : (std::vector<std::size_t>{0, 8, 12, 0, 6, 0, 0, 0, 1}));
  }
  EXPECT_EQ(corners_of_nodes(3)[8], (std::vector<int>{0, 1}));         // the first edge
  EXPECT_EQ(corners_of_nodes(3)[21], (std::vector<int>{0, 1, 2, 3}));  // the bottom
}

}  // namespace
}  // namespace ixos
