#include "histories/time_function.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/refusal.hpp"
#include "support/time_functions.hpp"

namespace ixos {
namespace {

using test::expect_contains;
using test::expect_continuous;
using test::expect_derivatives;
using test::expect_value;
using test::refusal;
using Function = std::shared_ptr<const TimeFunction>;

const std::vector<RampShape> shapes = {RampShape::Linear, RampShape::Cosine, RampShape::Quintic};

TEST(TimeFunctionSerialTest, ConstantHasNoDerivatives) {
  const Function f = constant(-2.5);
  for (double time : {-1e9, 0.0, 3.0}) expect_value(*f, time, -2.5, 0, 0);
  EXPECT_EQ(f->first_time(), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(f->last_time(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(f->ramp_end(), -std::numeric_limits<double>::infinity());
}

TEST(TimeFunctionSerialTest, Sine) {
  const Function f = sine(1, 2, 0.25, M_PI / 6);
  const double omega = M_PI / 2;
  expect_value(*f, 0, 2, omega * std::sqrt(3.0), -omega * omega);
  expect_value(*f, 1, 1 + std::sqrt(3.0), -omega, -omega * omega * std::sqrt(3.0));
  expect_value(*f, 4, 2, omega * std::sqrt(3.0), -omega * omega);
  expect_derivatives(*f, {-1.2, 0.1, 0.77, 5});
}

TEST(TimeFunctionSerialTest, ValueRamps) {
  for (RampShape shape : shapes) {
    const Function f = value_ramp(-3, 1, 4, shape);
    expect_value(*f, 0.999, 0, 0, 0);
    EXPECT_DOUBLE_EQ(f->at(3).value, -1.5);
    expect_value(*f, 5, -3, 0, 0);
    expect_value(*f, 50, -3, 0, 0);
    EXPECT_EQ(f->ramp_end(), 5.0);
    expect_derivatives(*f, {0.5, 1.3, 2, 3, 4.1, 4.9, 6});
  }
  expect_value(*value_ramp(8, 0, 4, RampShape::Linear), 1, 2, 2, 0);
  expect_value(*value_ramp(8, 0, 4, RampShape::Cosine), 2, 4, M_PI, 0);
  expect_value(*value_ramp(8, 0, 4, RampShape::Cosine), 0, 0, 0, M_PI * M_PI / 4);
  expect_value(*value_ramp(8, 0, 4, RampShape::Quintic), 1, 8 * 53.0 / 512, 8 * 135.0 / 512, 8 * 5.625 / 16);
}

TEST(TimeFunctionSerialTest, RateRamps) {
  for (RampShape shape : shapes) {
    const Function f = rate_ramp(-3, 1, 4, shape);
    expect_value(*f, 0.999, 0, 0, 0);
    EXPECT_DOUBLE_EQ(f->at(3).rate, -1.5);
    expect_value(*f, 5, -6, -3, 0);
    expect_value(*f, 7, -12, -3, 0);
    EXPECT_EQ(f->ramp_end(), 5.0);
    expect_derivatives(*f, {0.5, 1.3, 2, 3, 4.1, 4.9, 6});
  }
  expect_value(*rate_ramp(8, 0, 4, RampShape::Linear), 1, 1, 2, 2);
  expect_value(*rate_ramp(8, 0, 4, RampShape::Quintic), 2, 8 * 4 * 5.0 / 64, 4, 8 * 1.875 / 4);
}

TEST(TimeFunctionSerialTest, CosineRateRampIsTheDocumentedFormula) {
  const double V = 1, t_r = 55;
  const Function f = rate_ramp(V, 0, t_r, RampShape::Cosine);
  EXPECT_NEAR(f->at(20).value, V * (10 - t_r / (2 * M_PI) * std::sin(M_PI * 20 / t_r)), 1e-13);
  EXPECT_NEAR(f->at(20).rate, V * (1 - std::cos(M_PI * 20 / t_r)) / 2, 1e-15);
  EXPECT_NEAR(f->at(20).acceleration, V * M_PI / (2 * t_r) * std::sin(M_PI * 20 / t_r), 1e-15);
  expect_value(*f, 55, V * t_r / 2, V, 0);
  expect_value(*f, 100, V * (100 - t_r / 2), V, 0);
}

TEST(TimeFunctionSerialTest, RampsAreAsSmoothAsTheirShape) {
  for (double time : {1.0, 5.0}) {
    expect_continuous(*value_ramp(2, 1, 4, RampShape::Cosine), time, false);
    expect_continuous(*value_ramp(2, 1, 4, RampShape::Quintic), time, true);
    expect_continuous(*rate_ramp(2, 1, 4, RampShape::Linear), time, false);
    expect_continuous(*rate_ramp(2, 1, 4, RampShape::Cosine), time, true);
    expect_continuous(*rate_ramp(2, 1, 4, RampShape::Quintic), time, true);
  }
}

TEST(TimeFunctionSerialTest, RampsOfNoLengthJump) {
  for (RampShape shape : shapes) {
    const Function value = value_ramp(2, 1, 0, shape);
    expect_value(*value, 0.999, 0, 0, 0);
    expect_value(*value, 1, 2, 0, 0);
    const Function rate = rate_ramp(2, 1, 0, shape);
    expect_value(*rate, 0.999, 0, 0, 0);
    expect_value(*rate, 1, 0, 2, 0);
    expect_value(*rate, 3, 4, 2, 0);
  }
}

TEST(TimeFunctionSerialTest, RampsOfNegativeOrEndlessLengthAreRefused) {
  expect_contains(refusal([] { value_ramp(1, 0, -2, RampShape::Linear); }), "length -2");
  expect_contains(refusal([] { rate_ramp(1, 0, -2, RampShape::Linear); }), "length -2");
  expect_contains(refusal([] { value_ramp(1, 0, NAN, RampShape::Linear); }), "length nan");
  expect_contains(refusal([] { rate_ramp(1, 0, INFINITY, RampShape::Linear); }), "length inf");
}

TEST(TimeExpressionSerialTest, EvaluatesAllThree) {
  const Function f = expression("3*sin(2*_pi*t) + 1e-1*_e", "6*_pi*cos(2*_pi*t)", "-12*_pi^2*sin(2*_pi*t)");
  for (double t : {0.0, 0.1, 0.7, -2.0})
    expect_value(*f, t, 3 * std::sin(2 * M_PI * t) + 0.1 * M_E, 6 * M_PI * std::cos(2 * M_PI * t),
                 -12 * M_PI * M_PI * std::sin(2 * M_PI * t));
  const Function pieces = expression("t <= 1 ? t : (t >= 3 && t != 4 ? 7 : (t == 4 ? 8 : 1))", "", "");
  expect_value(*pieces, 0.5, 0.5, 0, 0);
  expect_value(*pieces, 2, 1, 0, 0);
  expect_value(*pieces, 3, 7, 0, 0);
  expect_value(*pieces, 4, 8, 0, 0);
}

TEST(TimeExpressionSerialTest, ArgumentAndValueMayHaveUnits) {
  // t in 1000 T0, values in 5 L0.
  const Function f = expression("t^3", "3*t^2", "6*t", {1000, 5});
  expect_value(*f, 2000, 5 * 8, 5 * 12 / 1e3, 5 * 12 / 1e6);
}

TEST(TimeExpressionSerialTest, MissingDerivativesAreZero) {
  expect_value(*expression("t^2", "", ""), 3, 9, 0, 0);
  expect_value(*expression("t^2", "2*t", ""), 3, 9, 6, 0);
}

TEST(TimeExpressionSerialTest, UndefinedValuesAreReturned) {
  const Function f = expression("1/t", "sqrt(t-1)", "ln(t)");
  EXPECT_TRUE(std::isinf(f->at(0).value));
  EXPECT_TRUE(std::isnan(f->at(0).rate));
  EXPECT_TRUE(std::isinf(f->at(0).acceleration));
  expect_value(*f, 1, 1, 0, 0);
}

TEST(FunctionOfTimeSerialTest, ItIsTheFunctionGiven) {
  const Function f = function_of_time([](double t) { return TimeValue{t * t * t, 3 * t * t, 6 * t}; });
  expect_value(*f, 2, 8, 12, 12);
  check_over(*f, -1, 1, true);
  const Function wrong = function_of_time([](double t) { return TimeValue{t, 2, 0}; });
  EXPECT_THROW(check_over(*wrong, 0, 1, true), InputError);
}

TEST(TimeExpressionSerialTest, BadExpressionsAreRefused) {
  const auto message = [](const std::string& value, const std::string& rate = "") {
    return refusal([&] { expression(value, rate, ""); });
  };
  expect_contains(message("2*x"), "the value \"2*x\"");
  expect_contains(message("2*x"), "\"x\" found at position 2");
  expect_contains(message("t", "2*(t+1"), "the rate \"2*(t+1\"");
  expect_contains(message("sin(t"), "parenthesis");
  expect_contains(message("\"abc\""), "At position");
  expect_contains(message("foo(t)"), "foo");
  expect_contains(message("2t"), "\"t\" found at position 1");
  expect_contains(message(""), "empty");
  expect_contains(message(" "), "empty");
  expect_contains(message("t = 3"), "assigns");
  expect_contains(message("=t"), "assigns");
  expect_contains(message("t, 2"), "commas");
}

}  // namespace
}  // namespace ixos
