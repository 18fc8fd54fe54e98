/// Checks that every entry of every catalogue must pass.
#pragma once
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "parameters/catalogue.hpp"
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

/// Walks over the catalogue: an entry is documented, its defaults are valid and come back from XML, and each parameter
/// changes what make(list, entry) returns: numbers that tell two products apart. `texts`: values of parameters that
/// are texts. `unused`: parameters that do nothing by default, as "Entry/Parameter".
template <class Entry, class Make>
void walk(const Catalogue<Entry>& catalogue, const Teuchos::ParameterList& texts, const std::set<std::string>& unused,
          const Make& make) {
  Teuchos::ParameterList valid("Walk");
  catalogue.declare(valid);
  std::set<std::string> names;
  for (const Entry& entry : catalogue.entries()) {
    SCOPED_TRACE(entry.name);
    EXPECT_TRUE(names.insert(entry.name).second) << "two entries of one name";
    ASSERT_FALSE(entry.sentence.empty());
    EXPECT_EQ(entry.sentence.back(), '.');

    Teuchos::ParameterList user("Walk");
    user.set(catalogue.choice(), entry.name);
    Teuchos::ParameterList& own = entry.in_place ? user : user.sublist(entry.name);
    for (const auto& [name, parameter] : entries(entry.parameters)) {
      EXPECT_FALSE(parameter.docString().empty()) << name;
      if (parameter.template isType<double>()) {
        EXPECT_FALSE(parameter.validator().is_null()) << name << " has no range";
      }
      if (texts.isParameter(name) && parameter.template isType<std::string>()) {
        own.set(name, texts.get<std::string>(name));
        continue;
      }
      if (!is_required(parameter) || unused.count(entry.name + "/" + name) > 0) continue;
      own.set(name, std::nan(""));
      vary(own, name, parameter);
    }
    const Teuchos::ParameterList complete = validated(user, valid);
    const Teuchos::ParameterList back = validated(read_scene_text(scene_text(complete), "round trip"), valid);
    EXPECT_TRUE(complete == back);
    const std::vector<double> before = make(complete, entry);
    EXPECT_FALSE(before.empty());
    for (const auto& [name, parameter] : entries(entry.parameters)) {
      Teuchos::ParameterList changed = complete;
      if (unused.count(entry.name + "/" + name) > 0 ||
          !vary(entry.in_place ? changed : changed.sublist(entry.name), name, parameter))
        continue;
      EXPECT_NE(make(validated(changed, valid), entry), before) << name << " changes nothing";
    }
  }
}

}  // namespace ixos::test
