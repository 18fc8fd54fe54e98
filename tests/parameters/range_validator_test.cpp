#include "parameters/range_validator.hpp"

#include <gtest/gtest.h>

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterEntry.hpp>
#include <Teuchos_Tuple.hpp>
#include <cmath>
#include <limits>
#include <sstream>

#include "base/error.hpp"

namespace ixos {
namespace {

using End = RangeValidator::End;
constexpr double infinity = RangeValidator::infinity;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// What the validator says about a value; empty where it accepts it.
template <class T>
std::string refusal(const RangeValidator& range, const T& value) {
  const Teuchos::ParameterEntry entry(value);
  try {
    range.validate(entry, "Time Step", "Time Integrator");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(RangeValidatorTest, ClosedEndsBelongToTheInterval) {
  const auto range = between(-1.0, 0.5);
  EXPECT_TRUE(range->contains(-1.0));
  EXPECT_TRUE(range->contains(0.5));
  EXPECT_TRUE(range->contains(0.0));
  EXPECT_FALSE(range->contains(std::nextafter(-1.0, -2.0)));
  EXPECT_FALSE(range->contains(std::nextafter(0.5, 1.0)));
  EXPECT_TRUE(at_least(2.0)->contains(2.0));
  EXPECT_FALSE(at_least(2.0)->contains(std::nextafter(2.0, 0.0)));
  EXPECT_TRUE(at_least_and_less_than(0.0, 0.5)->contains(0.0));
}

TEST(RangeValidatorTest, OpenEndsDoNotBelongToTheInterval) {
  const auto range = greater_and_less_than(-1.0, 0.5);
  EXPECT_FALSE(range->contains(-1.0));
  EXPECT_FALSE(range->contains(0.5));
  EXPECT_TRUE(range->contains(std::nextafter(-1.0, 0.0)));
  EXPECT_TRUE(range->contains(std::nextafter(0.5, 0.0)));
  EXPECT_FALSE(greater_than(2.0)->contains(2.0));
  EXPECT_TRUE(greater_than(2.0)->contains(std::nextafter(2.0, 3.0)));
  EXPECT_FALSE(at_least_and_less_than(0.0, 0.5)->contains(0.5));
}

TEST(RangeValidatorTest, WhatIsNotFiniteIsRefusedEverywhere) {
  for (const auto& range : {any_number(), greater_than(0.0), at_least(-5.0), between(-1.0, 1.0)})
    for (double value : {not_a_number, infinity, -infinity}) EXPECT_FALSE(range->contains(value)) << range->words();
  for (double value : {0.0, -1e300, 1e300}) EXPECT_TRUE(any_number()->contains(value));
}

TEST(RangeValidatorTest, DescribesTheIntervalInWords) {
  EXPECT_EQ(any_number()->words(), "finite");
  EXPECT_EQ(greater_than(0.0)->words(), "greater than 0");
  EXPECT_EQ(at_least(0.25)->words(), "at least 0.25");
  EXPECT_EQ(at_least_and_less_than(0.0, 0.5)->words(), "at least 0 and less than 0.5");
  EXPECT_EQ(greater_and_less_than(-1.0, 0.5)->words(), "greater than -1 and less than 0.5");
  EXPECT_EQ(between(0.0, 1.0)->words(), "at least 0 and at most 1");
  EXPECT_EQ(RangeValidator(-infinity, End::Closed, 2.0, End::Open).words(), "less than 2");
  EXPECT_EQ(RangeValidator(-infinity, End::Closed, 2.0, End::Closed).words(), "at most 2");
}

TEST(RangeValidatorTest, ErrorGivesTheValueAndTheInterval) {
  EXPECT_EQ(refusal(*greater_than(0.0), -0.5), "-0.5 is not allowed: it must be greater than 0");
  EXPECT_EQ(refusal(*at_least(1.0), 0), "0 is not allowed: it must be at least 1");
  EXPECT_EQ(refusal(*any_number(), not_a_number), "nan is not allowed: it must be finite");
  EXPECT_EQ(refusal(*any_number(), infinity), "inf is not allowed: it must be finite");
}

TEST(RangeValidatorTest, IntegersAndDoublesInTheIntervalAreAccepted) {
  EXPECT_EQ(refusal(*at_least(1.0), 1), "");
  EXPECT_EQ(refusal(*at_least(1.0), 1.5), "");
}

TEST(RangeValidatorTest, EveryElementOfAnArrayIsChecked) {
  const auto range = between(0.0, 1.0);
  EXPECT_EQ(refusal(*range, Teuchos::Array<double>(Teuchos::tuple(0.0, 0.5, 1.0))), "");
  EXPECT_EQ(refusal(*range, Teuchos::Array<int>(Teuchos::tuple(0, 1))), "");
  const std::string allowed = " is not allowed: it must be at least 0 and at most 1";
  EXPECT_EQ(refusal(*range, Teuchos::Array<double>(Teuchos::tuple(0.0, 0.5, 1.5))), "1.5" + allowed);
  EXPECT_EQ(refusal(*range, Teuchos::Array<double>(Teuchos::tuple(not_a_number, 0.5))), "nan" + allowed);
  EXPECT_EQ(refusal(*range, Teuchos::Array<int>(Teuchos::tuple(0, 3, 1))), "3" + allowed);
}

TEST(RangeValidatorTest, DocumentationGivesTheInterval) {
  std::ostringstream text;
  greater_than(0.0)->printDoc("The step. ", text);
  EXPECT_EQ(text.str(), "The step. Allowed: greater than 0\n");
}

}  // namespace
}  // namespace ixos
