#include "fem/reference_elements.hpp"

#include "fem/contact_elements.hpp"
#include "fem/shape_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ixos {
namespace {

template <int Dim>
struct Shapes {
  using Element = Multilinear<Dim>;
  using Point = std::array<double, Dim>;
  static constexpr std::size_t nodes = Element::nodes;
  static constexpr std::size_t dimension = Dim;

  explicit Shapes(const Point& xi) { Element::evaluate(xi, value, gradient); }

  /// Points inside, on the boundary and outside of the reference domain.
  static std::vector<Point> samples() {
    std::vector<Point> points;
    double phase = 0.4;
    for (int i = 0; i < 5; ++i) {
      points.emplace_back();
      for (double& x : points.back()) x = 1.1 * std::sin(phase += 1.7);
    }
    points.emplace_back();
    points.back().fill(1.0);
    return points;
  }

  std::array<double, nodes> value;
  std::array<Point, nodes> gradient;
};

template <class S>
class ShapesTest : public testing::Test {};
using Dimensions = testing::Types<Shapes<1>, Shapes<2>, Shapes<3>>;
TYPED_TEST_SUITE(ShapesTest, Dimensions);

TYPED_TEST(ShapesTest, ArePartitionOfUnity) {
  for (const auto& xi : TypeParam::samples()) {
    const TypeParam shapes(xi);
    double sum = 0;
    for (double value : shapes.value) sum += value;
    EXPECT_NEAR(sum, 1.0, 1e-14);
    for (std::size_t d = 0; d < TypeParam::dimension; ++d) {
      double slope = 0;
      for (const auto& gradient : shapes.gradient) slope += gradient[d];
      EXPECT_NEAR(slope, 0.0, 1e-14);
    }
  }
}

TYPED_TEST(ShapesTest, InterpolateTheReferencePointItself) {
  const auto corner = corners<static_cast<int>(TypeParam::dimension)>();
  for (const auto& xi : TypeParam::samples()) {
    const TypeParam shapes(xi);
    for (std::size_t d = 0; d < TypeParam::dimension; ++d) {
      double x = 0;
      for (std::size_t a = 0; a < TypeParam::nodes; ++a) x += shapes.value[a] * corner[a][d];
      EXPECT_NEAR(x, xi[d], 1e-14);
    }
  }
}

TYPED_TEST(ShapesTest, AreOneAtTheirCornerAndZeroAtTheOthers) {
  const auto corner = corners<static_cast<int>(TypeParam::dimension)>();
  for (std::size_t b = 0; b < TypeParam::nodes; ++b) {
    const TypeParam shapes(corner[b]);
    for (std::size_t a = 0; a < TypeParam::nodes; ++a) EXPECT_EQ(shapes.value[a], a == b ? 1.0 : 0.0);
  }
}

TYPED_TEST(ShapesTest, GradientsAreDifferenceQuotients) {
  // The functions are linear in each coordinate: the central difference is exact for any step.
  const double h = 0.25;
  for (const auto& xi : TypeParam::samples()) {
    const TypeParam shapes(xi);
    for (std::size_t d = 0; d < TypeParam::dimension; ++d) {
      auto ahead = xi, behind = xi;
      ahead[d] += h;
      behind[d] -= h;
      const TypeParam after(ahead), before(behind);
      for (std::size_t a = 0; a < TypeParam::nodes; ++a)
        EXPECT_NEAR(shapes.gradient[a][d], (after.value[a] - before.value[a]) / (2 * h), 1e-14);
    }
  }
}

template <class Element>
void expect_sound_table() {
  constexpr auto dim = static_cast<std::size_t>(Element::dimension);
  const ShapeTable<Element> table;
  const auto corner = corners<Element::dimension>();
  double volume = 0;
  std::array<std::array<double, dim>, dim> second{};  // integrals of xi_d xi_e
  for (std::size_t q = 0; q < table.weight.size(); ++q) {
    EXPECT_GT(table.weight[q], 0.0);
    volume += table.weight[q];
    std::array<double, dim> xi{};
    for (std::size_t a = 0; a < corner.size(); ++a)
      for (std::size_t d = 0; d < dim; ++d) xi[d] += table.value[q][a] * corner[a][d];
    const Shapes<Element::dimension> shapes(xi);
    for (std::size_t a = 0; a < corner.size(); ++a)
      for (std::size_t d = 0; d < dim; ++d) EXPECT_NEAR(table.gradient[q][a][d], shapes.gradient[a][d], 1e-14);
    for (std::size_t d = 0; d < dim; ++d)
      for (std::size_t e = 0; e < dim; ++e) second[d][e] += table.weight[q] * xi[d] * xi[e];
  }
  const double reference_volume = std::ldexp(1.0, Element::dimension);
  EXPECT_NEAR(volume, reference_volume, 1e-14);
  for (std::size_t d = 0; d < dim; ++d)
    for (std::size_t e = 0; e < dim; ++e) EXPECT_NEAR(second[d][e], d == e ? reference_volume / 3 : 0.0, 1e-14);
}

TEST(ReferenceElementTest, Quad4TableIntegratesQuadratics) { expect_sound_table<Quad4>(); }

TEST(ReferenceElementTest, Hex8TableIntegratesQuadratics) { expect_sound_table<Hex8>(); }

template <class Element>
class ContactElementTest : public testing::Test {};
using ContactElements = testing::Types<Quad4C2, Quad4C3, Quad4C4, Quad4CH>;
TYPED_TEST_SUITE(ContactElementTest, ContactElements);

/// Shape functions of an enriched element at a point.
template <class Element>
struct At {
  explicit At(const std::array<double, 2>& xi) { Element::evaluate(xi, value, gradient); }
  std::array<double, Element::nodes> value;
  std::array<std::array<double, 2>, Element::nodes> gradient;
};

TYPED_TEST(ContactElementTest, SideEdgesAndFarEdgeAreThoseOfTheBilinearElement) {
  // So that plain neighbours conform.
  for (double t : {-1.0, -0.3, 0.4, 1.0})
    for (const std::array<double, 2>& xi : {std::array{-1.0, t}, std::array{1.0, t}, std::array{t, 1.0}}) {
      const At<TypeParam> rich(xi);
      const At<Quad4> plain(xi);
      for (std::size_t a = 0; a < rich.value.size(); ++a)
        EXPECT_NEAR(rich.value[a], a < 4 ? plain.value[a] : 0.0, 1e-15);
    }
}

TYPED_TEST(ContactElementTest, GradientsAreDifferenceQuotients) {
  const double h = 1e-5;
  for (const std::array<double, 2>& xi : {std::array{-0.7, -0.9}, std::array{0.1, -0.2}, std::array{0.8, 0.5}})
    for (std::size_t d = 0; d < 2; ++d) {
      auto ahead = xi, behind = xi;
      ahead[d] += h;
      behind[d] -= h;
      const At<TypeParam> here(xi), after(ahead), before(behind);
      for (std::size_t a = 0; a < here.value.size(); ++a)
        EXPECT_NEAR(here.gradient[a][d], (after.value[a] - before.value[a]) / (2 * h), 1e-8);
    }
}

TYPED_TEST(ContactElementTest, ContactEdgeHoldsPolynomialsOfItsOrder) {
  // x^k on the edge, by its nodal values (and for the Hermite edge its end derivatives).
  constexpr bool hermite = std::is_same_v<TypeParam, Quad4CH>;
  const int order = hermite ? 3 : TypeParam::nodes - 3;
  for (int k = 0; k <= order; ++k)
    for (double x : {-0.9, -0.35, 0.2, 0.75}) {
      const At<TypeParam> shapes({x, -1.0});
      double sum = shapes.value[0] * std::pow(-1.0, k) + shapes.value[1];
      for (int a = 4; a < TypeParam::nodes; ++a) {
        const double place = -1 + 2.0 * (a - 3) / order;
        const double end = a == 4 ? -1.0 : 1.0;
        const double nodal = hermite ? (k == 0 ? 0.0 : k * std::pow(end, k - 1)) : std::pow(place, k);
        sum += shapes.value[static_cast<std::size_t>(a)] * nodal;
      }
      EXPECT_NEAR(sum, std::pow(x, k), 1e-14) << "x^" << k;
    }
}

}  // namespace
}  // namespace ixos
