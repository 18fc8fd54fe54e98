/// Names of the blocks and sets of a mesh that a program provides.
#pragma once
#include <fmt/format.h>

#include <set>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace ixos {

/// Throws InputError if a name is empty or given twice. `what`: "block", "node set" or "side set".
template <class Named>
void check_names(const std::vector<Named>& all, const char* what) {
  std::set<std::string> names;
  for (const Named& one : all) {
    if (one.name.empty()) throw InputError(fmt::format("a {} has an empty name", what));
    if (!names.insert(one.name).second) throw InputError(fmt::format("two {}s have the name \"{}\"", what, one.name));
  }
}

}  // namespace ixos
