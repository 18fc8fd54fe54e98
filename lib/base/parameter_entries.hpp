/// Iteration over a Teuchos parameter list.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>
#include <utility>
#include <vector>

namespace ixos {

/// Names and entries of a list, in order, for structured bindings. Valid as long as the list is not changed.
inline std::vector<std::pair<const std::string&, const Teuchos::ParameterEntry&>> entries(
    const Teuchos::ParameterList& list) {
  std::vector<std::pair<const std::string&, const Teuchos::ParameterEntry&>> result;
  for (const auto& item : list) result.emplace_back(item.first, item.second);
  return result;
}

}  // namespace ixos
