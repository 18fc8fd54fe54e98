// Hexahedra with an enriched contact face, and tied edges.
#include "fem/contact_hexahedra.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "base/small_matrix.hpp"
#include "fem/shape_table.hpp"

namespace ixos {
namespace {

template <std::size_t D>
using Point = std::array<double, D>;

/// Shape functions at a point.
template <class Element>
struct At {
  static constexpr std::size_t N = Element::nodes;
  static constexpr std::size_t D = Element::dimension;
  explicit At(const Point<D>& xi, unsigned tied = 0) { evaluate_tied<Element>(tied, xi, value, gradient); }
  std::array<double, N> value;
  std::array<Point<D>, N> gradient;
};

/// The k-th derivative of x^n.
double power(double x, int n, std::size_t k) {
  double factor = 1;
  for (; k > 0; --k) factor *= n--;
  return factor == 0 ? 0 : factor * std::pow(x, n);
}

/// x^k y^l at the face's nodes, or its derivative that a node stands for.
template <class Face>
std::vector<double> face_values(int k, int l) {
  std::vector<double> values;
  for (std::size_t a = 0; a < Face::nodes; ++a) {
    const auto [i, j] = Face::factors(a);
    if constexpr (IsHermite<Face>::value)
      values.push_back(power(i % 2 == 0 ? -1 : 1, k, i / 2) * power(j % 2 == 0 ? -1 : 1, l, j / 2));
    else
      values.push_back(std::pow(Face::Edge::node(i), k) * std::pow(Face::Edge::node(j), l));
  }
  return values;
}

/// Reference coordinates of the nodes of ContactHex<Face>, or their derivatives.
template <class Face>
std::vector<Point<3>> places() {
  std::vector<Point<3>> result(ContactHex<Face>::nodes);
  const auto corner = corners<3>();
  for (std::size_t a = 4; a < 8; ++a) result[a] = corner[a];
  const auto first = face_values<Face>(1, 0), second = face_values<Face>(0, 1), one = face_values<Face>(0, 0);
  for (std::size_t a = 0; a < first.size(); ++a)
    result[ContactHex<Face>::face_node(a)] = {second[a], first[a], -one[a]};
  return result;
}

/// How many of the nodes are points.
template <class Face>
constexpr std::size_t points = IsHermite<Face>::value ? 8 : ContactHex<Face>::nodes;

const std::vector<Point<3>> samples{{-0.7, 0.2, -0.9}, {0.1, -0.6, 0.3}, {0.8, 0.5, -1.0}, {-0.35, 0.9, 0.7}};

template <class Face>
class ContactHexTest : public testing::Test {};
using Faces = testing::Types<LagrangeFace<2>, LagrangeFace<3>, LagrangeFace<4>, HermiteFace>;
TYPED_TEST_SUITE(ContactHexTest, Faces);

TYPED_TEST(ContactHexTest, FunctionsAreOneAtTheirNodeAndZeroAtTheOthers) {
  const auto place = places<TypeParam>();
  std::set<Point<3>> distinct(place.begin(), place.begin() + points<TypeParam>);
  EXPECT_EQ(distinct.size(), points<TypeParam>);
  for (std::size_t b = 0; b < points<TypeParam>; ++b) {
    const At<ContactHex<TypeParam>> shapes(place[b]);
    for (std::size_t a = 0; a < place.size(); ++a) EXPECT_NEAR(shapes.value[a], a == b ? 1.0 : 0.0, 1e-14);
  }
}

TYPED_TEST(ContactHexTest, FirstEightNodesAreThoseOfTheHexahedron) {
  const auto place = places<TypeParam>();
  for (std::size_t a = 0; a < 8; ++a) EXPECT_EQ(place[a], corners<3>()[a]);
}

TYPED_TEST(ContactHexTest, FunctionsHoldConstantsAndThePlaceWhateverIsTied) {
  const auto place = places<TypeParam>();
  for (unsigned tied = 0; tied < 16; ++tied)
    for (const Point<3>& xi : samples) {
      const At<ContactHex<TypeParam>> shapes(xi, tied);
      double sum = 0;
      Point<3> slope{}, x{};
      Small<double, 3> h{};
      for (std::size_t a = 0; a < place.size(); ++a) {
        if (a < points<TypeParam>) sum += shapes.value[a];
        for (std::size_t d = 0; d < 3; ++d) {
          if (a < points<TypeParam>) slope[d] += shapes.gradient[a][d];
          x[d] += shapes.value[a] * place[a][d];
          for (std::size_t e = 0; e < 3; ++e) h[d][e] += place[a][d] * shapes.gradient[a][e];
        }
      }
      EXPECT_NEAR(sum, 1.0, 1e-14);
      for (std::size_t d = 0; d < 3; ++d) {
        EXPECT_NEAR(slope[d], 0.0, 1e-13);
        EXPECT_NEAR(x[d], xi[d], 1e-14);
        for (std::size_t e = 0; e < 3; ++e) EXPECT_NEAR(h[d][e], d == e ? 1.0 : 0.0, 1e-13);
      }
    }
}

TYPED_TEST(ContactHexTest, GradientsAreDifferenceQuotients) {
  const double h = 1e-5;
  for (unsigned tied : {0U, 5U, 15U})
    for (const Point<3>& xi : samples)
      for (std::size_t d = 0; d < 3; ++d) {
        auto ahead = xi, behind = xi;
        ahead[d] += h;
        behind[d] -= h;
        const At<ContactHex<TypeParam>> here(xi, tied), after(ahead, tied), before(behind, tied);
        for (std::size_t a = 0; a < here.value.size(); ++a)
          EXPECT_NEAR(here.gradient[a][d], (after.value[a] - before.value[a]) / (2 * h), 1e-8);
      }
}

TYPED_TEST(ContactHexTest, ContactFaceHoldsPolynomialsOfItsOrderInEachDirection) {
  constexpr int order = TypeParam::Edge::nodes - 1;
  for (int k = 0; k <= order; ++k)
    for (int l = 0; l <= order; ++l) {
      const auto nodal = face_values<TypeParam>(k, l);
      for (const Point<2>& x : {Point<2>{-0.9, 0.3}, {0.2, 0.75}}) {
        const At<ContactHex<TypeParam>> shapes({x[1], x[0], -1.0});  // seen from outside
        double sum = 0;
        for (std::size_t a = 0; a < nodal.size(); ++a)
          sum += shapes.value[ContactHex<TypeParam>::face_node(a)] * nodal[a];
        EXPECT_NEAR(sum, std::pow(x[0], k) * std::pow(x[1], l), 1e-13);
      }
    }
}

TYPED_TEST(ContactHexTest, SidesAreLinearUpwardsAndTheFarFaceIsBilinear) {
  for (double s : {-1.0, -0.3, 0.4, 1.0})
    for (double t : {-0.8, 0.1, 1.0}) {
      const At<ContactHex<TypeParam>> far({s, t, 1.0});
      const At<Hex8> plain({s, t, 1.0});
      for (std::size_t a = 0; a < far.value.size(); ++a) EXPECT_NEAR(far.value[a], a < 8 ? plain.value[a] : 0.0, 1e-15);
      for (const Point<3>& xi : {Point<3>{-1, s, t}, {1, s, t}, {s, -1, t}, {s, 1, t}}) {
        const At<ContactHex<TypeParam>> here(xi), low({xi[0], xi[1], -1}), high({xi[0], xi[1], 1});
        for (std::size_t a = 0; a < here.value.size(); ++a)
          EXPECT_NEAR(here.value[a], (1 - t) / 2 * low.value[a] + (1 + t) / 2 * high.value[a], 1e-15);
      }
    }
}

TYPED_TEST(ContactHexTest, ATiedEdgeIsStraightAndTheSideAboveItBilinear) {
  // Edges of the face, seen from outside: at xi = -1, eta = 1, xi = 1, eta = -1.
  const Point<3> on_edge[] = {{-1, 0.3, 0}, {0.3, 1, 0}, {1, 0.3, 0}, {0.3, -1, 0}};
  for (unsigned tied = 0; tied < 16; ++tied)
    for (unsigned edge = 0; edge < 4; ++edge)
      for (double height : {-1.0, -0.2, 0.6}) {
        Point<3> xi = on_edge[edge];
        xi[2] = height;
        const At<ContactHex<TypeParam>> shapes(xi, tied), free(xi);
        const At<Hex8> plain(xi);
        for (std::size_t a = 0; a < shapes.value.size(); ++a) {
          const double straight = a < 8 ? plain.value[a] : 0.0;
          EXPECT_NEAR(shapes.value[a], (tied >> edge & 1U) != 0 ? straight : free.value[a], 1e-14);
        }
      }
}

TYPED_TEST(ContactHexTest, InnerNodesAreWhatAStraightEdgeMakesThem) {
  const auto place = places<TypeParam>();
  const auto inner = ContactHex<TypeParam>::inner_nodes();
  EXPECT_EQ(inner.size(), 4U * (TypeParam::Edge::nodes - 2));
  for (const InnerNode& node : inner)
    for (std::size_t d = 0; d < 3; ++d)
      EXPECT_NEAR(place[node.node][d],
                  node.first_share * place[node.first][d] + node.second_share * place[node.second][d], 1e-15);
}

TYPED_TEST(ContactHexTest, TablesIntegrateTheVolume) {
  for (unsigned tied : {0U, 6U}) {
    const ShapeTable<ContactHex<TypeParam>> table(own_rule<ContactHex<TypeParam>>(), tied);
    double volume = 0;
    for (std::size_t q = 0; q < table.size(); ++q)
      for (std::size_t a = 0; a < points<TypeParam>; ++a) volume += table.weight[q] * table.value[q][a];
    EXPECT_NEAR(volume, 8.0, 1e-13);
    EXPECT_EQ(table.size(), 2U * static_cast<std::size_t>(TypeParam::default_points[0] * TypeParam::default_points[1]));
  }
}

TEST(HermiteFaceTest, EachFunctionHasOneOfValueAndDerivativesAtOneCorner) {
  const Point<2> corner[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const double h = 1e-4;
  for (std::size_t c = 0; c < 4; ++c) {
    const At<HermiteFace> here(corner[c]), above({corner[c][0], corner[c][1] + h}),
        below({corner[c][0], corner[c][1] - h});
    for (std::size_t a = 0; a < 16; ++a) {
      const double mixed = (above.gradient[a][0] - below.gradient[a][0]) / (2 * h);
      EXPECT_EQ(here.value[a], a == c ? 1 : 0);
      EXPECT_EQ(here.gradient[a][0], a == 4 + 3 * c ? 1 : 0);
      EXPECT_EQ(here.gradient[a][1], a == 5 + 3 * c ? 1 : 0);
      EXPECT_NEAR(mixed, a == 6 + 3 * c ? 1 : 0, 1e-7);
    }
  }
}

}  // namespace
}  // namespace ixos
