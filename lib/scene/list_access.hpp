/// Reading validated lists: the few helpers that all readers of a scene share.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace ixos {

/// The names of a list's sublists, in order.
std::vector<std::string> sublists(const Teuchos::ParameterList& list);

/// An array of `count` numbers, or `fallback` where the user gave none. Throws InputError with the path.
std::vector<double> numbers(const Teuchos::ParameterList& list, const std::string& path, const char* name,
                            std::size_t count, std::vector<double> fallback);

/// Throws InputError, with the path, for a name that cannot head a column of comma-separated values.
void check_column_name(const std::string& path, const std::string& name);

/// Puts the list path before a message of the layers below.
template <class Function>
auto at(const std::string& path, const Function& function) {
  try {
    return function();
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

}  // namespace ixos
