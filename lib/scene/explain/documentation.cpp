#include "scene/explain/documentation.hpp"

#include <fmt/format.h>

#include <Teuchos_StandardParameterEntryValidators.hpp>
#include <cmath>
#include <functional>
#include <map>
#include <vector>

#include "base/closest_name.hpp"
#include "base/error.hpp"
#include "parameters/parameter_entries.hpp"
#include "parameters/parameter_text.hpp"
#include "parameters/range_validator.hpp"
#include "parameters/validation.hpp"
#include "scene/read/parameters.hpp"
#include "scene/scene_file.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;

std::string default_text(const Teuchos::ParameterEntry& entry) {
  if (is_required(entry)) return "must be given";
  if (entry.isType<std::string>()) return "\"" + Teuchos::getValue<std::string>(entry) + "\"";
  return short_text(entry);
}

/// Returns the rows of the table of a list's parameters.
std::string table_rows(const List& valid) {
  std::string rows;
  for (const auto& [name, entry] : entries(valid))
    if (!entry.isList() && !is_free_form(valid))
      rows += fmt::format("| {} | {} | {} | {} | {} |\n", name, type_name(entry), default_text(entry), allowed(entry),
                          entry.docString());
  return rows;
}

std::string table(const std::string& rows) {
  if (rows.empty()) return "";
  return "| parameter | type | default | allowed | meaning |\n|---|---|---|---|---|\n" + rows + "\n";
}

/// A sublist of a valid list.
struct DocumentedList {
  const List& list;
  std::string name, sentence, heading;
  int depth;
};

/// Calls visit(DocumentedList) for the sublists of a list, at all depths.
void for_each_list(const List& valid, const std::string& heading, int depth,
                   const std::function<void(const DocumentedList&)>& visit) {
  for (const auto& [name, entry] : entries(valid)) {
    if (!entry.isList()) continue;
    const std::string word = name == any_name ? fmt::format("`{}`", name) : name;  // HTML, if it is not marked as code
    const std::string here = heading.empty() ? word : fmt::format("{} / {}", heading, word);
    visit({valid.sublist(name), name, entry.docString(), here, depth});
    for_each_list(valid.sublist(name), here, depth + 1, visit);
  }
}

/// Returns the documentation of a list and its sublists. Where several lists have one name and one table,
/// the one least deep has it, and the others refer to that one.
std::string documented(const List& valid) {
  std::map<std::string, std::pair<int, std::string>> homes;  // by name and table: the depth and the heading
  for_each_list(valid, "", 0, [&](const DocumentedList& own) {
    const auto [before, fresh] = homes.insert({own.name + table_rows(own.list), {own.depth, own.heading}});
    if (!fresh && own.depth < before->second.first) before->second = {own.depth, own.heading};
  });
  std::string text = table(table_rows(valid));
  for_each_list(valid, "", 0, [&](const DocumentedList& own) {
    text += fmt::format("## {}\n\n", own.heading);
    const std::string rows = table_rows(own.list), &home = homes.at(own.name + rows).second;
    if (!own.sentence.empty()) text += own.sentence + "\n\n";
    if (!rows.empty() && home != own.heading)
      text += "The parameters are those of " + home + ".\n\n";
    else
      text += table(rows);
    if (is_free_form(own.list))
      text += "Free form: Ixos does not check the names in this list; what reads the list checks them.\n\n";
  });
  return text;
}

