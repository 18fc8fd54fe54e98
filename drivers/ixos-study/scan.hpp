/// The command ixos-study --scan.
#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace ixos {

struct ScanArguments {
  std::string scene;  ///< empty: no scan is asked for
  std::vector<std::string> varied, quantities;
};

/// Values of the command's other options.
struct ScanSettings {
  std::vector<std::string> assignments;
  std::string output;
  std::string driver;
  int jobs = 1;
  bool overwrite = false;
  bool list = false;
  bool quiet = false;
};

/// Adds --scan and the options that only it has.
void declare_scan(CLI::App& app, ScanArguments& arguments);

/// Returns the folder for the results: `output`, or the scene's name with -scan.results.
std::string scan_folder(const ScanArguments& arguments, const std::string& output);

/// Carries out the scan, or lists its runs, and prints its table. Returns the exit status: 3 if no run has a value.
/// Throws InputError, FileError.
int scan(const ScanArguments& arguments, const ScanSettings& settings);

}  // namespace ixos
