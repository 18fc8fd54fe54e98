#include "study/advice/advice_lists.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "parameters/parameter_entries.hpp"

namespace ixos {

using List = Teuchos::ParameterList;

std::vector<std::string> list_names(const List& lists) {
  std::vector<std::string> names;
  for (const auto& [name, entry] : entries(lists))
    if (entry.isList() && name.find_first_of("=/") == std::string::npos) names.push_back(name);
  return names;
}

Assignments in_all(const std::string& path, const std::vector<std::string>& names, const std::string& setting) {
  Assignments result;
  result.reserve(names.size());
  for (const std::string& name : names) result.push_back(fmt::format("{}/{}/{}", path, name, setting));
  return result;
}

bool all_are(const List& lists, const std::vector<std::string>& names, const char* entry,
             const std::vector<std::string>& words) {
  return !names.empty() && std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    const std::string value = lists.sublist(name).get<std::string>(entry);
    return value == lists.sublist(names.front()).get<std::string>(entry) &&
           std::find(words.begin(), words.end(), value) != words.end();
  });
}

}  // namespace ixos
