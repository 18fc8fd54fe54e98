#include "parameters/one_of.hpp"

#include <gtest/gtest.h>

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>
#include <stdexcept>

#include "parameters/range_validator.hpp"
#include "parameters/validation.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

using Teuchos::ParameterList;
using Validator = Teuchos::RCP<const Teuchos::ParameterEntryValidator>;

const std::vector<std::string> words{"North", "South", "North Pole"};
/// Ships have a draught, at sea and on rivers.
const std::vector<Choice::Word> ways{{"Sea", {"Sea", "Draught"}}, {"River", {"Draught", "Bank"}}, {"Road", {}}};

template <class T>
bool accepts(const Validator& validator, const T& value) {
  try {
    validator->validate(Teuchos::ParameterEntry(value), "Direction", "Scene");
  } catch (const std::logic_error&) {  // Teuchos' own errors
    return false;
  }
  return true;
}

TEST(OneOfTest, AcceptsTheWordsOnly) {
  for (const Validator& validator : {one_of(words), choice_of(words)}) {
    for (const std::string& word : words) EXPECT_TRUE(accepts(validator, word)) << word;
    for (const char* word : {"", "Nort", "north", "North ", "East"})
      EXPECT_FALSE(accepts(validator, std::string(word))) << word;
    EXPECT_FALSE(accepts(validator, 1));
  }
}

TEST(OneOfTest, TellsTheWordsInTheirOrder) {
  for (const Validator& validator : {one_of(words), choice_of(words)})
    EXPECT_EQ(Teuchos::Array<std::string>(*validator->validStringValues()).toVector(), words);
}

TEST(OneOfTest, OnlyAChoiceHasAChoiceBehindIt) {
  ASSERT_NE(choice_behind(choice_of(words)), nullptr);
  EXPECT_FALSE(choice_behind(choice_of(words))->exclusive);
  ASSERT_NE(choice_behind(exclusive_choice_of(ways)), nullptr);
  EXPECT_TRUE(choice_behind(exclusive_choice_of(ways))->exclusive);
  EXPECT_EQ(choice_behind(one_of(words)), nullptr);
  EXPECT_EQ(choice_behind(any_number()), nullptr);
  EXPECT_EQ(choice_behind(Teuchos::null), nullptr);
}

TEST(ChoiceTest, KnowsWhatBelongsToItsWords) {
  const Validator validator = exclusive_choice_of(ways);
  const Choice& choice = *choice_behind(validator);
  EXPECT_EQ(choice.belongings("River"), (std::vector<std::string>{"Draught", "Bank"}));
  EXPECT_EQ(choice.belongings("Road"), std::vector<std::string>());
  EXPECT_EQ(choice.left_out("River"), std::vector<std::string>{"Sea"});
  EXPECT_EQ(choice.left_out("Road"), (std::vector<std::string>{"Sea", "Draught", "Bank"}));
  EXPECT_EQ(choice.left_out("Air"), std::vector<std::string>()) << "is no word";
  EXPECT_EQ(choice.owners("Draught"), (std::vector<std::string>{"Sea", "River"}));
  EXPECT_EQ(choice.owners("Wings"), std::vector<std::string>());
}

/// A parameter with that validator, a sublist for each of two of its words, and one for no word.
ParameterList valid_list(const Validator& validator) {
  ParameterList list;
  list.set("Direction", std::string("North"), "Where to go.", validator);
  for (const char* name : {"North", "South", "East"}) list.sublist(name).set("Distance", 1.5);
  return list;
}

std::string filled_in(const ParameterList& user, const Validator& validator) {
  const ParameterList complete = validated(user, valid_list(validator));
  std::string names;
  for (const char* name : {"North", "South", "East"})
    if (complete.isSublist(name) && complete.sublist(name).isParameter("Distance")) names += name[0];
  return names;
}

TEST(OneOfTest, OfTheSublistsThatAChoiceOffersTheChosenOneIsFilledIn) {
  ParameterList south;
  south.set("Direction", std::string("South"));
  EXPECT_EQ(filled_in({}, choice_of(words)), "NE");
  EXPECT_EQ(filled_in(south, choice_of(words)), "SE");
  EXPECT_EQ(filled_in(south, one_of(words)), "NSE");
  // The user's own lists stay, chosen or not.
  south.sublist("North");
  EXPECT_EQ(filled_in(south, choice_of(words)), "NSE");
}

/// A list with an exclusive choice and all that belongs to its words.
ParameterList valid_way() {
  ParameterList list;
  list.set("Way", std::string("Road"), "Where to go.", exclusive_choice_of(ways));
  list.set("Draught", 2.5, "Depth of the keel.", greater_than(0));
  list.set("Bank", required, "Which one.");
  list.sublist("Sea").set("Waves", true);
  list.set("Distance", 1.5);
  return list;
}

