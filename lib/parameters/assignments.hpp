/// Everything that "List/Sublist/Name=value" can begin with.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

namespace ixos {

/// Returns a line for each parameter of a list of valid ones, in their order: "List/Name=<type>", or a line
/// "List/Name=word" for each word of a choice and for true and false. Names that the user chooses stand as any_name; a
/// free-form list is one line that ends with its slash.
std::vector<std::string> assignments(const Teuchos::ParameterList& valid);

}  // namespace ixos
