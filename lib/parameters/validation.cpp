#include "parameters/validation.hpp"

#include <Teuchos_StandardParameterEntryValidators.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "base/closest_name.hpp"
#include "base/error.hpp"
#include "parameters/one_of.hpp"
#include "parameters/parameter_entries.hpp"
#include "parameters/parameter_text.hpp"

namespace ixos {

const char* const required = "<required>";

namespace {

const char* const free_form = "<free form>";
const char* const like_root = "<like root>";

using List = Teuchos::ParameterList;
using Entry = Teuchos::ParameterEntry;

std::string join(const std::string& path, const std::string& name) { return path.empty() ? name : path + "/" + name; }

[[noreturn]] void refuse_name(const List& valid, const std::string& name, const std::string& path, bool sublist) {
  std::vector<std::string> names;
  for (const auto& [key, entry] : entries(valid))
    if (entry.isList() == sublist) names.push_back(key);
  const std::string what = sublist ? "list" : "parameter";
  std::string message = path + ": there is no " + what + " \"" + name + "\" here";
  if (names.empty()) throw InputError(message + "; no " + what + " is allowed");
  throw InputError(message + "; did you mean \"" + closest_name(name, names) + "\"? Allowed: " + quoted_list(names));
}

/// Copies `value` to `target`, checked against the valid entry.
void check_entry(const std::string& name, const Entry& value, const Entry& valid, const std::string& path,
                 List& target) {
  const std::string wanted = type_name(valid);
  const std::string found = type_name(value);
  if (wanted == "double" && found == "int")
    target.set(name, static_cast<double>(Teuchos::getValue<int>(value)));
  else if (wanted == found)
    target.setEntry(name, Entry(value.getAny(false)));
  else
    throw InputError(path + ": " + value_text(value) + " is of type " + found + ", but it must be of type " + wanted);
  if (valid.validator().is_null()) return;
  const Entry& checked = *target.getEntryPtr(name);
  if (const auto words = Teuchos::rcp_dynamic_cast<const Teuchos::StringValidator>(valid.validator());
      !words.is_null()) {
    const auto& allowed = *words->validStringValues();
    const std::vector<std::string> names(allowed.begin(), allowed.end());
    const auto& word = Teuchos::getValue<std::string>(checked);
    if (std::find(names.begin(), names.end(), word) == names.end())
      throw InputError(path + ": \"" + word + "\" does not exist; did you mean \"" + closest_name(word, names) +
                       "\"? Allowed: " + quoted_list(names));
    return;
  }
  try {
    valid.validator()->validate(checked, name, path);
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

/// The choice that leaves out a name, and the word that the user chose.
struct LeftOut {
  std::string name;
  const Choice* choice;
  std::string word;
};

/// Returns the choices of a list by the names that they leave out.
std::map<std::string, LeftOut> left_out(const List& user, const List& valid, const std::string& path) {
  std::map<std::string, LeftOut> result;
  for (const auto& [name, entry] : entries(valid)) {
    const Choice* choice = choice_behind(entry.validator());
    if (choice == nullptr || result.count(name) > 0) continue;  // an earlier choice leaves out this one
    List checked;
    check_entry(name, user.isParameter(name) ? user.getEntry(name) : entry, entry, join(path, name), checked);
    const auto& word = checked.get<std::string>(name);
    for (const std::string& other : choice->left_out(word)) result.insert({other, {name, choice, word}});
  }
  return result;
}

[[noreturn]] void refuse_left_out(const std::string& name, const LeftOut& why, const std::string& path) {
  std::string owners;
  for (const std::string& word : why.choice->owners(name)) owners += (owners.empty() ? "\"" : " or \"") + word + "\"";
  throw InputError((path.empty() ? "" : path + ": ") + "\"" + name + "\" belongs to " + why.name + " " + owners +
                   ", but " + why.name + " is \"" + why.word + "\"; remove it, or set " + why.name + " to " + owners);
}

/// Fills in the complete list in the order of the valid one.
void fill(const List& user, const List& valid, const std::string& path, List& complete) {
  if (is_free_form(valid) || is_like_root(valid)) {
    complete.setParameters(user);
    return;
  }
  for (const auto& [name, value] : entries(user)) {
    const std::string here = join(path, name);
    if (value.isList())
      valid_sublist(valid, name, here);
    else
      valid_entry(valid, name, here);
  }
  const std::map<std::string, LeftOut> absent = left_out(user, valid, path);
  for (const auto& [name, why] : absent)
    if (why.choice->exclusive && user.isParameter(name)) refuse_left_out(name, why, path);
  for (const auto& [name, entry] : entries(valid)) {
    if (entry.isList() || absent.count(name) > 0) continue;
    if (user.isParameter(name))
      check_entry(name, user.getEntry(name), entry, join(path, name), complete);
    else if (is_required(entry))
      throw InputError(join(path, name) + " is missing: " + entry.docString());
    else
      complete.setEntry(name, Entry(entry.getAny(false)));
  }
  for (const auto& [name, entry] : entries(valid)) {
    if (!entry.isList() || name == any_name || (!user.isSublist(name) && absent.count(name) > 0)) continue;
    fill(user.isSublist(name) ? user.sublist(name) : List(), valid.sublist(name), join(path, name),
         complete.sublist(name));
  }
  for (const auto& [name, value] : entries(user))
    if (value.isList() && !valid.isSublist(name))
      fill(user.sublist(name), valid.sublist(any_name), join(path, name), complete.sublist(name));
}

}  // namespace

void set_required(List& valid, const std::string& name, const std::string& documentation,
                  const Teuchos::RCP<const Teuchos::ParameterEntryValidator>& validator) {
  valid.set(name, std::numeric_limits<double>::quiet_NaN(), documentation);
  valid.getEntry(name).setValidator(validator);
}

bool is_required(const Entry& entry) {
  if (entry.isType<std::string>()) return Teuchos::getValue<std::string>(entry) == required;
  return entry.isType<double>() && std::isnan(Teuchos::getValue<double>(entry));
}

void mark_free_form(List& list) { list.set(free_form, true); }

bool is_free_form(const List& valid) { return valid.isParameter(free_form); }

void mark_like_root(List& list) { list.setName(like_root); }  // no entry, which would count as a parameter

bool is_like_root(const List& valid) { return valid.name() == like_root; }

const List& lists_of(const List& valid, const List& root) { return is_like_root(valid) ? root : valid; }

void discard_left_out(List& user, const List& valid, const std::string& choice) {
  const Choice* behind = choice_behind(valid.getEntry(choice).validator());
  if (behind == nullptr || !behind->exclusive) return;
  for (const std::string& name : behind->left_out(user.get<std::string>(choice))) user.remove(name, false);
}

const List* valid_sublist(const List& valid, const std::string& name, const std::string& path) {
  if (is_free_form(valid)) return nullptr;
  if (valid.isSublist(name)) return &valid.sublist(name);
  if (valid.isSublist(any_name)) return &valid.sublist(any_name);
  if (valid.isParameter(name)) throw InputError(path + " is a parameter, not a list");
  refuse_name(valid, name, path, true);
}

const Entry& valid_entry(const List& valid, const std::string& name, const std::string& path) {
  const Entry* entry = valid.getEntryPtr(name);
  if (entry != nullptr && entry->isList()) throw InputError(path + " is a list, not a parameter");
  if (entry == nullptr) refuse_name(valid, name, path, false);
  return *entry;
}

List validated(const List& user, const List& valid) {
  List complete(user.name());
  fill(user, valid, "", complete);
  return complete;
}

}  // namespace ixos
