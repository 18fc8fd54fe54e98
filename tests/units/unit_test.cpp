#include "units/unit.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

Unit si(const std::string& text) { return parse_unit(ascii_units(text), si_unit); }

void expect_equal(const std::string& text, double factor, const Dimension& dimension) {
  EXPECT_EQ(si(text).factor.nearest(), factor) << text;
  EXPECT_EQ(si(text).dimension.exponents, dimension.exponents) << text;
}

TEST(UnitTest, ExpressionsAreRead) {
  const Dimension stress{{-1, 1, -2}}, surface_energy{{0, 1, -2}}, density{{-3, 1}}, rate{{0, 0, -1}};
  expect_equal("MPa", 1e6, stress);
  expect_equal("N/mm^2", 1e6, stress);
  expect_equal("kg/(m s^2)", 1, stress);
  expect_equal("kg m^-1 s^-2", 1, stress);
  expect_equal("mJ/m^2", 1e-3, surface_energy);
  expect_equal("kg*s^-2", 1, surface_energy);
  expect_equal("N.m/m^2/m", 1, stress);
  expect_equal("g/cm^3", 1000, density);
  expect_equal("kg/m^(3)", 1, density);
  expect_equal("1/s", 1, rate);
  expect_equal("/ s", 1, rate);
  expect_equal("GHz", 1e9, rate);
}

TEST(UnitTest, TheTableHasTheSIAndAFewOthers) {
  expect_equal("eV", 1.602176634e-19, {{2, 1, -2}});
  expect_equal("min", 60, {{0, 0, 1}});
  expect_equal("h", 3600, {{0, 0, 1}});
  expect_equal("Angstrom", 1e-10, {{1}});
  expect_equal("V", 1, {{2, 1, -3, -1}});
  expect_equal("F V^2", 1, {{2, 1, -2}});
  expect_equal("C V", 1, {{2, 1, -2}});
  expect_equal("W s", 1, {{2, 1, -2}});
  expect_equal("mmol K", 1e-3, {{0, 0, 0, 0, 1, 1}});
  for (const char* symbol : {"kmin", "mdeg", "Mkg", "x", "", "mum"}) EXPECT_FALSE(si_unit(symbol)) << symbol;
}

TEST(UnitTest, SignsBeyondASCIIAreRead) {
  for (const char* micrometre : {"\u00b5m", "\u03bcm", "um"}) expect_equal(micrometre, 1e-6, {{1}});
  for (const char* angstrom : {"\u00c5", "\u212b", "A\u030a"}) expect_equal(angstrom, 1e-10, {{1}});
  expect_equal("kg/m\u00b3", 1, {{-3, 1}});
  expect_equal("N\u00b7m", 1, {{2, 1, -2}});
  expect_equal("kg m\u207b\u00b3", 1, {{-3, 1}});
  expect_equal("mm s\u207b\u00b2", 1e-3, {{1, 0, -2}});
  expect_equal("m\u00b9 s\u207b\u2079/m\u2074", 1, {{-3, 0, -9}});
}

TEST(UnitTest, WhatIsWrongOrAmbiguousIsRefused) {
  const auto refused = [](const std::string& text, const std::string& words) {
    test::expect_contains(test::refusal([&] { si(text); }), words);
  };
  refused("mpa", "unit \"mpa\" does not exist; did you mean \"MPa\"?");
  refused("m2", "did you mean \"m^2\"?");
  refused("MPa m^0.5", "an exponent must be an integer");
  refused("m^(1/2)", "an exponent must be an integer");
  refused("m^", "an exponent must be an integer");
  refused("m^10", "at most 9");
  refused("m\u00b9\u2070", "at most 9");
  refused("m\u207b", "an exponent must be an integer");
  refused("J/m s", "ambiguous");
  refused("(m)^2", "a parenthesis cannot have an exponent");
  refused("(m", "a parenthesis is not closed");
  refused("m)", "cannot continue with \")\"");
  refused("m 2", "a unit is missing");
  refused("m/", "a unit is missing");
  refused("m**2", "a unit is missing");
  refused(std::string(101, 'm'), "longer than 100 characters");
}

}  // namespace
}  // namespace ixos
