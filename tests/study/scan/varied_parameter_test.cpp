#include "study/scan/varied_parameter.hpp"

#include <gtest/gtest.h>

#include "support/refusal.hpp"

namespace ixos {
namespace {

using Labels = std::vector<std::string>;

Labels labels(const std::string& text) {
  Labels result;
  for (const AxisValue& value : read_varied(text).values) result.push_back(value.label);
  return result;
}

TEST(VariedParameterTest, RangesHaveEqualDistancesOrEqualRatios) {
  EXPECT_EQ(labels("A/B=0.1:0.5:5"), (Labels{"0.1", "0.2", "0.3", "0.4", "0.5"}));
  EXPECT_EQ(labels("A/B=-0.1:0.6:8")[1], "0");
  EXPECT_EQ(labels("A/B=3:1:3"), (Labels{"3", "2", "1"}));
  EXPECT_EQ(labels("A/B=0.01:100:5:log"), (Labels{"0.01", "0.1", "1", "10", "100"}));
  EXPECT_EQ(labels("A/B=1:2:3:log"), (Labels{"1", "1.41421", "2"}));
  EXPECT_EQ(labels("A/B=-4:-1:3:log"), (Labels{"-4", "-2", "-1"}));
}

TEST(VariedParameterTest, AnyValuesStandInBraces) {
  const VariedParameter varied = read_varied("Time Integrator/Type={Newmark, Average Vector Field}");
  EXPECT_EQ(varied.name, "Type");
  EXPECT_EQ(varied.path, "Time Integrator/Type");
  EXPECT_FALSE(varied.logarithmic);
  ASSERT_EQ(varied.values.size(), 2U);
  EXPECT_EQ(varied.values[1].settings, Assignments{"Time Integrator/Type=Average Vector Field"});
}

TEST(VariedParameterTest, ArraysStandInBracesOfTheirOwn) {
  const VariedParameter varied = read_varied("Mesh/Box/Divisions={{40, 2}, {80, 4}}");
  ASSERT_EQ(varied.values.size(), 2U);
  EXPECT_EQ(varied.values[1].label, "80x4");
  EXPECT_EQ(varied.values[1].settings, Assignments{"Mesh/Box/Divisions={80, 4}"});
}

TEST(VariedParameterTest, WhatIsNoRangeIsRefused) {
  const auto expect = [](const std::string& text, const std::string& words) {
    test::expect_contains(test::refusal([&] { read_varied(text); }), "--vary \"" + text + "\": " + words);
  };
  expect("A/B", "there is no \"=\"");
  expect("A/B=", "\"\" is no range");
  expect("A/B=1:2", "\"1:2\" is no range");
  expect("A/B=1:2:3:lin", "\"1:2:3:lin\" is no range");
  expect("A/B=1:x:3", "\"x\" is not a number");
  expect("A/B=nan:1:3", "\"nan\" is not a number");
  expect("A/B=1:2:1", "the number of values is \"1\"");
  expect("A/B=1:2:2.5", "the number of values is \"2.5\"");
  expect("A/B=1:2:20000", "the number of values is \"20000\"");
  expect("A/B=2:2:3", "both ends are equal");
  expect("A/B=0:2:3:log", "equal ratios need two ends of one sign");
  expect("A/B={1, , 2}", "a value is empty");
  expect("A/B={}", "a value is empty");
  expect("A/B={1, 2, 1}", "\"1\" is given twice");
}

}  // namespace
}  // namespace ixos
