/// The answer to --help, of which the manual pages are made, too.
#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace ixos {

/// Makes a program answer --help with its usage, arguments, options and examples. The answer does not list which
/// options need or exclude which: the message about a wrong command line says so. `examples` has a line for each, a
/// command and what it does, with two or more blanks between; `remark` follows them. help2man finds all of this.
void set_help(CLI::App& app, const std::string& examples, const std::string& remark = "");

}  // namespace ixos
