/// Completion of commands in bash, made from the options of a program.
#pragma once
#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

namespace ixos {

/// Returns a script for bash that completes commands of the program: its options, XML files for its first argument, the
/// words in `words` for the values of the options that they belong to, and folders and files for options of the types
/// FOLDER and FILE. `settings` are lines as assignments() gives them; the script completes the values of --set from
/// these, level by level.
std::string bash_completion(const CLI::App& app, const std::map<std::string, std::vector<std::string>>& words,
                            const std::vector<std::string>& settings);

}  // namespace ixos
