/// Checks that every entry of every catalogue must pass.
#pragma once
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "parameters/catalogue.hpp"
#include "parameters/one_of.hpp"
#include "parameters/parameter_entries.hpp"
#include "parameters/range_validator.hpp"
#include "parameters/validation.hpp"
#include "scene/scene_file.hpp"

namespace ixos::test {

/// Returns the first of the candidates that the validator accepts and that is not `other`.
inline double another_number(const Teuchos::ParameterEntry& entry, double other,
                             const std::vector<double>& candidates) {
  const auto range = Teuchos::rcp_dynamic_cast<const RangeValidator>(entry.validator());
  for (const double candidate : candidates)
    if (candidate != other && std::isfinite(candidate) && (range.is_null() || range->contains(candidate)))
      return candidate;
  ADD_FAILURE() << "no other value is valid";
  return other;
}
inline double another_number(const Teuchos::ParameterEntry& entry, double other) {
  return another_number(entry, other, {1.1 * other, 0.9 * other, 0.37, 0.2, 1.7, 7.0});
}

/// Changes the value of a parameter to another valid one, and gives required ones a value. Returns false for texts
/// without a choice.
inline bool vary(Teuchos::ParameterList& list, const std::string& name, const Teuchos::ParameterEntry& valid) {
  if (valid.isType<double>()) {
    const double value = list.get<double>(name);
    list.set(name, another_number(valid, std::isnan(value) ? 0.0 : value));
  } else if (valid.isType<int>()) {
    const double value = list.get<int>(name);
    list.set(name, static_cast<int>(another_number(valid, value, {2 * value, value + 2, value + 1})));
  } else if (valid.isType<Teuchos::Array<double>>()) {
    auto values = list.get<Teuchos::Array<double>>(name);
    if (values.empty()) values = Teuchos::tuple<double>(0.6, 0.8);
    for (double& value : values) value = another_number(valid, value);
    list.set(name, values);
  } else if (valid.isType<Teuchos::Array<int>>()) {
    auto values = list.get<Teuchos::Array<int>>(name);
    for (int& value : values) ++value;
    list.set(name, values);
  } else {
    if (valid.validator().is_null() || valid.validator()->validStringValues().is_null()) return false;
    for (const std::string& word : *valid.validator()->validStringValues())
      if (word != list.get<std::string>(name)) {
        list.set(name, word);
        return true;
      }
  }
  return true;
}

/// Gives the required parameters of a list a value unless they are in `except`, where they belong to the words that the
/// list has chosen.
inline void fill_required(Teuchos::ParameterList& list, const Teuchos::ParameterList& valid,
                          const std::set<std::string>& except = {}) {
  std::set<std::string> left_out;
  for (const auto& [name, parameter] : entries(valid)) {
    const Choice* choice = choice_behind(parameter.validator());
    if (choice == nullptr || !choice->exclusive) continue;
    const auto& word = list.isParameter(name) ? list.get<std::string>(name) : valid.get<std::string>(name);
    for (const std::string& other : choice->left_out(word)) left_out.insert(other);
  }
  for (const auto& [name, parameter] : entries(valid)) {
    if (!is_required(parameter) || left_out.count(name) > 0 || except.count(name) > 0 || list.isParameter(name))
      continue;
    list.set(name, std::nan(""));
    vary(list, name, parameter);
  }
}

/// Returns the settings of all words of the list's exclusive choices but the default ones: pairs of a choice and a
/// word.
inline std::vector<std::pair<std::string, std::string>> other_words(const Teuchos::ParameterList& valid) {
  std::vector<std::pair<std::string, std::string>> result;
  for (const auto& [name, parameter] : entries(valid)) {
    const Choice* choice = choice_behind(parameter.validator());
    if (choice == nullptr || !choice->exclusive) continue;
    for (const Choice::Word& word : choice->words)
      if (word.name != valid.get<std::string>(name)) result.push_back({name, word.name});
  }
  return result;
}

/// Walks over the catalogue: an entry is documented, its defaults are valid and come back from XML, and each parameter
/// changes what make(list, entry) returns: numbers that tell two products apart. So it does for each word of a choice
/// to which parameters belong. `given`: values of parameters of that name and type that have no default. `unused`:
/// parameters that do nothing by default, as "Entry/Parameter".
template <class Entry, class Make>
void walk(const Catalogue<Entry>& catalogue, const Teuchos::ParameterList& given, const std::set<std::string>& unused,
          const Make& make) {
  Teuchos::ParameterList valid("Walk");
  catalogue.declare(valid);
  std::set<std::string> names;
  for (const Entry& entry : catalogue.entries()) {
    SCOPED_TRACE(entry.name);
    EXPECT_TRUE(names.insert(entry.name).second) << "two entries of one name";
    ASSERT_FALSE(entry.sentence.empty());
    EXPECT_EQ(entry.sentence.back(), '.');

    std::set<std::string> own_unused;
    for (const auto& [name, parameter] : entries(entry.parameters)) {
      if (unused.count(entry.name + "/" + name) > 0) own_unused.insert(name);
      EXPECT_FALSE(parameter.docString().empty()) << name;
      if (parameter.template isType<double>()) {
        EXPECT_FALSE(parameter.validator().is_null()) << name << " has no range";
      }
    }
    std::vector<std::pair<std::string, std::string>> words = other_words(entry.parameters);
    words.insert(words.begin(), {"", ""});
    for (const auto& [choice, word] : words) {
      SCOPED_TRACE(choice + " " + word);
      Teuchos::ParameterList user("Walk");
      user.set(catalogue.choice(), entry.name);
      Teuchos::ParameterList& own = entry.in_place ? user : user.sublist(entry.name);
      if (!choice.empty()) own.set(choice, word);
      for (const auto& [name, parameter] : entries(entry.parameters))
        if (given.isParameter(name) && given.getEntry(name).getAny().type() == parameter.getAny().type())
          own.setEntry(name, given.getEntry(name));
      fill_required(own, entry.parameters, own_unused);
      const Teuchos::ParameterList complete = validated(user, valid);
      const Teuchos::ParameterList back = validated(read_scene_text(scene_text(complete), "round trip"), valid);
      EXPECT_TRUE(complete == back);
      const std::vector<double> before = make(complete, entry);
      EXPECT_FALSE(before.empty());
      for (const auto& [name, parameter] : entries(entry.parameters)) {
        Teuchos::ParameterList changed = complete;
        Teuchos::ParameterList& list = entry.in_place ? changed : changed.sublist(entry.name);
        const Choice* chooses = choice_behind(parameter.validator());
        // The loop over words changes choices.
        if (!list.isParameter(name) || (chooses != nullptr && chooses->exclusive) || own_unused.count(name) > 0 ||
            !vary(list, name, parameter))
          continue;
        EXPECT_NE(make(validated(changed, valid), entry), before) << name << " changes nothing";
      }
    }
  }
}

}  // namespace ixos::test
