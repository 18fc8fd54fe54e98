#include "scene/list_access.hpp"

#include <fmt/format.h>

#include <Teuchos_Array.hpp>

#include "base/parameter_entries.hpp"

namespace ixos {

std::vector<std::string> sublists(const Teuchos::ParameterList& list) {
  std::vector<std::string> names;
  for (const auto& [name, entry] : entries(list))
    if (entry.isList()) names.push_back(name);
  return names;
}

std::vector<double> numbers(const Teuchos::ParameterList& list, const std::string& path, const char* name,
                            std::size_t count, std::vector<double> fallback) {
  const auto& values = list.get<Teuchos::Array<double>>(name);
  if (values.empty()) return fallback;
  if (static_cast<std::size_t>(values.size()) != count)
    throw InputError(fmt::format("{}/{} has {} elements, not {}, which the dimension of the mesh requires", path, name,
                                 values.size(), count));
  return {values.begin(), values.end()};
}

void check_column_name(const std::string& path, const std::string& name) {
  if (name.find_first_of(",\"\r\n") != std::string::npos)
    throw InputError(
        fmt::format("{}: \"{}\" cannot name a column: it contains a comma, a quote or a line break", path, name));
}

}  // namespace ixos
