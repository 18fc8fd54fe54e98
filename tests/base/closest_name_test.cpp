#include "base/closest_name.hpp"

#include <gtest/gtest.h>

namespace ixos {
namespace {

TEST(ClosestNameTest, ExactNameIsItsOwnNearest) {
  const std::vector<std::string> names{"Newmark", "Bathe", "Composite"};
  for (const std::string& name : names) EXPECT_EQ(closest_name(name, names), name);
}

TEST(ClosestNameTest, OneEditOfAnyKindIsNearerThanTwo) {
  // The decoy is two insertions away and comes first: a kind of edit that cost more than one would lose to it.
  EXPECT_EQ(closest_name("mesh", {"meshxy", "meshs"}), "meshs");                // insertion
  EXPECT_EQ(closest_name("meshs", {"meshsxy", "mesh"}), "mesh");                // deletion
  EXPECT_EQ(closest_name("mash", {"mashxy", "mesh"}), "mesh");                  // substitution
  EXPECT_EQ(closest_name("mehs", {"mehsxy", "mesh"}), "mesh");                  // neighbours swapped at the end,
  EXPECT_EQ(closest_name("emsh", {"emshxy", "mesh"}), "mesh");                  // at the beginning
  EXPECT_EQ(closest_name("Adehsion", {"Adehsionxy", "Adhesion"}), "Adhesion");  // and in the middle
}

TEST(ClosestNameTest, NoPartIsEditedTwice) {
  // Optimal string alignment: CA to ABC takes three edits; the unrestricted distance would take two and prefer ABC.
  EXPECT_EQ(closest_name("CA", {"ABC", "CAXY"}), "CAXY");
}

TEST(ClosestNameTest, CaseIsIgnored) {
  EXPECT_EQ(closest_name("BATHE", {"BATHES", "bathe"}), "bathe");
  EXPECT_EQ(closest_name("bahte", {"bahtex2", "BATHE"}), "BATHE");  // a swap across case
}

TEST(ClosestNameTest, NothingIsNearestWhereThereIsNoCandidate) {
  EXPECT_EQ(closest_name("Newmark", {}), "");
  EXPECT_EQ(closest_name("", {"long", "x", "also long"}), "x");
}

TEST(ClosestNameTest, OfALongNameItsBeginningCounts) {
  const std::string long_name = "Newmark" + std::string(100000000, 'x');  // its whole table would take 6 GB
  EXPECT_EQ(closest_name(long_name, {"Bathe", "Newmarkx"}), "Newmarkx");
}

TEST(QuotedListTest, NamesAreQuotedAndSeparatedByCommas) {
  EXPECT_EQ(quoted_list({}), "");
  EXPECT_EQ(quoted_list({"left"}), "\"left\"");
  EXPECT_EQ(quoted_list({"left", "right", "two words"}), "\"left\", \"right\", \"two words\"");
}

}  // namespace
}  // namespace ixos
