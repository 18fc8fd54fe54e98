// Tolerances as users write them.
#include "study/common/tolerance.hpp"

#include <gtest/gtest.h>

#include "support/refusal.hpp"

namespace ixos {
namespace {

TEST(ToleranceTest, PerCentAndPartsAreTheSame) {
  EXPECT_DOUBLE_EQ(read_tolerance("--accuracy", "1%"), 0.01);
  EXPECT_DOUBLE_EQ(read_tolerance("--accuracy", " 0.5 % "), 0.005);
  EXPECT_DOUBLE_EQ(read_tolerance("--accuracy", "0.01"), 0.01);
  EXPECT_DOUBLE_EQ(read_tolerance("--accuracy", "1e-8"), 1e-8);
}

TEST(ToleranceTest, OtherTextsAreRefusedByTheNameOfTheOption) {
  for (const char* text : {"", "%", "0", "-1%", "100%", "1", "1e-9", "1%%", "1 per cent", "nan", "inf", "0.01x"}) {
    const std::string message = test::refusal([&] { read_tolerance("--accuracy", text); });
    test::expect_contains(message, std::string("--accuracy: \"") + text + "\" is no tolerance");
  }
}

}  // namespace
}  // namespace ixos
