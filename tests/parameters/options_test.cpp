#include "parameters/options.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "parameters/parameter_entries.hpp"
#include "parameters/range_validator.hpp"
#include "parameters/validation.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

using Teuchos::ParameterList;

enum class Colour { Red, Green, Blue };

struct Coat {
  double thickness = 0.25;
};

enum class Shop { Near, Far };

/// The entries of a sublist.
struct Brush {
  double width = 3;
  bool soft = false;
};

struct Paint : Coat {
  int layers = 2;
  bool glossy = true;
  std::string maker = "anyone";
  std::vector<double> mixture{0.5, 1.5};
  std::vector<int> codes{3, 1};
  std::vector<std::string> shades{"light", "dark"};
  double price = 0;
  Colour colour = Colour::Green;
  Shop shop = Shop::Near;
  Brush brush{}, far{};
  ParameterList recipe;
};

Options<Brush> brush_options() {
  return Options<Brush>()
      .add("Width", &Brush::width, "Width of the brush.", greater_than(0))
      .add("Soft", &Brush::soft, "Whether it is soft.");
}

Options<Paint> options() {
  Options<Paint> all;
  all.add("Thickness", &Paint::thickness, "Thickness of a layer.", greater_than(0))
      .add("Layers", &Paint::layers, "Number of layers.", between(1, 9))
      .add("Glossy", &Paint::glossy, "Whether it shines.")
      .add("Maker", &Paint::maker, "Who makes it.")
      .add("Mixture", &Paint::mixture, "Parts.", at_least(0))
      .add("Codes", &Paint::codes, "Numbers on the tin.")
      .add("Shades", &Paint::shades, "Names of the shades.")
      .require("Price", &Paint::price, "Price of a tin.", greater_than(0))
      .choose("Colour", &Paint::colour, {{"Red", Colour::Red}, {"Green", Colour::Green}, {"Blue", Colour::Blue}},
              "How it looks.")
      .choose_list("Shop", &Paint::shop, {{"Near", Shop::Near}, {"Far", Shop::Far}}, "Where it is sold.")
      .sublist("Brush", &Paint::brush, brush_options(), "The brush for this paint.")
      .sublist("Far", &Paint::far, brush_options(), "The brush that the far shop sells.")
      .free_form("Recipe", &Paint::recipe, "Entries for the maker.");
  return all;
}

/// A list with all that must be given.
ParameterList least() {
  ParameterList user;
  user.set("Price", 4.0);
  return user;
}

Paint read(const ParameterList& user) {
  const ParameterList complete = validated(user, options().list());
  return options().read(SceneNode(complete, "Paint"));
}

template <class T>
std::string refusal_of(const std::string& name, const T& value) {
  return test::refusal([&] {
    ParameterList user = least();
    user.set(name, value);
    read(user);
  });
}

TEST(OptionsTest, TheListHasTheDefaultsOfTheStruct) {
  const ParameterList list = options().list();
  EXPECT_EQ(list.get<double>("Thickness"), 0.25);
  EXPECT_EQ(list.get<int>("Layers"), 2);
  EXPECT_TRUE(list.get<bool>("Glossy"));
  EXPECT_EQ(list.get<std::string>("Maker"), "anyone");
  EXPECT_EQ(list.get<Teuchos::Array<double>>("Mixture").toVector(), Paint().mixture);
  EXPECT_EQ(list.get<Teuchos::Array<int>>("Codes").toVector(), Paint().codes);
  EXPECT_TRUE(std::isnan(list.get<double>("Price")));
  EXPECT_EQ(list.get<Teuchos::Array<std::string>>("Shades").toVector(), Paint().shades);
  EXPECT_EQ(list.get<std::string>("Colour"), "Green");
  EXPECT_EQ(list.get<std::string>("Shop"), "Near");
  EXPECT_EQ(list.sublist("Brush").get<double>("Width"), 3);
  EXPECT_TRUE(is_free_form(list.sublist("Recipe")));
}

TEST(OptionsTest, TheListIsDocumentedInTheOrderOfTheEntries) {
  const ParameterList list = options().list();
  std::vector<std::string> texts;
  for (const auto& [name, entry] : entries(list)) texts.push_back(name + ": " + entry.docString());
  EXPECT_EQ(texts, (std::vector<std::string>{
                       "Thickness: Thickness of a layer.", "Layers: Number of layers.", "Glossy: Whether it shines.",
                       "Maker: Who makes it.", "Mixture: Parts.", "Codes: Numbers on the tin.",
                       "Shades: Names of the shades.", "Price: Price of a tin.", "Colour: How it looks.",
                       "Shop: Where it is sold.", "Brush: The brush for this paint.",
                       "Far: The brush that the far shop sells.", "Recipe: Entries for the maker."}));
}

TEST(OptionsTest, DeclarationsAddToAList) {
  ParameterList list;
  list.set("Canvas", 1);
  options().declare(list);
  EXPECT_EQ(list.get<int>("Canvas"), 1);
  EXPECT_EQ(list.numParams(), options().list().numParams() + 1);
}

TEST(OptionsTest, NamesThatAreTakenAreADefect) {
  ParameterList list;
  list.set("Layers", 1);
  EXPECT_THROW(options().declare(list), std::logic_error);
  EXPECT_THROW(options().add("Layers", &Paint::layers, "Once more.").list(), std::logic_error);
}

