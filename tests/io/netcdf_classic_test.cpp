#include "io/netcdf_classic.hpp"

#include <gtest/gtest.h>

#include "support/files.hpp"
#include "support/refusal.hpp"
#include "test_folders.hpp"

namespace ixos {
namespace {

const std::string bytes = test::contents(IXOS_TEST_DIRECTORY "/io/heights/steps-classic.nc");

TEST(NetcdfClassicTest, ReadsDimensionsVariablesAndAttributes) {
  const NetcdfClassic file("steps", bytes);
  ASSERT_EQ(file.dimensions().size(), 2U);
  EXPECT_EQ(file.dimensions()[0].name, "y");
  EXPECT_EQ(file.dimensions()[0].length, 3U);
  EXPECT_EQ(file.dimensions()[1].length, 4U);
  ASSERT_EQ(file.variables().size(), 3U);
  const auto& height = file.variables()[2];
  EXPECT_EQ(height.name, "height");
  EXPECT_EQ(height.dimensions, (std::vector<std::size_t>{0, 1}));
  ASSERT_NE(height.attribute("units"), nullptr);
  EXPECT_EQ(height.attribute("units")->text, "nm");
  EXPECT_EQ(height.attribute("long_name"), nullptr);
  EXPECT_EQ(file.header_bytes(), file.variables()[0].begin);  // the values follow without a hole
  EXPECT_EQ(file.values(file.variables()[1]), (std::vector<double>{0, 0.5, 1, 1.5}));
}

// Whatever is cut off, the file is refused.
TEST(NetcdfClassicTest, ATruncatedFileIsRefused) {
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    const std::string part = bytes.substr(0, length);
    EXPECT_NE(test::refusal([&] {
                const NetcdfClassic file("steps", part);
                for (const auto& variable : file.variables()) file.values(variable);
              }),
              "")
        << length;
  }
}

TEST(NetcdfClassicTest, ABadHeaderIsRefused) {
  std::string other = bytes;
  other[3] = 3;
  test::expect_contains(test::refusal([&] { NetcdfClassic("steps", other); }), "steps: its header is damaged");
  other = bytes;
  other[8 + 4] = '\x7f';  // the number of dimensions, high byte
  test::expect_contains(test::refusal([&] { NetcdfClassic("steps", other); }), "damaged");
}

}  // namespace
}  // namespace ixos
