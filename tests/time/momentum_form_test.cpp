#include "time/momentum_form.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace ixos {
namespace {

/// A step of length 1 with u - u_n = (v_n + v)/2.
constexpr double u_n = 0.3, v_n = -0.7, a_n = 1.1, v = 1.9, u = u_n + (v_n + v) / 2;

double value(const Row& row) {
  double sum = row.unknown * u;
  for (const Row::Known& known : row.known) sum += known.u * u_n + known.v * v_n + known.a * a_n;
  EXPECT_LE(row.known.size(), 1U) << "the start of the step is the only known state";
  return sum;
}

TEST(MomentumFormSerialTest, RowsAreTheBalanceOfMomentumOverTheStep) {
  const Stage stage = momentum_form_stage();
  EXPECT_EQ(stage.end, 1);
  EXPECT_NEAR(value(stage.velocity), v, 1e-14);
  EXPECT_NEAR(value(stage.inertia), v - v_n, 1e-14) << "the change of momentum over M";
  EXPECT_NEAR(value(stage.damping), u - u_n, 1e-14) << "the impulse of the damping over C";
  // The mean of the accelerations at both ends is the change of velocity.
  EXPECT_NEAR((a_n + value(stage.acceleration)) / 2, v - v_n, 1e-14);
}

TEST(MomentumFormSerialTest, TheCallerFillsInForcesAndLoads) {
  Stage stage = momentum_form_stage();
  EXPECT_THROW(check(momentum_form_table("Half", stage)), std::invalid_argument);
  stage.elastic = stage.interaction = end_rule();
  stage.load = {{0.5, 1.0}};
  const Table table = momentum_form_table("Whole", stage);
  EXPECT_NO_THROW(check(table));
  EXPECT_EQ(table.name, "Whole");
  EXPECT_EQ(table.stages.size(), 1U);
  EXPECT_EQ(table.work.form, WorkSum::Form::Increment);
  EXPECT_EQ(table.closing, Closing::Collocate);
  EXPECT_FALSE(has_exact_rates(table)) << "driven degrees of freedom keep u - u_n = dt (v_n + v)/2";
}

}  // namespace
}  // namespace ixos
