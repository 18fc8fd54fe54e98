#include "base/closest_name.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

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

TEST(ClosestNameTest, AWordOfANameIsUnderstood) {
  const std::vector<std::string> laws{"Van der Waals", "Morse", "Mie", "Xu-Needleman", "Smooth Dugdale", "Triangle"};
  for (const char* name : {"Dugdale", "dugdale", "DUGDALE"}) EXPECT_EQ(closest_name(name, laws), "Smooth Dugdale");
  EXPECT_EQ(closest_name("Needleman", laws), "Xu-Needleman");
  EXPECT_EQ(closest_name("Waals", laws), "Van der Waals");
  EXPECT_EQ(closest_name("der", {"Van der Waals", "dero"}), "dero");  // too short to mean the whole
}

TEST(ClosestNameTest, AbbreviationsOfTheLiteratureAreUnderstood) {
  const std::vector<std::string> schemes{"Newmark",
                                         "Bathe Composite",
                                         "Gautam-Sauer Composite",
                                         "Average Vector Field",
                                         "Energy-Momentum",
                                         "Midpoint",
                                         "Generalized-Alpha",
                                         "HHT-Alpha",
                                         "Central Difference",
                                         "Static",
                                         "Custom"};
  const std::vector<std::pair<std::string, std::string>> cases{{"AVF", "Average Vector Field"},
                                                               {"EM", "Energy-Momentum"},
                                                               {"EnergyMomentum", "Energy-Momentum"},
                                                               {"GA", "Generalized-Alpha"},
                                                               {"gen-alpha", "Generalized-Alpha"},
                                                               {"GenAlpha", "Generalized-Alpha"},
                                                               {"HHT", "HHT-Alpha"},
                                                               {"hht", "HHT-Alpha"},
                                                               {"CD", "Central Difference"},
                                                               {"Bathe", "Bathe Composite"},
                                                               {"Newmrak", "Newmark"}};
  for (const auto& [name, scheme] : cases) EXPECT_EQ(closest_name(name, schemes), scheme) << name;
  for (const char* name : {"vdW", "LJ", "Lennard-Jones"})
    EXPECT_EQ(closest_name(name, {"Van der Waals"}), "Van der Waals") << name;
  EXPECT_EQ(closest_name("vdW", {"Hard", "Van der Waals"}), "Van der Waals");
}

TEST(ClosestNameTest, NamesThatAreWrittenInFullComeBeforeAbbreviated) {
  EXPECT_EQ(closest_name("Time Step", {"Time Step Control", "Time Step"}), "Time Step");
  EXPECT_EQ(closest_name("Tim Step", {"Time Step Control", "Time Stop", "Time Step"}), "Time Step");
  EXPECT_EQ(closest_name("AVF", {"Average Vector Field", "AVX"}), "AVX");  // one edit is nearer than an abbreviation
}

TEST(ClosestNameTest, PartsOfWordsThatAreNotBeginningsAbbreviateNothing) {
  EXPECT_EQ(closest_name("AV", {"Average Vector Field", "Box"}), "Box");    // a word is missing
  EXPECT_EQ(closest_name("AVFX", {"Average Vector Field", "Box"}), "Box");  // a letter too many
  EXPECT_EQ(closest_name("", {"Average Vector Field", "x"}), "x");
}

TEST(QuotedListTest, NamesAreQuotedAndSeparatedByCommas) {
  EXPECT_EQ(quoted_list({}), "");
  EXPECT_EQ(quoted_list({"left"}), "\"left\"");
  EXPECT_EQ(quoted_list({"left", "right", "two words"}), "\"left\", \"right\", \"two words\"");
}

}  // namespace
}  // namespace ixos
