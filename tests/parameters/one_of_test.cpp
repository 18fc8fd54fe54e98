#include "parameters/one_of.hpp"

#include <gtest/gtest.h>

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>
#include <stdexcept>

#include "parameters/range_validator.hpp"
#include "parameters/validation.hpp"

namespace ixos {
namespace {

using Teuchos::ParameterList;
using Validator = Teuchos::RCP<const Teuchos::ParameterEntryValidator>;

const std::vector<std::string> words{"North", "South", "North Pole"};

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

TEST(OneOfTest, OnlyAChoiceIsAChoice) {
  EXPECT_TRUE(is_choice(choice_of(words)));
  EXPECT_FALSE(is_choice(one_of(words)));
  EXPECT_FALSE(is_choice(any_number()));
  EXPECT_FALSE(is_choice(Teuchos::null));
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

}  // namespace
}  // namespace ixos
