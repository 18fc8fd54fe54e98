#include "material/cube_root.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ixos {
namespace {

TEST(CubeRootTest, AllDigitsNearOneAndFarFromIt) {
  for (double x : {1e-300, 1e-12, 1e-5, 0.003, 0.1, 0.2499, 0.2501, 0.9, 7.0, 1e6, -1e-12, -0.1, -0.2499, -0.9}) {
    const long double exact = x < -0.5 || x > 0.5 || std::abs(x) > 1e-3
                                  ? std::cbrt(1 + static_cast<long double>(x)) - 1
                                  : x * (1 / 3.0L - x * (1 / 9.0L - x * (5 / 81.0L - x * 10 / 243.0L)));
    const auto expected = static_cast<double>(exact);
    EXPECT_NEAR(cube_root_minus_one(x) / expected, 1, 1e-15) << x;
    EXPECT_NEAR(least(cube_root_minus_one(Pack(x))) / expected, 1, 1e-15) << x;
  }
  EXPECT_EQ(cube_root_minus_one(0.0), 0);
  EXPECT_EQ(least(cube_root_minus_one(Pack(0.0))), 0);
}

}  // namespace
}  // namespace ixos
