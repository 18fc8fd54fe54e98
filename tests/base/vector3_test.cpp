#include "base/vector3.hpp"

#include <gtest/gtest.h>

namespace ixos {
namespace {

using Vector = std::array<double, 3>;

TEST(Vector3Test, ProductsOfTheAxesAndOfObliqueVectors) {
  const Vector x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, a{1, 2, 3}, b{4, -5, 6};
  EXPECT_EQ(cross(x, y), z);
  EXPECT_EQ(cross(y, z), x);
  EXPECT_EQ(cross(z, x), y);
  EXPECT_EQ(dot(a, b), 12);
  EXPECT_EQ(cross(a, b), (Vector{27, 6, -13}));
  EXPECT_EQ(dot(cross(a, b), a), 0);
}

}  // namespace
}  // namespace ixos
