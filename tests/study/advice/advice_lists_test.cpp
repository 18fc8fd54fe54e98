// Settings of all bodies or interactions together.
#include "study/advice/advice_lists.hpp"

#include <gtest/gtest.h>

namespace ixos {
namespace {

Teuchos::ParameterList two_bodies() {
  Teuchos::ParameterList materials;
  materials.sublist("A").set<std::string>("Model", "Neo-Hooke");
  materials.sublist("B").set<std::string>("Model", "Neo-Hooke");
  materials.set("Number", 1);
  return materials;
}

TEST(AdviceListsTest, NamesAreThoseOfListsThatAPathCanName) {
  Teuchos::ParameterList materials = two_bodies();
  materials.sublist("C/D");
  EXPECT_EQ(list_names(materials), (std::vector<std::string>{"A", "B"}));
}

TEST(AdviceListsTest, ASettingOfEachList) {
  EXPECT_EQ(in_all("Materials", {"A", "B"}, "Density=1"),
            (Assignments{"Materials/A/Density=1", "Materials/B/Density=1"}));
}

TEST(AdviceListsTest, AllHaveTheSameWord) {
  Teuchos::ParameterList materials = two_bodies();
  EXPECT_TRUE(all_are(materials, {"A", "B"}, "Model", {"Gent", "Neo-Hooke"}));
  EXPECT_FALSE(all_are(materials, {"A", "B"}, "Model", {"Gent"}));
  EXPECT_FALSE(all_are(materials, {}, "Model", {"Neo-Hooke"}));
  materials.sublist("B").set<std::string>("Model", "Gent");
  EXPECT_FALSE(all_are(materials, {"A", "B"}, "Model", {"Gent", "Neo-Hooke"}));
}

}  // namespace
}  // namespace ixos
