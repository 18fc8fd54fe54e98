// Sides of higher order as patches.
#include "geometry/lagrange_patches.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>

#include "fem/contact_elements.hpp"
#include "fem/contact_hexahedra.hpp"

namespace ixos {
namespace {

/// The weights are the shape functions of the element's side.
template <class Element, std::size_t D>
void expect_shape_functions() {
  std::vector<int> nodes(Element::nodes);
  std::iota(nodes.begin(), nodes.end(), 0);
  const SurfacePatch<D> patch = lagrange_patch<D>(nodes);
  for (const double a : {-1.0, -0.3, 0.8}) {
    std::array<double, D - 1> xi;
    xi.fill(a);
    if constexpr (D == 3) xi[1] = 0.4 * a + 0.1;
    std::array<double, Element::nodes> value;
    std::array<std::array<double, D - 1>, Element::nodes> gradient;
    Element::evaluate(xi, value, gradient);
    PatchParameters<D> t;
    for (std::size_t k = 0; k + 1 < D; ++k) t[k] = (1 + xi[k]) / 2;
    const auto shape = patch.shape(t);
    for (std::size_t n = 0; n < value.size(); ++n) {
      EXPECT_NEAR(shape.value[n], value[n], 1e-12);  // powers of order 4 have coefficients up to 100
      for (std::size_t k = 0; k + 1 < D; ++k) EXPECT_NEAR(shape.slopes[k][n], 2 * gradient[n][k], 1e-11);
    }
  }
}

TEST(LagrangePatchesTest, WeightsAreTheShapeFunctionsOfTheSide) {
  expect_shape_functions<LagrangeEdge<2>, 2>();
  expect_shape_functions<LagrangeEdge<3>, 2>();
  expect_shape_functions<LagrangeEdge<4>, 2>();
  expect_shape_functions<LagrangeFace<2>, 3>();
  expect_shape_functions<LagrangeFace<3>, 3>();
  expect_shape_functions<LagrangeFace<4>, 3>();
  EXPECT_THROW(lagrange_patch<2>({0, 1}), std::logic_error);
  EXPECT_THROW(lagrange_patch<3>({0, 1, 2, 3}), std::logic_error);
}

}  // namespace
}  // namespace ixos
