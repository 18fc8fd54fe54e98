/// Running the driver as a user does.
#pragma once
#include <string>
#include <vector>

namespace ixos::test {

struct Outcome {
  int status;          ///< exit status, 128 + signal where it was killed
  std::string output;  ///< standard output and standard error
};

/// Runs the ixos driver with these arguments (each one word, quoted here) in `folder`.
Outcome ixos(const std::vector<std::string>& arguments, const std::string& folder);

/// The same of another program.
Outcome program(const std::string& path, const std::vector<std::string>& arguments, const std::string& folder);

/// Runs a shell command in `folder`.
Outcome shell(const std::string& command, const std::string& folder);

/// The driver's path, quoted for the shell.
std::string quoted_driver();

/// A fresh, empty folder.
std::string scratch_folder();

}  // namespace ixos::test