TEST(OptionsTest, DefaultsComeBackAsTheStruct) {
  const Paint paint = read(least()), fresh;
  EXPECT_EQ(paint.thickness, fresh.thickness);
  EXPECT_EQ(paint.layers, fresh.layers);
  EXPECT_EQ(paint.glossy, fresh.glossy);
  EXPECT_EQ(paint.maker, fresh.maker);
  EXPECT_EQ(paint.mixture, fresh.mixture);
  EXPECT_EQ(paint.codes, fresh.codes);
  EXPECT_EQ(paint.price, 4.0);
  EXPECT_EQ(paint.shades, fresh.shades);
  EXPECT_EQ(paint.colour, fresh.colour);
  EXPECT_EQ(paint.shop, fresh.shop);
  EXPECT_EQ(paint.brush.width, fresh.brush.width);
  EXPECT_EQ(paint.recipe.numParams(), 0);
}

TEST(OptionsTest, ReadsWhatTheUserGives) {
  ParameterList user = least();
  user.set("Thickness", 0.75);
  user.set("Layers", 5);
  user.set("Glossy", false);
  user.set("Maker", std::string("us"));
  user.set("Mixture", Teuchos::Array<double>(Teuchos::tuple(1.0, 2.0, 3.0)));
  user.set("Codes", Teuchos::Array<int>());
  user.set("Shades", Teuchos::Array<std::string>(Teuchos::tuple<std::string>("none")));
  user.set("Colour", std::string("Blue"));
  user.sublist("Brush").set("Soft", true);
  user.sublist("Recipe").set("Oil", 7);
  const Paint paint = read(user);
  EXPECT_EQ(paint.thickness, 0.75);
  EXPECT_EQ(paint.layers, 5);
  EXPECT_FALSE(paint.glossy);
  EXPECT_EQ(paint.maker, "us");
  EXPECT_EQ(paint.mixture, (std::vector<double>{1, 2, 3}));
  EXPECT_TRUE(paint.codes.empty());
  EXPECT_EQ(paint.shades, std::vector<std::string>{"none"});
  EXPECT_EQ(paint.colour, Colour::Blue);
  EXPECT_TRUE(paint.brush.soft);
  EXPECT_EQ(paint.brush.width, 3);
  EXPECT_EQ(paint.recipe.get<int>("Oil"), 7);
}

TEST(OptionsTest, ListsOfOtherWordsAreNotCompleted) {
  const ParameterList near = validated(least(), options().list());
  EXPECT_FALSE(near.isSublist("Far"));
  ParameterList user = least();
  user.set("Shop", std::string("Far"));
  EXPECT_EQ(validated(user, options().list()).sublist("Far").get<double>("Width"), 3);
  user.sublist("Far").set("Width", 8.0);
  const Paint paint = read(user);
  EXPECT_EQ(paint.shop, Shop::Far);
  EXPECT_EQ(paint.far.width, 8);
}

TEST(OptionsTest, ListsLeftOutKeepTheMembersDefault) {
  struct Wide : Paint {
    Wide() { far.width = 20; }
  };
  Options<Wide> wide;
  wide.choose_list("Shop", &Wide::shop, {{"Near", Shop::Near}, {"Far", Shop::Far}}, "Where it is sold.")
      .sublist("Far", &Wide::far, brush_options(), "The brush that the far shop sells.");
  const ParameterList complete = validated({}, wide.list());
  EXPECT_EQ(wide.read(SceneNode(complete, "Paint")).far.width, 20);
}

TEST(OptionsTest, OnlyWhatBelongsToOtherWordsMayBeMissing) {
  Options<Paint> tins;
  tins.choose_one("Shop", &Paint::shop, {{"Near", Shop::Near}, {"Far", Shop::Far}},
                  {{"Near", {"Layers"}}, {"Far", {"Price"}}}, "Where it is sold.")
      .add("Layers", &Paint::layers, "Number of layers.")
      .require("Price", &Paint::price, "Price of a tin.", greater_than(0))
      .add("Glossy", &Paint::glossy, "Whether it shines.");
  ParameterList complete = validated({}, tins.list());
  EXPECT_FALSE(complete.isParameter("Price"));
  EXPECT_EQ(tins.read(SceneNode(complete, "Paint")).price, 0);
  complete.remove("Glossy");
  EXPECT_THROW(tins.read(SceneNode(complete, "Paint")), std::exception) << "a list that was not validated";
  complete = validated(least(), options().list());
  complete.remove("Price");
  EXPECT_THROW(options().read(SceneNode(complete, "Paint")), std::exception);
}

TEST(OptionsTest, WhatIsRequiredMustBeGiven) {
  test::expect_contains(test::refusal([] { read({}); }), "Price is missing: Price of a tin.");
}

TEST(OptionsTest, ValuesOutOfRangeAreRefused) {
  test::expect_contains(refusal_of("Thickness", 0.0), "Thickness: 0 is not allowed");
  test::expect_contains(refusal_of("Layers", 10), "Layers: 10 is not allowed");
  test::expect_contains(refusal_of("Price", -1.0), "Price: -1 is not allowed");
  ParameterList brush;
  brush.set("Width", 0.0);
  test::expect_contains(refusal_of("Brush", brush), "Brush/Width: 0 is not allowed");
  test::expect_contains(refusal_of("Mixture", Teuchos::Array<double>(Teuchos::tuple(1.0, -2.0))), "Mixture: ");
}

TEST(OptionsTest, OtherWordsAreRefused) {
  test::expect_contains(refusal_of("Colour", std::string("Blu")),
                        "did you mean \"Blue\"? Allowed: \"Red\", \"Green\", \"Blue\"");
}

}  // namespace
}  // namespace ixos
