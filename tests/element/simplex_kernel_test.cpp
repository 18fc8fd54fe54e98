// Forces and tangents of triangles, tetrahedra, prisms and pyramids, curved, against automatic differentiation.
#include <gtest/gtest.h>

#include "element/elastic_kernel_body.hpp"
#include "material/neo_hooke.hpp"

namespace ixos {
namespace {

using test::Body;

template <class B>
class SimplexKernelTest : public testing::Test {};
using Bodies = testing::Types<Body<Tri3, NeoHooke>, Body<Tri6, NeoHooke>, Body<Tri7, NeoHooke>, Body<Tet4, NeoHooke>,
                              Body<Tet10, NeoHooke>, Body<Tet15, NeoHooke>, Body<Prism6, NeoHooke>,
                              Body<Prism18, NeoHooke>, Body<Pyr5, NeoHooke>, Body<Pyr14, NeoHooke>>;
TYPED_TEST_SUITE(SimplexKernelTest, Bodies);

TYPED_TEST(SimplexKernelTest, ForceIsTheGradientOfTheEnergy) { test::expect_force_is_gradient<TypeParam>(); }

TYPED_TEST(SimplexKernelTest, TangentIsTheSymmetricDerivativeOfTheForce) {
  test::expect_tangent_is_derivative<TypeParam>();
}

TYPED_TEST(SimplexKernelTest, DiscreteGradientDoesTheWorkOfTheEnergyAndHasItsTangent) {
  test::expect_discrete_gradient<TypeParam>();
}

}  // namespace
}  // namespace ixos
