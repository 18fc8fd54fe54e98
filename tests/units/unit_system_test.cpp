#include "units/unit_system.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "support/refusal.hpp"
#include "units/dimension.hpp"
#include "units/documented_unit.hpp"
#include "units/result_units.hpp"

namespace ixos {
namespace {

const UnitSystem nano("1 nm", "2 GPa", "1 ns");

TEST(UnitSystemTest, ScalesAreExact) {
  EXPECT_EQ(nano.si("L0"), 1e-9);
  EXPECT_EQ(nano.si("E0 T0^2/L0^2"), 2e9);
  EXPECT_EQ(nano.si("E0 L0^2"), 2e-9);
  EXPECT_EQ(nano.si("-"), 1);
  EXPECT_EQ(in_unit(parse_quantity("1000 kg/m^3"), nano.unit("E0 T0^2/L0^2")), 5e-7);
  EXPECT_EQ(in_unit(parse_quantity("9.81 m/s^2"), nano.unit("L0/T0^2")), 9.81e-9);
  EXPECT_EQ(in_unit(parse_quantity("45 deg"), nano.unit("degrees")), 45);
  const UnitSystem odd("3 um", "0.7 MPa", "7 us");
  EXPECT_EQ(in_unit(parse_quantity("1 nm"), odd.unit("L0")), 1.0 / 3000);
  EXPECT_EQ(in_unit(parse_quantity("1 MPa"), odd.unit("E0")), 10.0 / 7);
}

TEST(UnitSystemTest, ScalesThatAreNoneAreRefused) {
  const auto refused = [](const char* length, const std::string& words) {
    test::expect_contains(test::refusal([&] { UnitSystem(length, "2 GPa", "1 ns"); }), words);
  };
  refused("nanometre", "Units/Length: \"nanometre\": a number is missing");
  refused("1", "Units/Length: \"1\" is a pure number; a length is needed, as in \"10 nm\"");
  refused("1 ns", "Units/Length: \"1 ns\" is a time");
  refused("0 nm", "Units/Length: \"0 nm\" must be greater than 0");
  refused("-1 nm", "must be greater than 0");
  refused("1e-400 m", "Units/Length: \"1e-400 m\": it is beyond the range of numbers");
}

TEST(UnitSystemTest, ValuesAreShownWithPrefixes) {
  EXPECT_EQ(nano.text(10, "L0"), "10 nm");
  EXPECT_EQ(nano.text(1, "E0"), "2 GPa");
  EXPECT_EQ(nano.text(0.0155, "E0 L0", "J/m^2"), "31 mJ/m^2");
  EXPECT_EQ(nano.text(5e-7, "E0 T0^2/L0^2"), "1000 kg/m^3");
  EXPECT_EQ(nano.text(0, "L0"), "0 m");
  EXPECT_EQ(si_text(-9.81, "m/s^2"), "-9.81 m/s^2");
  EXPECT_EQ(si_text(1e-19, "J"), "1e-19 J");
}

TEST(DimensionTest, NamesAreThoseOfTheQuantities) {
  EXPECT_EQ(dimension_name({{-3, 1, 0}}).name, "a density");
  EXPECT_EQ(dimension_name({{0, 2, 0, 1}}).name, "a quantity in kg^2 A");
  EXPECT_TRUE((Dimension{{1}} * power(Dimension{{1}}, -1)).is_number());
}

TEST(DocumentedUnitTest, BracketsAreRead) {
  const auto one = documented_units("A length [L0]. It is [not] this.");
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].expression, "L0");
  EXPECT_EQ(one[0].use, "");
  const auto two = documented_units("Load [E0 for a Traction, L0/T0^2 for Gravity].");
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(two[0].use, "Traction");
  EXPECT_EQ(two[1].expression, "L0/T0^2");
  EXPECT_EQ(two[1].use, "Gravity");
  for (const char* pure : {"A ratio [-].", "A number.", "", "]["}) EXPECT_TRUE(documented_units(pure).empty()) << pure;
}

TEST(ResultUnitsTest, SymbolsAndSIUnitsAgree) {
  for (int dimension : {2, 3})
    for (const ResultUnit& unit : result_units(nano, dimension)) {
      EXPECT_EQ(nano.unit(unit.expression).dimension.exponents, parse_unit(unit.si, si_unit).dimension.exponents)
          << unit.quantity;
      EXPECT_EQ(unit.scale, nano.si(unit.expression)) << unit.quantity;
    }
}

TEST(ResultUnitsTest, ScalesOfManyDigitsAreSound) {
  const UnitSystem odd("7.254709287789268 nm", "2.345678 GPa", "1.234567890123456789 ns");
  const std::vector<ResultUnit> units = result_units(odd, 3);
  // E0 L0^3 T0, computed with fractions.Fraction of Python.
  EXPECT_EQ(units[8].quantity, "angular_momentum");
  EXPECT_EQ(units[8].scale, 1.105715541245733e-24);
  EXPECT_EQ(units.back().quantity, "moment");
  EXPECT_EQ(units.back().scale, units[6].scale) << "the number of an energy";
}

TEST(ResultUnitsTest, UnitsBeyondTheRangeOfNumbersNameTheScales) {
  const UnitSystem tiny("1e-200 m", "2 GPa", "1 ns");
  test::expect_contains(
      test::refusal([&] { result_units(tiny, 3); }),
      "Units: Length \"1e-200 m\", Energy Density \"2 GPa\" and Time \"1 ns\" make the unit E0 L0^2: it "
      "is beyond the range of numbers");
}

}  // namespace
}  // namespace ixos
