// Files of heights; heights/README.md describes those of the folder.
#include "io/height_grid.hpp"

#include <gtest/gtest.h>

#include "support/refusal.hpp"
#include "test_folders.hpp"

namespace ixos {
namespace {

using test::expect_contains;
using test::refusal;

std::string path(const std::string& name) { return IXOS_TEST_DIRECTORY "/io/heights/" + name; }

std::string refused(const std::string& name) {
  return refusal([&] { read_height_grid(path(name)); });
}

class HeightFileTest : public testing::TestWithParam<const char*> {};

TEST_P(HeightFileTest, HoldsTheSteps) {
  const HeightGrid grid = read_height_grid(path(GetParam()));
  ASSERT_EQ(grid.rows, 3U);
  ASSERT_EQ(grid.columns, 4U);
  EXPECT_TRUE(grid.in_metres);
  EXPECT_NEAR(grid.row_spacing, 0.3e-6, 1e-20);
  EXPECT_NEAR(grid.column_spacing, 0.5e-6, 1e-20);
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(grid.heights[4 * r + k], (10.0 * static_cast<double>(r) + static_cast<double>(k)) * 1e-9, 1e-22);
}

INSTANTIATE_TEST_SUITE_P(Formats, HeightFileTest,
                         testing::Values("steps.gsf", "steps-classic.nc", "steps-offset.nc", "steps-data.nc",
                                         "steps-falling.nc", "steps-short.nc", "steps-float.nc"));

TEST(HeightGridTest, MissingHeightsAreRefusedWithTheirPlace) {
  expect_contains(refused("gap.gsf"), "gap.gsf: the height in row 2, column 3 is missing");
  expect_contains(refused("gap.nc"), "gap.nc: the height in row 2, column 3 is missing");
}

TEST(HeightGridTest, UnknownUnitsAreRefused) {
  expect_contains(refused("no-units.nc"), "the units of \"height\" is missing: the unit must be a length");
  expect_contains(refused("volts.nc"), "the units of \"height\" is \"V\": it must be a length");
}

TEST(HeightGridTest, WhatCannotBeReadIsRefused) {
  expect_contains(refused("uneven.nc"), "\"x\" is not in equal distances: 1.2");
  expect_contains(refused("netcdf4.nc"), "convert it with nccopy -k classic");
  expect_contains(refused("is-not-there.gsf"), "cannot be read");
}

TEST(HeightGridTest, ATextIsReadFromTheTop) {
  const HeightGrid grid = read_height_text("t", "# two rows\n1 2.5, 3\n\n-4;5e-1\t6\r\n");
  EXPECT_EQ(grid.rows, 2U);
  EXPECT_EQ(grid.columns, 3U);
  EXPECT_FALSE(grid.in_metres);
  EXPECT_EQ(grid.heights, (std::vector<double>{-4, 0.5, 6, 1, 2.5, 3}));
}

TEST(HeightGridTest, BadTextsAreRefusedWithTheirPlace) {
  const auto refused_text = [](const std::string& text) { return refusal([&] { read_height_text("t", text); }); };
  expect_contains(refused_text("1 2\n3\n"), "t: line 2 has 1 heights, but the first row has 2");
  expect_contains(refused_text("1 2\n3 x4\n"), "t: line 2, number 2: \"x4\" is no height");
  expect_contains(refused_text("1 inf\n"), "t: line 1, number 2: \"inf\" is no height");
  expect_contains(refused_text("# nothing\n"), "t: has no heights");
}

std::string field(const std::string& header, std::size_t floats) {
  std::string bytes = "Gwyddion Simple Field 1.0\n" + header;
  bytes.append(4 - bytes.size() % 4, '\0');
  return bytes + std::string(4 * floats, '\0');
}

TEST(SimpleFieldTest, BadHeadersAreRefused) {
  const auto refused_field = [](const std::string& header, std::size_t floats) {
    return refusal([&] { read_simple_field("f", field(header, floats)); });
  };
  const std::string size = "XRes = 2\nYRes = 2\n", units = "XYUnits = m\nZUnits = m\n";
  expect_contains(refused_field("XRes = 2\n", 4), "f: YRes is \"\"; it must be a positive number");
  expect_contains(refused_field("XRes = 4000000000\nYRes = 4000000000\n", 4), "has no data of 4000000000 x 4000000000");
  expect_contains(refused_field(size, 3), "has no data of 2 x 2 heights");
  expect_contains(refused_field(size, 4), "f: XYUnits is missing");
  expect_contains(refused_field(size + units, 4), "f: XReal is \"\"; it must be a positive length");
  expect_contains(refused_field(size + "nonsense\n", 4), "the line \"nonsense\" of the header has no =");
  expect_contains(refusal([] { read_simple_field("f", "Gwyddion Simple Field 1.0\nXRes = 2\n"); }),
                  "end of the header");
}

TEST(MetresTest, UnitsOfLengthAreKnown) {
  EXPECT_EQ(metres_in("m", ""), 1);
  EXPECT_EQ(metres_in("metres", ""), 1);
  EXPECT_NEAR(metres_in("nm", ""), 1e-9, 1e-24);
  EXPECT_NEAR(metres_in("\xc2\xb5m", ""), 1e-6, 1e-21);
  EXPECT_NEAR(metres_in("Angstrom", ""), 1e-10, 1e-25);
  expect_contains(refusal([] { metres_in("furlong", "f: ZUnits"); }), "f: ZUnits is \"furlong\": it must be a length");
}

}  // namespace
}  // namespace ixos
