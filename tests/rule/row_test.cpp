#include "rule/row.hpp"

#include <gtest/gtest.h>

#include "rule/row_on_states.hpp"

namespace ixos {
namespace {

TEST(RowSerialTest, AlgebraCombinesCoefficients) {
  const Row row = 2.0 * (unknown_displacement() - displacement(0)) - velocity(1) / 4.0 + acceleration(0);
  EXPECT_EQ(row.unknown, 2);
  ASSERT_EQ(row.known.size(), 2U);
  EXPECT_EQ(row.known[0].u, -2);
  EXPECT_EQ(row.known[0].a, 1);
  EXPECT_EQ(row.known[1].v, -0.25);
}

TEST(RowSerialTest, MonomialsAreSampledAtTheStates) {
  const Row row = unknown_displacement() - displacement(0) - 0.5 * velocity(0) - 0.25 * acceleration(0);
  // u = t^2 from t = 0 to 0.5: 0.25 - 0 - 0 - 0.5.
  EXPECT_DOUBLE_EQ(row.on_monomial(2, 0.5, {0.0}), -0.25);
  EXPECT_DOUBLE_EQ(row.on_monomial(1, 0.5, {0.0}), 0.0);
  EXPECT_DOUBLE_EQ(row.on_monomial(0, 0.5, {0.0}), 0.0);
}

TEST(RowSerialTest, EvaluationOnStatesIsTheLinearForm) {
  const double first[] = {1, 2, 3}, second[] = {4, 5, 6}, u = 7;
  const std::vector<KnownState> states{{first, first + 1, first + 2}, {second, second + 1, second + 2}};
  const double dt = 0.1;
  const Row row = 3.0 * unknown_displacement() - displacement(0) - 2.0 * displacement(1) + velocity(0) -
                  0.5 * velocity(1) + acceleration(1);
  std::vector<double> known(1), result(1);
  evaluate_known(row, states, dt, known);
  evaluate(row.unknown, &u, states[0].u, known, result);
  EXPECT_NEAR(result[0], 3 * 7.0 - 1 - 2 * 4 + dt * 2 - 0.5 * dt * 5 + dt * dt * 6, 1e-14);
}

TEST(RowSerialTest, SmallIncrementsKeepTheirDigits) {
  // u differs from u_0 in the last digits only; the difference must not be lost against u.
  const double start = 1e6, zero = 0, u = 1e6 + 0x1p-30;
  const std::vector<KnownState> states{{&start, &zero, &zero}};
  const Row row = 4.0 * (unknown_displacement() - displacement(0));
  std::vector<double> known(1), result(1);
  evaluate_known(row, states, 1e-3, known);
  evaluate(row.unknown, &u, states[0].u, known, result);
  EXPECT_EQ(result[0], 4 * 0x1p-30);
}

}  // namespace
}  // namespace ixos
