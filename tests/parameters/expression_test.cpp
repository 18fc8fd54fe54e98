#include "parameters/expression.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/refusal.hpp"

namespace ixos {
namespace {

TEST(ExpressionTest, VariablesHaveTheirOrder) {
  const Expression formula("factor", "x - 2*y + (z > 1 ? 10 : 0)", {"x", "y", "z"});
  EXPECT_EQ(formula.at({3, 1, 0}), 1);
  EXPECT_EQ(formula.at({0, 0, 2}), 10);
  EXPECT_EQ(Expression("factor", "sin(_pi/2)", {"x"}).at({0}), 1);
  EXPECT_TRUE(std::isnan(Expression("factor", "sqrt(x)", {"x"}).at({-1})));
}

TEST(ExpressionTest, MalformedOnesAreRefused) {
  const auto refusal = [](const char* text) {
    return test::refusal([&] { const Expression formula("factor", text, {"x", "y"}); });
  };
  test::expect_contains(refusal("x + t"), "the factor \"x + t\" is not an expression in x, y: ");
  test::expect_contains(refusal("sin(x"), "is not an expression");
  test::expect_contains(refusal("x = 2"), "it assigns with =");
  test::expect_contains(refusal("x, y"), "several expressions");
  EXPECT_EQ(refusal("x <= y"), "");
}

}  // namespace
}  // namespace ixos
