// The quantities that a scene names, against its columns and times.
#include "study/common/named_quantities.hpp"

#include <gtest/gtest.h>

#include "support/refusal.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

std::vector<AskedQuantity> named(const std::string& quantities) {
  const std::vector<std::string> assignments{"Output/Quantities=" + quantities};
  const Simulation simulation(test::scene_file("ball.xml", assignments), test::self());
  return named_quantities(simulation);
}

std::string refusal_of_times(const std::string& quantities) {
  const Simulation simulation(test::scene_file("ball.xml"), test::self());
  return test::refusal([&] { check_times({AskedQuantity(quantities)}, simulation); });
}

std::string refusal(const std::string& quantities) {
  return test::refusal([&] { named(quantities); });
}

TEST(NamedQuantitiesTest, NoneIsAllowed) { EXPECT_TRUE(named("{}").empty()); }

TEST(NamedQuantitiesTest, AWindowMayHaveAComma) {
  const std::vector<AskedQuantity> found = named("{peak contact_force_y, mean contact_force_y [0.1, 2], work}");
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].text(), "peak contact_force_y");
  EXPECT_EQ(found[1].text(), "mean contact_force_y [0.1, 2]");
  EXPECT_EQ(found[2].text(), "work");
}

TEST(NamedQuantitiesTest, OthersAreRefusedWithTheirPlace) {
  test::expect_contains(refusal("{heaviest contact_force_y}"),
                        "Output/Quantities: \"heaviest contact_force_y\": this is");
  test::expect_contains(refusal("{peak contact_force_z}"), "Output/Quantities: \"peak contact_force_z\": column");
}

TEST(NamedQuantitiesTest, TimesOutsideTheRunAreRefusedWhereTheyCount) {
  EXPECT_EQ(refusal("{mean contact_force_y [20, 30]}"), "") << "a shorter run of the scene is no mistake";
  test::expect_contains(refusal_of_times("mean contact_force_y [20, 30]"),
                        "Output/Quantities: \"mean contact_force_y [20, 30]\": the window holds no rows");
  test::expect_contains(refusal_of_times("value contact_force_y at 11"), "the time 11 is not within the run");
  EXPECT_EQ(refusal_of_times("value contact_force_y at 10"), "");
}

}  // namespace
}  // namespace ixos
