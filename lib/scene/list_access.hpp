/// Reading validated lists: the few helpers that all readers of a scene share.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace ixos {

/// Returns the names of a list's sublists, in order.
std::vector<std::string> sublists(const Teuchos::ParameterList& list);

/// Returns an array of `count` numbers, or `fallback` if the user gave none. Throws InputError with the path.
std::vector<double> numbers(const Teuchos::ParameterList& list, const std::string& path, const char* name,
                            std::size_t count, std::vector<double> fallback);

/// Throws InputError, with the path, for a name that cannot head a column of comma-separated values.
void check_column_name(const std::string& path, const std::string& name);

/// Calls a function, and puts the list path before the message of an InputError that it throws.
template <class Function>
auto at(const std::string& path, const Function& function) {
  try {
    return function();
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

}  // namespace ixos
