/// Documentation made from the validators.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>

namespace ixos {

/// Every list and parameter of `valid` as Markdown: type, default, what is allowed, meaning. docs/parameters.md is that
/// of scene_parameters(), docs/study-parameters.md that of study_parameters(). `command` prints it.
std::string parameter_documentation(const Teuchos::ParameterList& valid, const std::string& title,
                                    const std::string& command);

/// A complete, commented scene that runs as it is: "ball" (two dimensions) or "block" (three). Throws InputError with
/// the nearest name.
std::string scene_template(const std::string& name);

/// What an entry may hold, in words; empty where its type says all.
std::string allowed(const Teuchos::ParameterEntry& valid);

}  // namespace ixos
