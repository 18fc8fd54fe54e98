/// Completion of commands in bash, made from the options of a program.
#pragma once
#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

namespace ixos {

/// Returns a script for bash that completes commands of the program: its options, files for its first argument (a scene
/// or a study) and for options with values, and the words in `words` for the options that they belong to. `settings`
/// are lines as assignments() gives them; the script completes the values of --set from these level by level.
std::string bash_completion(const CLI::App& app, const std::map<std::string, std::vector<std::string>>& words,
                            const std::vector<std::string>& settings);

}  // namespace ixos