ParameterList way(const std::string& word) {
  ParameterList user;
  user.set("Way", word);
  return user;
}

std::string names(const ParameterList& list) {
  std::string result;
  for (const auto& item : list) result += item.first + " ";
  return result;
}

TEST(ExclusiveChoiceTest, OnlyWhatBelongsToTheChosenWordIsFilledIn) {
  EXPECT_EQ(names(validated({}, valid_way())), "Way Distance ");
  EXPECT_EQ(names(validated(way("Sea"), valid_way())), "Way Draught Distance Sea ");
  EXPECT_TRUE(validated(way("Sea"), valid_way()).sublist("Sea").get<bool>("Waves"));
  ParameterList river = way("River");
  river.set("Bank", std::string("left"));
  river.set("Draught", 1.5);
  EXPECT_EQ(names(validated(river, valid_way())), "Way Draught Bank Distance ");
  EXPECT_EQ(validated(river, valid_way()).get<double>("Draught"), 1.5);
  test::expect_contains(test::refusal([] { validated(way("River"), valid_way()); }), "Bank is missing");
}

TEST(ExclusiveChoiceTest, WhatBelongsToOtherWordsOnlyIsRefused) {
  const auto refusal = [](ParameterList user) { return test::refusal([&] { validated(user, valid_way()); }); };
  ParameterList sea = way("Sea");
  sea.set("Bank", std::string("left"));
  EXPECT_EQ(refusal(sea), "\"Bank\" belongs to Way \"River\", but Way is \"Sea\"; remove it, or set Way to \"River\"");
  ParameterList road;
  road.set("Draught", 1.0);
  EXPECT_EQ(refusal(road),
            "\"Draught\" belongs to Way \"Sea\" or \"River\", but Way is \"Road\"; remove it, or set Way to \"Sea\" "
            "or \"River\"");
  ParameterList list;
  list.sublist("Sea");
  EXPECT_EQ(refusal(list), "\"Sea\" belongs to Way \"Sea\", but Way is \"Road\"; remove it, or set Way to \"Sea\"");
}

TEST(ExclusiveChoiceTest, AWordThatDoesNotExistIsRefusedFirst) {
  ParameterList user = way("Rivr");
  user.sublist("Sea");
  test::expect_contains(test::refusal([&] { validated(user, valid_way()); }), "did you mean \"River\"?");
}

TEST(ExclusiveChoiceTest, AChoiceMayBelongToAWordOfAnother) {
  ParameterList valid;
  valid.set("Way", std::string("Road"), "Where to go.", exclusive_choice_of({{"Road", {}}, {"Sea", {"Sail", "Oars"}}}));
  valid.set("Sail", std::string("One"), "How many.", exclusive_choice_of({{"One", {}}, {"None", {"Oars"}}}));
  valid.set("Oars", 2, "How many.");
  ParameterList sea = way("Sea");
  EXPECT_EQ(names(validated({}, valid)), "Way ");
  EXPECT_EQ(names(validated(sea, valid)), "Way Sail ");
  sea.set("Sail", std::string("None"));
  EXPECT_EQ(names(validated(sea, valid)), "Way Sail Oars ");
  sea.set("Way", std::string("Road"));
  test::expect_contains(test::refusal([&] { validated(sea, valid); }), "belongs to Way \"Sea\", but Way is \"Road\"");
}

TEST(ExclusiveChoiceTest, WhatIsCompleteIsValid) {
  for (const char* word : {"Sea", "Road"}) {
    const ParameterList complete = validated(way(word), valid_way());
    EXPECT_TRUE(validated(complete, valid_way()) == complete) << word;
  }
}

TEST(ExclusiveChoiceTest, WhatIsLeftOutCanBeDiscarded) {
  ParameterList user = way("River");
  user.set("Bank", std::string("left"));
  user.set("Draught", 1.0);
  user.set("Distance", 3.0);
  user.sublist("Sea");
  discard_left_out(user, valid_way(), "Way");
  EXPECT_EQ(names(user), "Way Bank Draught Distance ");
  discard_left_out(user, valid_way(), "Distance");
  EXPECT_EQ(names(user), "Way Bank Draught Distance ");
  user.set("Way", std::string("Rivr"));
  discard_left_out(user, valid_way(), "Way");
  EXPECT_EQ(names(user), "Way Bank Draught Distance ") << "a word that does not exist leaves nothing out";
  user.set("Way", std::string("Road"));
  discard_left_out(user, valid_way(), "Way");
  EXPECT_EQ(names(user), "Way Distance ");
}

}  // namespace
}  // namespace ixos
