/// Iteration over a Teuchos parameter list, and the name that stands for any name in a list of valid parameters.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>
#include <utility>
#include <vector>

namespace ixos {

/// In a list of valid parameters, the name of a sublist that stands for any number of sublists of any names.
inline constexpr const char* any_name = "<any name>";

/// Returns names and entries of a list, in order, for structured bindings. They are valid until the list changes.
inline std::vector<std::pair<const std::string&, const Teuchos::ParameterEntry&>> entries(
    const Teuchos::ParameterList& list) {
  std::vector<std::pair<const std::string&, const Teuchos::ParameterEntry&>> result;
  for (const auto& item : list) result.emplace_back(item.first, item.second);
  return result;
}

}  // namespace ixos
