#include "parameters/catalogue.hpp"

#include <gtest/gtest.h>

#include "parameters/validation.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

using Teuchos::ParameterList;

/// The product tells who made it, where, and from what.
using Entry = CatalogueEntry<std::string, int>;

Entry entry(const std::string& name, const std::string& source, const char* parameter) {
  Entry result;
  result.name = name;
  result.sentence = name + " of paper.";
  result.source = source;
  if (parameter != nullptr) result.parameters.set(parameter, 2, "How large it is.");
  result.make = [name, parameter](const SceneNode& node, int context) {
    const std::string size = parameter == nullptr ? "" : std::to_string(node.count(parameter));
    return name + " at " + node.path() + ", " + size + ", " + std::to_string(context);
  };
  return result;
}

Catalogue<Entry> shapes() {
  Entry strip = entry("Strip", "Euler 1744, p. 3", "Length");
  strip.in_place = true;
  return {"Shape",
          "Shape of the product.",
          {entry("Sheet", "", nullptr), entry("Ring", "Gauss 1827", "Radius"), strip, entry("Tube", "", "Width")}};
}

ParameterList declared() {
  ParameterList list("Valid");
  shapes().declare(list);
  return list;
}

/// A scene's complete list that chooses a shape.
ParameterList scene(const std::string& shape) {
  ParameterList user;
  user.set("Shape", shape);
  return validated(user, declared());
}

TEST(CatalogueTest, TheFirstEntryIsTheDefault) {
  EXPECT_EQ(declared().get<std::string>("Shape"), "Sheet");
  EXPECT_EQ(shapes().choice(), "Shape");
}

TEST(CatalogueTest, OnlyItsEntriesCanBeChosen) {
  test::expect_contains(test::refusal([] { scene("Rings"); }),
                        "did you mean \"Ring\"? Allowed: \"Sheet\", \"Ring\", \"Strip\", \"Tube\"");
}

TEST(CatalogueTest, EachEntryIsDescribedWithItsSource) {
  const ParameterList list = declared();
  EXPECT_EQ(list.getEntry("Shape").docString(),
            "Shape of the product. Sheet of paper. Strip of paper (Euler 1744, p. 3).");
  EXPECT_EQ(list.getEntry("Ring").docString(), "Ring of paper (Gauss 1827).");
  EXPECT_EQ(list.getEntry("Tube").docString(), "Tube of paper.");
}

TEST(CatalogueTest, ParametersStandInSublistsOrBesideTheChoice) {
  const ParameterList list = declared();
  EXPECT_EQ(list.numParams(), 4);  // the choice, two sublists, and the length of strips
  EXPECT_EQ(list.sublist("Ring").get<int>("Radius"), 2);
  EXPECT_EQ(list.sublist("Ring").name(), "Ring");
  EXPECT_EQ(list.sublist("Ring").getEntry("Radius").docString(), "How large it is.");
  EXPECT_EQ(list.sublist("Tube").get<int>("Width"), 2);
  EXPECT_EQ(list.get<int>("Length"), 2);
  EXPECT_EQ(list.getEntry("Length").docString(), "How large it is.");
}

TEST(CatalogueTest, OnlyTheChosenSublistIsFilledIn) {
  const ParameterList ring = scene("Ring");
  EXPECT_TRUE(ring.isSublist("Ring"));
  EXPECT_FALSE(ring.isSublist("Tube"));
}

TEST(CatalogueTest, TheChosenEntryMakesTheProductFromItsOwnList) {
  const struct {
    std::string shape, product;
  } cases[] = {{"Sheet", "Sheet at Paper, , 7"},
               {"Ring", "Ring at Paper/Ring, 2, 7"},
               {"Strip", "Strip at Paper, 2, 7"},
               {"Tube", "Tube at Paper/Tube, 2, 7"}};
  for (const auto& c : cases) {
    const ParameterList list = scene(c.shape);
    const SceneNode node(list, "Paper");
    EXPECT_EQ(shapes().chosen(node).name, c.shape);
    EXPECT_EQ(shapes().make(node, 7), c.product);
  }
}

TEST(CatalogueTest, ProductsAreMadeFromWhatTheUserGives) {
  ParameterList user;
  user.set("Shape", std::string("Tube"));
  user.sublist("Tube").set("Width", 5);
  const ParameterList list = validated(user, declared());
  EXPECT_EQ(shapes().make(SceneNode(list, "Paper"), 1), "Tube at Paper/Tube, 5, 1");
}

TEST(CatalogueTest, AChoiceThatTheValidationCannotHaveAcceptedIsADefect) {
  ParameterList list = scene("Sheet");
  list.set("Shape", std::string("Cone"));
  EXPECT_THROW(shapes().make(SceneNode(list, ""), 1), std::logic_error);
}

}  // namespace
}  // namespace ixos
