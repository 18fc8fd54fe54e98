#include "parameters/catalogue.hpp"

#include <map>
#include <sstream>

#include "parameters/one_of.hpp"
#include "parameters/parameter_entries.hpp"
#include "parameters/parameter_text.hpp"

namespace ixos {
namespace {

/// Returns type, default, range and documentation as a text.
std::string declaration(const Teuchos::ParameterEntry& entry) {
  std::ostringstream text;
  text << type_name(entry) << ' ' << short_text(entry) << '\n' << entry.docString() << '\n';
  if (nonnull(entry.validator())) entry.validator()->printDoc("", text);
  return text.str();
}

[[noreturn]] void refuse(const std::string& choice, const std::string& why) {
  throw std::logic_error("the catalogue of \"" + choice + "\": " + why);
}

}  // namespace

void check_declared(const std::string& choice, const std::vector<DeclaredEntry>& entries) {
  std::map<std::string, std::string> taken{{choice, "the choice"}};  // names beside the choice, and whose they are
  const auto take = [&](const std::string& name, const std::string& owner) {
    const auto [before, added] = taken.insert({name, owner});
    if (!added) refuse(choice, "the name \"" + name + "\" belongs to " + before->second + " and to " + owner);
  };
  std::map<std::string, const DeclaredEntry*> names, owners;
  for (const DeclaredEntry& entry : entries) {
    if (!names.insert({entry.name, &entry}).second) refuse(choice, "two entries are \"" + entry.name + "\"");
    if (entry.has_sublist()) take(entry.name, "the list of \"" + entry.name + "\"");
    if (!entry.in_place) continue;
    for (const auto& [name, parameter] : ixos::entries(*entry.parameters)) {
      const auto [before, added] = owners.insert({name, &entry});
      if (added)
        take(name, "\"" + entry.name + "\"");
      else if (declaration(before->second->parameters->getEntry(name)) != declaration(parameter))
        refuse(choice, "\"" + before->second->name + "\" and \"" + entry.name + "\" declare \"" + name +
                           "\" with another type, default, range or documentation");
    }
  }
}

void declare_choice(Teuchos::ParameterList& list, const std::string& choice, const std::string& documentation,
                    const std::vector<DeclaredEntry>& entries) {
  std::vector<Choice::Word> words;
  std::string text = documentation;
  for (const DeclaredEntry& entry : entries) {
    Choice::Word word{entry.name, {}};
    if (entry.has_sublist())
      word.belongings = {entry.name};
    else
      text += " " + entry.documentation;
    if (entry.in_place)
      for (const auto& item : ixos::entries(*entry.parameters)) word.belongings.push_back(item.first);
    words.push_back(word);
  }
  std::vector<std::string> names{choice};
  for (const Choice::Word& word : words) names.insert(names.end(), word.belongings.begin(), word.belongings.end());
  for (const std::string& name : names)
    if (list.isParameter(name)) refuse(choice, "the list \"" + list.name() + "\" already has \"" + name + "\"");
  list.set(choice, entries.front().name, text, exclusive_choice_of(words));
  for (const DeclaredEntry& entry : entries) {
    if (entry.has_sublist()) {
      list.sublist(entry.name, false, entry.documentation) = *entry.parameters;
      list.sublist(entry.name).setName(entry.name);
    }
    if (entry.in_place)
      for (const auto& [name, parameter] : ixos::entries(*entry.parameters)) list.setEntry(name, parameter);
  }
}

}  // namespace ixos
