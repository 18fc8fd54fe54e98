#include "parameters/catalogue.hpp"

#include <gtest/gtest.h>

#include "parameters/range_validator.hpp"
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

/// An entry whose parameter stands beside the choice.
Entry in_place(const std::string& name, int length, const std::string& source = "") {
  Entry result = entry(name, source, "Length");
  result.parameters.set("Length", length, "How large it is.");
  result.in_place = true;
  return result;
}

Catalogue<Entry> shapes() {
  const Entry strip = in_place("Strip", 2, "Euler 1744, p. 3");
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
  EXPECT_FALSE(ring.isParameter("Length"));
  EXPECT_TRUE(scene("Strip").isParameter("Length"));
}

TEST(CatalogueTest, ParametersOfEntriesThatAreNotChosenAreRefused) {
  ParameterList ring;
  ring.set("Shape", std::string("Ring"));
  ring.set("Length", 3);
  EXPECT_EQ(test::refusal([&] { validated(ring, declared()); }),
            "\"Length\" belongs to Shape \"Strip\", but Shape is \"Ring\"; remove it, or set Shape to \"Strip\"");
  ParameterList sheet;
  sheet.sublist("Tube").set("Width", 3);
  EXPECT_EQ(test::refusal([&] { validated(sheet, declared()); }),
            "\"Tube\" belongs to Shape \"Tube\", but Shape is \"Sheet\"; remove it, or set Shape to \"Tube\"");
}

TEST(CatalogueTest, EntriesMayShareAParameter) {
  const Catalogue<Entry> catalogue("Shape", "",
                                   {in_place("Strip", 2), in_place("Band", 2), entry("Sheet", "", nullptr)});
  ParameterList valid, band;
  catalogue.declare(valid);
  EXPECT_EQ(valid.numParams(), 2);
  band.set("Shape", std::string("Band"));
  band.set("Length", 5);
  const ParameterList complete = validated(band, valid);
  EXPECT_EQ(catalogue.make(SceneNode(complete, "Paper"), 1), "Band at Paper, 5, 1");
  ParameterList sheet = band;
  sheet.set("Shape", std::string("Sheet"));
  test::expect_contains(test::refusal([&] { validated(sheet, valid); }), "belongs to Shape \"Strip\" or \"Band\"");
}

TEST(CatalogueTest, EntriesThatDeclareAParameterDifferentlyAreADefect) {
  Entry other_type = in_place("Band", 2), other_text = other_type, ranged = other_type, other_range = other_type;
  other_type.parameters.set("Length", 2.0, "How large it is.");
  other_text.parameters.set("Length", 2, "How long it is.");
  ranged.parameters.set("Length", 2, "How large it is.", between(1, 9));
  other_range.name = "Ribbon";
  other_range.parameters.set("Length", 2, "How large it is.", between(1, 8));
  const auto make = [](const std::vector<Entry>& entries) { Catalogue<Entry>("Shape", "", entries); };
  EXPECT_NO_THROW(make({in_place("Strip", 2), in_place("Band", 2)}));
  EXPECT_THROW(make({in_place("Strip", 2), in_place("Band", 3)}), std::logic_error) << "default";
  EXPECT_THROW(make({in_place("Strip", 2), other_type}), std::logic_error);
  EXPECT_THROW(make({in_place("Strip", 2), other_text}), std::logic_error);
  EXPECT_THROW(make({in_place("Strip", 2), ranged}), std::logic_error);
  EXPECT_THROW(make({ranged, other_range}), std::logic_error);
  try {
    make({in_place("Strip", 2), in_place("Band", 3)});
  } catch (const std::logic_error& error) {
    EXPECT_STREQ(error.what(),
                 "the catalogue of \"Shape\": \"Strip\" and \"Band\" declare \"Length\" with another type, default, "
                 "range or documentation");
  }
}

TEST(CatalogueTest, NamesThatAreTakenAreADefect) {
  const auto make = [](const std::vector<Entry>& entries) { Catalogue<Entry>("Shape", "", entries); };
  Entry strip = in_place("Strip", 2);
  EXPECT_THROW(make({entry("Ring", "", "Radius"), entry("Ring", "", "Diameter")}), std::logic_error);
  EXPECT_THROW(make({entry("Length", "", "Width"), strip}), std::logic_error) << "a list and a parameter";
  EXPECT_THROW(Catalogue<Entry>("Length", "", {strip}), std::logic_error) << "the choice and a parameter";
  EXPECT_THROW(Catalogue<Entry>("Ring", "", {entry("Ring", "", "Radius")}), std::logic_error);
  for (const char* name : {"Shape", "Ring", "Length"}) {
    ParameterList list;
    list.set(name, 1);
    EXPECT_THROW(shapes().declare(list), std::logic_error) << name;
  }
}

TEST(CatalogueTest, PutsThePathBeforeRefusals) {
  Entry silent = entry("Ring", "", "Radius"), placed = entry("Tube", "", "Width"), strip = in_place("Strip", 2);
  silent.make = [](const SceneNode&, int) -> std::string { throw InputError("too small"); };
  placed.make = [](const SceneNode& node, int) -> std::string { node.refuse("Width", "too small"); };
  strip.make = silent.make;
  const Catalogue<Entry> catalogue("Shape", "", {silent, placed, strip});
  ParameterList valid;
  catalogue.declare(valid);
  const auto refusal = [&](const std::string& shape) {
    ParameterList user;
    user.set("Shape", shape);
    const ParameterList complete = validated(user, valid);
    return test::refusal([&] { catalogue.make(SceneNode(complete, "Paper"), 1); });
  };
  EXPECT_EQ(refusal("Ring"), "Paper/Ring: too small");
  EXPECT_EQ(refusal("Tube"), "Paper/Tube/Width: too small");
  EXPECT_EQ(refusal("Strip"), "Paper: too small");
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
