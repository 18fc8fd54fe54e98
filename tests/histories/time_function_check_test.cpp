// check_over: are a history's derivatives its own, and is it defined throughout a run?
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "histories/time_function.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

using test::expect_contains;
using Function = std::shared_ptr<const TimeFunction>;

const std::vector<RampShape> shapes = {RampShape::Linear, RampShape::Cosine, RampShape::Quintic};

std::string refusal_over(const Function& function, double from, double to, bool derivatives) {
  return test::refusal([&] { check_over(*function, from, to, derivatives); });
}

TEST(TimeFunctionCheckSerialTest, GoodMotionsAreAccepted) {
  const std::vector<Function> functions = {
      constant(0), constant(-7), sine(3, 0.1, 0.5, 1), sine(1e4, 1, 0.5, 1),
      // As many cycles as there are samples of the value.
      sine(0, 2, 100, 0),
      // Under-resolved by the first quadrature.
      sine(0, 2, 2718.28, 0), value_ramp(2, 1.23, 4.56, RampShape::Cosine),
      value_ramp(2, 1.23, 4.56, RampShape::Quintic),
      // Most of the run at rest.
      value_ramp(1e-9, 1.23, 0.001, RampShape::Quintic), rate_ramp(2, 1.23, 4.56, RampShape::Linear),
      rate_ramp(2, 1.23, 4.56, RampShape::Cosine), rate_ramp(2, 1.23, 4.56, RampShape::Quintic),
      expression("t^3", "3*t^2", "6*t"), expression("exp(3*t)", "3*exp(3*t)", "9*exp(3*t)"),
      // Kinks of the rate, at 1, and a rate that steps up in pieces.
      expression("(t-1)*abs(t-1)/2", "abs(t-1)", "sign(t-1)"),
      expression("abs(sin(40*t))*sin(40*t)", "80*abs(sin(40*t))*cos(40*t)",
                 "3200*sign(sin(40*t))*(cos(40*t)^2-sin(40*t)^2)")};
  for (std::size_t i = 0; i < functions.size(); ++i)
    for (double from : {0.0, -3.3}) EXPECT_EQ(refusal_over(functions[i], from, 10, true), "") << "function " << i;
  EXPECT_EQ(refusal_over(sine(0, 1, 1, 0), 2, 2, true), "");
}

TEST(TimeFunctionCheckSerialTest, WrongDerivativesAreFound) {
  const std::string rate = refusal_over(expression("t^2", "3*t", "3"), 0, 10, true);
  expect_contains(rate, "the rate is not the derivative of the value: from t = 0 to t = 0.102 the value changes by");
  const std::string acceleration = refusal_over(expression("t^2", "2*t", "2.001"), 0, 10, true);
  expect_contains(acceleration, "the acceleration is not the derivative of the rate");
  expect_contains(refusal_over(expression("t", "", ""), 0, 1, true), "changes by 0.01");
  // No change of the value over any of 50 equal parts.
  expect_contains(refusal_over(expression("sin(2*_pi*t)", "cos(2*_pi*t)", "-2*_pi*sin(2*_pi*t)"), 0, 50, true),
                  "the rate is not");
  // A small motion about a large value.
  expect_contains(refusal_over(expression("1e4+sin(t)", "1.001*cos(t)", "-1.001*sin(t)"), 0, 5, true), "the rate");
  // The same functions as loads.
  EXPECT_EQ(refusal_over(expression("t^2", "3*t", "3"), 0, 10, false), "");
}

