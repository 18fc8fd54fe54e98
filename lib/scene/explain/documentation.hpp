/// Documentation made from the validators.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

namespace ixos {

/// Returns every list and parameter of `valid` as Markdown: type, default, what is allowed, meaning. It makes
/// docs/parameters.md from scene_parameters() and docs/study-parameters.md from study_parameters(). `command` is the
/// command that prints the text.
std::string parameter_documentation(const Teuchos::ParameterList& valid, const std::string& title,
                                    const std::string& command);

/// Returns the names that scene_template() accepts.
std::vector<std::string> template_names();

/// Returns a complete, commented scene that runs as it is: "ball" (two dimensions) or "block" (three). Throws
/// InputError with the nearest name.
std::string scene_template(const std::string& name);

/// Returns the values that an entry accepts, in words; empty if its type says all.
std::string allowed(const Teuchos::ParameterEntry& valid);

}  // namespace ixos
