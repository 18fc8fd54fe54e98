#include "base/warning.hpp"

#include <gtest/gtest.h>

namespace ixos {
namespace {

std::string odd(const int& number) { return number % 2 != 0 ? std::to_string(number) + " is odd" : ""; }
std::string large(const int& number) { return number > 10 ? std::to_string(number) + " is large" : ""; }

TEST(WarningsOfTest, EachKindThatHasAMessageWarnsInItsOrder) {
  constexpr WarningKind<int> kinds[] = {{"parity", odd}, {"size", large}};
  EXPECT_TRUE(warnings_of(2, kinds).empty());
  const std::vector<Warning> both = warnings_of(11, kinds);
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[0].name, "parity");
  EXPECT_EQ(both[0].message, "11 is odd");
  EXPECT_EQ(both[1].name, "size");
  ASSERT_EQ(warnings_of(12, kinds).size(), 1U);
  EXPECT_EQ(warnings_of(12, kinds)[0].name, "size");
}

}  // namespace
}  // namespace ixos
