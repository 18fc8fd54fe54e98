#include "material/components.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ixos {
namespace {

using Tensor = Small<double, 3>;

/// Components that are known to be zero are NaN: none may be read.
template <class Components>
Tensor sample(double phase) {
  Tensor m;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      m[i][j] = Components::has(i, j) ? std::sin(phase + 1.3 * static_cast<double>(i) + 0.7 * static_cast<double>(j))
                                      : std::numeric_limits<double>::quiet_NaN();
  return m;
}

template <class Components>
Tensor full(Tensor m) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (!Components::has(i, j)) m[i][j] = 0;
  return m;
}

Tensor transposed(const Tensor& m) {
  Tensor result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = m[j][i];
  return result;
}

template <class Components>
class ComponentsTest : public testing::Test {};
using Kinds = testing::Types<SolidComponents, PlaneComponents>;
TYPED_TEST_SUITE(ComponentsTest, Kinds);

TYPED_TEST(ComponentsTest, TheAlgebraIsThatOfFullTensors) {
  using Algebra = TensorAlgebra<TypeParam, double>;
  const Tensor a = sample<TypeParam>(0.3), b = sample<TypeParam>(1.9), a0 = full<TypeParam>(a), b0 = full<TypeParam>(b);
  const Tensor ab = product(a0, b0), abt = product(a0, transposed(b0));
  const Tensor found = Algebra::product(a, b), with_transposed = Algebra::product_transposed(a, b);
  const Tensor cofactors = Algebra::cofactors(a);
  const double det = determinant(a0);
  const Tensor inverse_transposed = transposed(inverse(a0, det));
  for (const auto& [i, j] : TypeParam::all) {
    EXPECT_NEAR(found[i][j], ab[i][j], 1e-15);
    EXPECT_NEAR(with_transposed[i][j], abt[i][j], 1e-15);
    EXPECT_NEAR(cofactors[i][j], det * inverse_transposed[i][j], 1e-15);
  }
  EXPECT_NEAR(Algebra::determinant(a, cofactors), det, 1e-15);
  EXPECT_NEAR(Algebra::trace(a), a0[0][0] + a0[1][1] + a0[2][2], 1e-15);
  EXPECT_NEAR(Algebra::contraction(a, b), contraction(a0, b0), 1e-15);
  EXPECT_EQ(Algebra::shifted(a, 2.0)[1][1], a[1][1] + 2);
}

TYPED_TEST(ComponentsTest, ListsNameTheComponents) {
  std::size_t count = 0, upper = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      count += TypeParam::has(i, j) ? 1 : 0;
      upper += TypeParam::has(i, j) && i <= j ? 1 : 0;
    }
  EXPECT_EQ(TypeParam::all.size(), count);
  EXPECT_EQ(TypeParam::symmetric.size(), upper);
  for (const auto& [i, j] : TypeParam::all) EXPECT_TRUE(TypeParam::has(i, j));
  for (const auto& [i, j] : TypeParam::symmetric) EXPECT_TRUE(TypeParam::has(i, j) && i <= j);
}

}  // namespace
}  // namespace ixos
