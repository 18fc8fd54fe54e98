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

template <class Face>
std::vector<Point<2>> face_places() {
  std::vector<Point<2>> places;
  for (std::size_t a = 0; a < Face::nodes; ++a) {
    const auto [i, j] = Face::factors(a);
    places.push_back({Face::Edge::node(i), Face::Edge::node(j)});
  }
  return places;
}

/// Reference coordinates of the nodes of ContactHex<Face>.
template <class Face>
std::vector<Point<3>> places() {
  std::vector<Point<3>> result(ContactHex<Face>::nodes);
  const auto corner = corners<3>();
  for (std::size_t a = 4; a < 8; ++a) result[a] = corner[a];
  const auto on_face = face_places<Face>();
  for (std::size_t a = 0; a < on_face.size(); ++a)
    result[ContactHex<Face>::face_node(a)] = {on_face[a][1], on_face[a][0], -1.0};
  return result;
}

const std::vector<Point<3>> samples{{-0.7, 0.2, -0.9}, {0.1, -0.6, 0.3}, {0.8, 0.5, -1.0}, {-0.35, 0.9, 0.7}};

template <class Face>
class ContactHexTest : public testing::Test {};
using Faces = testing::Types<LagrangeFace<2>, LagrangeFace<3>, LagrangeFace<4>>;
TYPED_TEST_SUITE(ContactHexTest, Faces);

TYPED_TEST(ContactHexTest, FunctionsAreOneAtTheirNodeAndZeroAtTheOthers) {
  const auto place = places<TypeParam>();
  std::set<Point<3>> distinct(place.begin(), place.end());
  EXPECT_EQ(distinct.size(), place.size());
  for (std::size_t b = 0; b < place.size(); ++b) {
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
        sum += shapes.value[a];
        for (std::size_t d = 0; d < 3; ++d) {
          slope[d] += shapes.gradient[a][d];
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
  const auto place = places<TypeParam>();
  constexpr int order = TypeParam::Edge::nodes - 1;
  for (int k = 0; k <= order; ++k)
    for (int l = 0; l <= order; ++l)
      for (const Point<2>& x : {Point<2>{-0.9, 0.3}, {0.2, 0.75}}) {
        const At<ContactHex<TypeParam>> shapes({x[0], x[1], -1.0});
        double sum = 0;
        for (std::size_t a = 0; a < place.size(); ++a)
          sum += shapes.value[a] * std::pow(place[a][0], k) * std::pow(place[a][1], l);
        EXPECT_NEAR(sum, std::pow(x[0], k) * std::pow(x[1], l), 1e-13);
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

TYPED_TEST(ContactHexTest, InnerNodesLieOnTheirEdges) {
  const auto place = places<TypeParam>();
  const auto inner = ContactHex<TypeParam>::inner_nodes();
  EXPECT_EQ(inner.size(), 4U * (TypeParam::Edge::nodes - 2));
  for (const InnerNode& node : inner)
    for (std::size_t d = 0; d < 3; ++d)
      EXPECT_NEAR(place[node.node][d], (1 - node.place) * place[node.first][d] + node.place * place[node.second][d],
                  1e-15);
}

TYPED_TEST(ContactHexTest, TablesIntegrateTheVolume) {
  for (unsigned tied : {0U, 6U}) {
    const ShapeTable<ContactHex<TypeParam>> table(ContactHex<TypeParam>::default_points, tied);
    double volume = 0;
    for (std::size_t q = 0; q < table.size(); ++q)
      for (double value : table.value[q]) volume += table.weight[q] * value;
    EXPECT_NEAR(volume, 8.0, 1e-13);
    EXPECT_EQ(table.size(), 2U * TypeParam::Edge::nodes * TypeParam::Edge::nodes);
  }
}

}  // namespace
}  // namespace ixos
