// Gradients of quadratic simplices beside their corners against derivatives of the interpolated field.
#include "element/simplex_gradients.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "element/element_nodes.hpp"
#include "element/point_gradients.hpp"

namespace ixos {
namespace {

template <class Element>
class SimplexGradientsTest : public testing::Test {
 protected:
  using Nodes = test::ElementNodes<Element>;
  using Gradients = QuadraticSimplexGradients<Element>;
  static constexpr std::size_t D = Element::dimension;
  static constexpr std::size_t N = Element::nodes;
  using Nodal = Small<double, N, D>;

  static ShapeTable<Element> straight() { return ShapeTable<Element>(own_rule<Element>(false)); }

  static std::vector<Small<double, D>> random_stresses() {
    std::vector<Small<double, D>> result(D + 1);
    double phase = 0.4;
    for (auto& stress : result)
      for (auto& row : stress)
        for (double& entry : row) entry = std::sin(phase += 1.3);
    return result;
  }
};
using Elements = testing::Types<Tri6, Tet10>;
TYPED_TEST_SUITE(SimplexGradientsTest, Elements);

TYPED_TEST(SimplexGradientsTest, ServesTheRuleOfStraightCellsOnly) {
  using Points = typename TestFixture::Gradients::Points;
  EXPECT_TRUE(Points(this->straight()).serves);
  EXPECT_FALSE(Points(ShapeTable<TypeParam>(own_rule<TypeParam>(true))).serves);
  QuadratureRule<TypeParam::dimension> moved = own_rule<TypeParam>(false);
  moved.points.back()[0] += 1e-3;
  EXPECT_FALSE(Points(ShapeTable<TypeParam>(moved)).serves);
}

// u_i = sum of c_ijk x_j x_k: its gradient is known at every point, and its nodal values give it back.
TYPED_TEST(SimplexGradientsTest, AreThoseOfQuadraticFields) {
  constexpr std::size_t dimension = TypeParam::dimension, count = TypeParam::nodes;
  std::array<double, dimension> edges;
  edges.fill(1.0);
  const typename TestFixture::Nodal x = TestFixture::Nodes::block(edges);
  const auto c = [](std::size_t i, std::size_t j, std::size_t k) {
    return std::sin(1.0 + 1.9 * static_cast<double>(i) + 3.7 * static_cast<double>(j) + 5.3 * static_cast<double>(k));
  };
  typename TestFixture::Nodal u{};
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t i = 0; i < dimension; ++i)
      for (std::size_t j = 0; j < dimension; ++j)
        for (std::size_t k = 0; k < dimension; ++k) u[a][i] += c(i, j, k) * x[a][j] * x[a][k];

  const ShapeTable<TypeParam> table = this->straight();
  std::vector<Small<double, dimension>> gradients(table.size());
  TestFixture::Gradients::evaluate(typename TestFixture::Gradients::Points(table), u, gradients.data());
  for (std::size_t q = 0; q < table.size(); ++q)
    for (std::size_t i = 0; i < dimension; ++i)
      for (std::size_t d = 0; d < dimension; ++d) {
        double expected = 0;
        for (std::size_t k = 0; k < dimension; ++k) expected += (c(i, d, k) + c(i, k, d)) * table.point[q][k];
        EXPECT_NEAR(gradients[q][i][d], expected, 1e-14) << q << ' ' << i << ' ' << d;
      }
}

// f . w = sum over points of stress : grad w for every w; forces are added to what is there.
TYPED_TEST(SimplexGradientsTest, IntegrationIsTheTransposeOfEvaluation) {
  constexpr std::size_t dimension = TypeParam::dimension, count = TypeParam::nodes;
  const ShapeTable<TypeParam> table = this->straight();
  const typename TestFixture::Gradients::Points points(table);
  const auto stresses = this->random_stresses();
  typename TestFixture::Nodal f = TestFixture::Nodes::wave(1.0, 2.2);
  const typename TestFixture::Nodal before = f;
  TestFixture::Gradients::integrate(points, stresses.data(), f);
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t i = 0; i < dimension; ++i) {
      typename TestFixture::Nodal w{};
      w[a][i] = 1;
      std::vector<Small<double, dimension>> gradients(table.size());
      TestFixture::Gradients::evaluate(points, w, gradients.data());
      double work = 0;
      for (std::size_t q = 0; q < table.size(); ++q)
        for (std::size_t j = 0; j < dimension; ++j)
          for (std::size_t d = 0; d < dimension; ++d) work += stresses[q][j][d] * gradients[q][j][d];
      EXPECT_NEAR(f[a][i] - before[a][i], work, 1e-14) << a << ' ' << i;
    }
}

}  // namespace
}  // namespace ixos
