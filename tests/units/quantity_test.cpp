#include "units/quantity.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

double in(const std::string& text, const std::string& unit) {
  return in_unit(parse_quantity(text), parse_unit(unit, si_unit));
}

TEST(QuantityTest, NumbersAreExactAndRoundedOnce) {
  EXPECT_EQ(in("10 nm", "nm"), 10);
  EXPECT_EQ(in("0.1 nm", "nm"), 0.1);
  EXPECT_EQ(in("7.254709287789268 nm", "nm"), 7.254709287789268);
  EXPECT_EQ(in("-2.5e-3MPa", "kPa"), -2.5);
  EXPECT_EQ(in("+.5 h", "s"), 1800);
  EXPECT_EQ(in("2 eV", "J"), 3.204353268e-19);
  EXPECT_EQ(in("2e3 eV", "J"), 3.204353268e-16);
  EXPECT_EQ(in("1E3 m", "km"), 1);
  EXPECT_EQ(in("0 nm", "m"), 0);
  EXPECT_EQ(in("9.81 m s\u207b\u00b2", "m/s^2"), 9.81);
}

TEST(QuantityTest, PlainNumbersHaveNoUnit) {
  EXPECT_FALSE(parse_quantity("5").has_unit);
  EXPECT_FALSE(parse_quantity(" 5e-3 ").has_unit);
  EXPECT_TRUE(parse_quantity("5 m").has_unit);
  for (const char* text : {"5", " -5", "+.5", "5x"}) EXPECT_TRUE(begins_with_number(text)) << text;
  for (const char* text : {"", "-", ".", "nm", "+-1", "nan", "inf", "{1}"})
    EXPECT_FALSE(begins_with_number(text)) << text;
}

TEST(QuantityTest, ListsHaveUnitsOfElementsOrOneUnit) {
  const auto values = [](const std::string& text) {
    std::vector<double> result;
    for (const Quantity& q : parse_quantities(text)) result.push_back(in_unit(q, q.has_unit ? *si_unit("nm") : Unit{}));
    return result;
  };
  EXPECT_EQ(values("{1 nm, 2 um}"), (std::vector<double>{1, 2000}));
  EXPECT_EQ(values("{1, 2} nm"), (std::vector<double>{1, 2}));
  EXPECT_EQ(values("{0, 7 nm}"), (std::vector<double>{0, 7})) << "zero needs no unit";
  EXPECT_TRUE(values("{}").empty());
  for (const char* wrong : {"{5, 7 nm}", "{5 nm, 7} nm", "{5 nm", "{5,} nm", "{a} nm"})
    EXPECT_THROW(parse_quantities(wrong), InputError) << wrong;
}

TEST(QuantityTest, MessagesQuoteTheText) {
  const auto refused = [](const std::string& text, const std::string& words) {
    test::expect_contains(test::refusal([&] { parse_quantity(text); }), words);
  };
  refused("nm", "\"nm\": a number is missing; write it before the unit, as in 1 nm");
  refused("5 nmm", "\"5 nmm\": unit \"nmm\" does not exist; did you mean \"mm\"?");
  refused("1.00000000000000000001 m", "more than 19 significant digits");
  refused("1e1000 m", "it is beyond the range of numbers");
  refused("1,5 m", "a unit is missing");
  test::expect_contains(test::refusal([] { in("1e300 Tm", "fm"); }), "\"1e300 Tm\": it is beyond the range of numbers");
  test::expect_contains(test::refusal([] { in("1e999999999 nm", "nm"); }), "\"1e999999999 nm\": it is beyond");
}

}  // namespace
}  // namespace ixos
