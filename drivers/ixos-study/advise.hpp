/// ixos-study --advise: the cheapest settings of a scene that keep a tolerance.
#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace ixos {

/// The options of --advise as the user wrote them.
struct AdviceArguments {
  std::string scene;
  std::vector<std::string> quantities;
  std::string tolerance = "1%";
  std::vector<std::string> assignments;
  double budget = 0;
  int jobs = 1;
  bool verify = false;
};

/// Declares the options of --advise.
void declare_advice(CLI::App& app, AdviceArguments& arguments);

/// Returns the results folder of an advice: the option --output, or a name made of that of the scene.
std::string advice_folder(const AdviceArguments& arguments, const std::string& output);

/// Carries the advice out, prints it, and writes its files to a folder. Returns the exit status. Throws InputError and
/// FileError.
int advise(const AdviceArguments& arguments, const std::string& output, const std::string& driver, bool overwrite,
           bool quiet);

}  // namespace ixos