std::string xml_escaped(const std::string& text) {
  std::string result;
  for (char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

/// Returns the text for an XML comment, which must not hold two dashes in a row.
std::string comment(const std::string& text) {
  std::string result;
  for (char c : text) result += c == '-' && !result.empty() && result.back() == '-' ? " -" : std::string(1, c);
  return result;
}

std::string comment(const Teuchos::ParameterEntry& valid) {
  const std::string range = allowed(valid);
  return comment(valid.docString() + (range.empty() ? "" : " Allowed: " + range));
}

void write(const List& list, const List& valid, const std::string& indent, std::string& text) {
  for (const auto& [name, entry] : entries(list)) {
    if (entry.isList()) continue;
    const Teuchos::ParameterEntry* known = is_free_form(valid) ? nullptr : valid.getEntryPtr(name);
    if (known != nullptr) text += fmt::format("{}<!-- {} -->\n", indent, comment(*known));
    text += fmt::format("{}<Parameter name=\"{}\" type=\"{}\" value=\"{}\"/>\n", indent, xml_escaped(name),
                        type_name(entry), xml_escaped(short_text(entry)));
  }
  for (const auto& [name, entry] : entries(list)) {
    if (!entry.isList()) continue;
    const List* inner = valid_sublist(valid, name, name);
    const Teuchos::ParameterEntry* known = valid.getEntryPtr(name);
    if (known != nullptr && !known->docString().empty())
      text += fmt::format("\n{}<!-- {} -->\n", indent, comment(known->docString()));
    text += fmt::format("{}<ParameterList name=\"{}\">\n", indent, xml_escaped(name));
    if (inner != nullptr) write(list.sublist(name), *inner, indent + "  ", text);
    text += indent + "</ParameterList>\n";
  }
}

/// Returns the settings of the templates that differ from the defaults.
const std::map<std::string, std::vector<std::string>>& template_settings() {
  static const std::map<std::string, std::vector<std::string>> settings{
      {"ball",
       {"Mesh/Type=Disk", "Mesh/Disk/Center={0, 7.254709287789268}", "Materials/Ball/Block=body",
        "Interactions/Wall/Side Set=surface", "Time Integrator/Type=Average Vector Field",
        "Time Integrator/Time Step Control/Final Time=1", "Time Integrator/Time Step Control/Time Step=0.001",
        "Output/Fields Interval=20"}},
      {"block",
       {"Mesh/Type=Box", "Mesh/Box/Dimension=3", "Mesh/Box/Lengths={4, 4, 2}", "Mesh/Box/Divisions={8, 8, 4}",
        "Materials/Rubber/Block=body", "Materials/Rubber/Stiffness Damping=0.0001", "Interactions/Wall/Side Set=bottom",
        "Interactions/Wall/Point={0, 0, -0.5}", "Interactions/Wall/Normal={0, 0, 1}",
        "Boundary Conditions/Held/Node Set=left", "Boundary Conditions/Held/Components=xy",
        "Initial Conditions/Velocity={0, 0, -1}", "Time Integrator/Time Step Control/Final Time=0.2",
        "Time Integrator/Time Step Control/Time Step=0.002", "Output/Fields Interval=10"}}};
  return settings;
}

}  // namespace

std::string allowed(const Teuchos::ParameterEntry& valid) {
  const auto validator = valid.validator();
  if (const auto range = Teuchos::rcp_dynamic_cast<const RangeValidator>(validator); !range.is_null())
    return range->words();
  if (validator.is_null() || validator->validStringValues().is_null()) return "";
  const auto& words = *validator->validStringValues();
  return quoted_list({words.begin(), words.end()});
}

std::string parameter_documentation(const List& valid, const std::string& title, const std::string& command) {
  std::string text = fmt::format(
      "# {}\n\n`{}` generates this page; do not edit it. Lengths are in L0, stresses in E0, times in T0. `<any name>` "
      "stands for a name that the file chooses.\n\n",
      title, command);
  text += documented(valid);
  return text.substr(0, text.size() - 1);
}

std::vector<std::string> template_names() {
  std::vector<std::string> names;
  for (const auto& [name, settings] : template_settings()) names.push_back(name);
  return names;
}

std::string scene_template(const std::string& name) {
  const auto found = template_settings().find(name);
  if (found == template_settings().end()) {
    const std::vector<std::string> names = template_names();
    throw InputError("there is no template \"" + name + "\"; did you mean \"" + closest_name(name, names) +
                     "\"? There are " + quoted_list(names));
  }
  List scene(name);
  for (const std::string& setting : found->second) set_parameter(scene, scene_parameters(), setting);
  scene = validated(scene, scene_parameters());
  scene.sublist("Linear Solver").set("Linear Solver Type", "Automatic");
  std::string text = fmt::format(
      "<!-- Run this scene with: ixos FILE. It lists every parameter that it uses. Most of them have the default value "
      "and can be omitted. -->\n<ParameterList name=\"{}\">\n",
      name);
  write(scene, scene_parameters(), "  ", text);
  return text + "</ParameterList>\n";
}

}  // namespace ixos