TEST(TimeFunctionCheckSerialTest, JumpsOfValueAndRateAreNoMotions) {
  for (RampShape shape : shapes) {
    EXPECT_EQ(refusal_over(value_ramp(2, 1, 0, shape), 0, 10, true),
              "a ramp of Length 0 cannot drive a motion of a dynamic scheme: its value jumps at the time 1, where its "
              "rate is not defined; choose a Length above 0, or the scheme Static");
    expect_contains(refusal_over(rate_ramp(2, 1, 0, shape), 0, 10, true),
                    "its rate jumps at the time 1, where its acceleration is not defined; choose a Length above 0");
    EXPECT_EQ(refusal_over(value_ramp(2, 1, 0, shape), 0, 10, false), "");
    // A run that begins with the jump, or ends before it, sees none.
    for (const Function& ramp : {value_ramp(2, 1, 0, shape), rate_ramp(2, 1, 0, shape), value_ramp(0, 1, 0, shape)}) {
      EXPECT_EQ(refusal_over(ramp, 1, 10, true), "");
      EXPECT_EQ(refusal_over(ramp, 0, 0.9, true), "");
    }
  }
  const Function line = value_ramp(2, 1, 3, RampShape::Linear);
  EXPECT_EQ(refusal_over(line, 0, 10, true),
            "Shape Linear cannot drive a motion of a dynamic scheme: its rate jumps at the times 1, 4, where its "
            "acceleration is not defined; choose Shape Cosine or Quintic, or the scheme Static");
  expect_contains(refusal_over(line, 1, 4, true), "jumps at the time 4,");
  EXPECT_EQ(refusal_over(line, 1, 3.9, true), "");
  expect_contains(refusal_over(expression("abs(t-1)", "sign(t-1)", "0"), 0, 10, true), "the acceleration is not");
}

TEST(TimeFunctionCheckSerialTest, StaticMotionsMayJump) {
  const auto refusal_of_static = [](const Function& function) {
    return test::refusal([&] { check_static_over(*function, 0, 10); });
  };
  for (RampShape shape : shapes)
    for (double length : {0.0, 3.0}) {
      EXPECT_EQ(refusal_of_static(value_ramp(2, 1, length, shape)), "");
      EXPECT_EQ(refusal_of_static(rate_ramp(2, 1, length, shape)), "");
    }
  EXPECT_EQ(refusal_of_static(expression("abs(t-1)", "sign(t-1)", "0")), "");
  EXPECT_EQ(refusal_of_static(expression("t^2", "2*t", "3")), "") << "the acceleration has no meaning";
  expect_contains(refusal_of_static(expression("t^2", "3*t", "3")), "the rate is not the derivative of the value");
  expect_contains(refusal_of_static(expression("1/(t-1)", "-1/(t-1)^2", "2/(t-1)^3")), "not finite at t = 1");
}

TEST(TimeFunctionCheckSerialTest, SingularitiesAreFound) {
  const Function pole = expression("1/(t-1)", "-1/(t-1)^2", "2/(t-1)^3");
  for (bool derivatives : {false, true}) {
    expect_contains(refusal_over(pole, 0, 2, derivatives), "the value is not finite at t = 1");
    expect_contains(refusal_over(pole, 0, 3, derivatives), "the value is not finite at t = 1");
    expect_contains(refusal_over(pole, 0, 1, derivatives), "the value is not finite at t = 1");
    EXPECT_EQ(refusal_over(pole, 1.5, 3, derivatives), "");
  }
  expect_contains(refusal_over(expression("-1/(t-0.9)", "", ""), 0.17, 2, false), "not finite at t = 0.9");
  expect_contains(refusal_over(expression("sqrt(2-t)", "", ""), 0, 3, false), "the value is not finite at t = 2.00");
  // Between the sampled times: no pole is hit, but no integral comes out either.
  expect_contains(refusal_over(expression("1/(t-_pi)^2", "-2/(t-_pi)^3", "6/(t-_pi)^4"), 0, 10, true), "the rate");
  expect_contains(refusal_over(expression("t*sqrt(t)", "1.5*sqrt(t)", "0.75/sqrt(t)"), 0, 3, true),
                  "the acceleration is not finite at t = 0");
  EXPECT_EQ(refusal_over(expression("sqrt(t)", "1/t", ""), 0, 3, false), "");
}

TEST(TimeFunctionCheckSerialTest, TablesThatDoNotCoverTheRunAreRefused) {
  const Function f = interpolated({0, 1, 3}, {1, 2, 5});
  EXPECT_EQ(refusal_over(f, 0, 3, true), "");
  expect_contains(refusal_over(f, 0, 4, false), "the value is not finite at t = 3.00");
  expect_contains(refusal_over(f, -1, 3, true), "the value is not finite at t = -1");
}

}  // namespace
}  // namespace ixos
